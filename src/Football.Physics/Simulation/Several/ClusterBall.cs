namespace FootballPhysics;

/// <summary>A ball of a cluster that is solved together, in one step of the method.</summary>
internal struct ClusterBall
{
    /// <summary>What it does by itself.</summary>
    public PilePhase Pile;

    /// <summary>What it may meet.</summary>
    public World World;

    /// <summary>1/m, 1/kg; 1/I, 1/(kg m²); r, m.</summary>
    public double PerMass;
    public double PerInertia;
    public double Radius;

    /// <summary>The ball at the step's start and at its end.</summary>
    public BallState Start;
    public BallState End;

    /// <summary>Where it is at a stage, and the rates there: of all but the contacts, and of all.</summary>
    public Motion At;
    public MotionRates Free;
    public MotionRates Rates;

    /// <summary>The rates at the start and at the end; and those of the stages between.</summary>
    public MotionRates First;
    public MotionRates Last;
    public MotionRates SecondRates;
    public MotionRates ThirdRates;
    public Motion Second;
    public Motion Third;

    /// <summary>The contact that rolling resistance and drilling friction belong to; −1 for none.</summary>
    public int Bearer;

    /// <summary>Where it rolls to at the start.</summary>
    public Vector3d Along;

    /// <summary>Which way it spins about the bearer's normal, relative to that; 0 where drilling friction holds that spin.</summary>
    public double SpinSign;

    /// <summary>True when drilling friction holds the spin about the bearer's normal; and what holds it, rad/s².</summary>
    public bool HoldsSpin;
    public double HeldSpin;
}

/// <summary>A contact of a cluster: of one ball with a thing that stands still, or of two balls.</summary>
/// <remarks>Loads and friction of it are forces, N.</remarks>
internal struct ClusterContact
{
    /// <summary>What it is to the first ball.</summary>
    /// <remarks>Of two balls the collider is −1, and rates are those of one relative to the other.</remarks>
    public SetContact On;

    /// <summary>The balls; the second is −1 where there is none.</summary>
    public int First;
    public int Second;

    /// <summary>Gap when it was looked at, m; of a thing only where that bears nothing.</summary>
    public double Gap;

    /// <summary>b μ of two balls, m; which way one turns against the other about the normal, 0 where friction holds them; and the torque, N m.</summary>
    public double Lever;
    public double TwistSign;
    public bool HoldsTwist;
    public double Twist;

    /// <summary>b μ N of two balls that are held, less what holds them, N m.</summary>
    public readonly double TwistGrip => (Lever * On.Load) - Math.Abs(Twist);

    /// <summary>How many unknowns it has.</summary>
    public readonly int Width => On.Width + (On.Bears && HoldsTwist ? 1 : 0);
}

/// <summary>An unknown force of a cluster: what a unit of it does to the balls of its contact, and the condition that it is there for.</summary>
internal struct ClusterRow
{
    /// <summary>The balls; the second is −1 where there is none.</summary>
    public int First;
    public int Second;

    /// <summary>What the condition asks of: the accelerations of both.</summary>
    public Vector3d AlongV;
    public Vector3d AlongW;
    public Vector3d OtherAlongV;
    public Vector3d OtherAlongW;
    public double Asked;

    /// <summary>The accelerations that a unit of force gives both.</summary>
    public Vector3d PushV;
    public Vector3d PushW;
    public Vector3d OtherPushV;
    public Vector3d OtherPushW;

    /// <summary>What drilling friction takes of them where it holds a spin, rad/s².</summary>
    public double Held;
    public double OtherHeld;
}
