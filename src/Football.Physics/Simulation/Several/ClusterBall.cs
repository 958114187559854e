using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>A ball of a cluster that is solved as one system, in one step of the integrator.</summary>
internal struct ClusterBall
{
    /// <summary>The stepper of the single ball.</summary>
    public PilePhase Pile;

    /// <summary>The world of the ball.</summary>
    public World World;

    /// <summary>1/m, 1/kg; 1/I, 1/(kg m²); r, m.</summary>
    public double PerMass;
    public double PerInertia;
    public double Radius;

    /// <summary>The ball at the start and at the end of the step.</summary>
    public BallState Start;
    public BallState End;

    /// <summary>The motion at a stage, and the rates at that stage, without and with contacts.</summary>
    public Motion At;
    public MotionRates Free;
    public MotionRates Rates;

    /// <summary>The rates at the start, at the end, and at the stages between.</summary>
    public MotionRates First;
    public MotionRates Last;
    public MotionRates SecondRates;
    public MotionRates ThirdRates;
    public Motion Second;
    public Motion Third;

    /// <summary>The contact at which rolling resistance and drilling friction act; −1 for none.</summary>
    public int Bearer;

    /// <summary>The direction of its roll at the start.</summary>
    public Vector3d Along;

    /// <summary>Sign of its spin about the bearer's normal, relative to the bearer; 0 if drilling friction holds that spin.</summary>
    public double SpinSign;

    /// <summary>True if drilling friction holds the spin about the bearer's normal, and the holding torque, rad/s².</summary>
    public bool HoldsSpin;
    public double HeldSpin;
}

/// <summary>A contact of a cluster: of a ball with a stationary object, or of two balls.</summary>
/// <remarks>Its loads and friction are forces, N.</remarks>
internal struct ClusterContact
{
    /// <summary>The contact as seen from the first ball.</summary>
    /// <remarks>For two balls the collider is −1, and rates are relative to the second ball.</remarks>
    public SetContact On;

    /// <summary>The balls; the second is −1 if there is none.</summary>
    public int First;
    public int Second;

    /// <summary>Gap at the last update, m; for an object, only if it has no load.</summary>
    public double Gap;

    /// <summary>For two balls: b μ, m; the sign of the relative spin about the normal, 0 if friction holds it; and the torque, N
    /// m.</summary>
    public double Lever;
    public double TwistSign;
    public bool HoldsTwist;
    public double Twist;

    /// <summary>b μ N minus the holding torque, for two balls whose relative spin is held, N m.</summary>
    public readonly double TwistGrip => (Lever * On.Load) - Math.Abs(Twist);

    /// <summary>Number of unknowns of the contact.</summary>
    public readonly int Width => On.Width + (On.Bears && HoldsTwist ? 1 : 0);
}

/// <summary>An unknown force of a cluster: the response of the balls to a unit of it, and the condition that determines it.</summary>
internal struct ClusterRow
{
    /// <summary>The balls; the second is −1 if there is none.</summary>
    public int First;
    public int Second;

    /// <summary>The coefficients of both balls' accelerations in the condition.</summary>
    public Vector3d AlongV;
    public Vector3d AlongW;
    public Vector3d OtherAlongV;
    public Vector3d OtherAlongW;
    public double Target;

    /// <summary>The accelerations of both balls by a unit force.</summary>
    public Vector3d PushV;
    public Vector3d PushW;
    public Vector3d OtherPushV;
    public Vector3d OtherPushW;

    /// <summary>The part of these that drilling friction takes if it holds a spin, rad/s².</summary>
    public double Held;
    public double OtherHeld;
}
