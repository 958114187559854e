using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Constants of a material, per mass or per moment of inertia.</summary>
internal readonly struct PlaneMaterial(in ContactMaterial of, BallProperties ball)
{
    /// <summary>μ_s.</summary>
    public readonly double Sliding = of.Resistance.Sliding;

    /// <summary>μ_s/(α r), 1/m: the angular acceleration per load and mass.</summary>
    public readonly double SlidingTorque = of.Resistance.Sliding / (ball.InertiaFactor * ball.Radius);

    /// <summary>(1 + 1/α) μ_s: the rate at which friction alone ends the slip, per load and mass.</summary>
    public readonly double SlipFriction = (1.0 + (1.0 / ball.InertiaFactor)) * of.Resistance.Sliding;

    /// <summary>c₀.</summary>
    public readonly double Rolling = of.Resistance.Rolling;

    /// <summary>c₁, s/m.</summary>
    public readonly double RollingBySpeed = of.Resistance.RollingBySpeed;

    /// <summary>b μ_s m/I, 1/m.</summary>
    public readonly double Drilling = of.Resistance.Drilling * ball.Mass / ball.MomentOfInertia;

    /// <summary>c_ω/I, 1/s.</summary>
    public readonly double Damping = of.Resistance.Damping / ball.MomentOfInertia;
}

/// <summary>The axes of a plane: x and z along the plane, y along its normal. On level ground, they are the world axes.</summary>
internal readonly struct PlaneAxes
{
    public readonly bool IsLevel;
    public readonly Vector3d X;
    public readonly Vector3d Normal;
    public readonly Vector3d Z;

    public PlaneAxes(Ground ground)
    {
        IsLevel = ground.IsLevel;
        Normal = ground.Normal.Normalized();
        Vector3d along = Math.Abs(Normal.X) < 0.9 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
        X = (along - (Vector3d.Dot(in along, in Normal) * Normal)).Normalized();
        Z = Vector3d.Cross(in X, in Normal);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3d InWorld(double x, double y, double z) => IsLevel ? new Vector3d(x, y, z) : (x * X) + (y * Normal) + (z * Z);
}

/// <summary>Constants of a step.</summary>
internal struct PlaneStart
{
    public Vector3d From;
    public double Time;

    /// <summary>Speed of the roll or the slip at the start, m/s.</summary>
    public double Size;

    /// <summary>Direction of the roll or the slip at the start. Friction keeps this direction if a stage passes zero.</summary>
    public double X;
    public double Z;

    /// <summary>Sign of the spin about the normal. Drilling friction keeps this sign.</summary>
    public double SpinSign;
    public DragBranch Branch;
}

/// <summary>Compile-time choice between rolling and sliding.</summary>
internal interface ISurfaceMotion { bool Rolls { get; } }

internal readonly struct PlaneRoll : ISurfaceMotion
{
    public bool Rolls => true;
}

internal readonly struct PlaneSlide : ISurfaceMotion
{
    public bool Rolls => false;
}

/// <summary>Velocity and spin in the plane's axes: x and z along the plane, y along its normal.</summary>
internal struct PlaneMotion
{
    public double VX;
    public double VZ;
    public double WX;
    public double WY;
    public double WZ;

    public readonly Vector3d Spin => new(WX, WY, WZ);

    public readonly double SpinSquared => (WX * WX) + (WY * WY) + (WZ * WZ);
}

/// <summary>The acceleration along the plane, m/s². Two numbers are returned in registers, so that the next stage does not wait for memory.</summary>
internal readonly struct PlaneAcceleration(double x, double z)
{
    public readonly double X = x;
    public readonly double Z = z;
}

/// <summary>The rate of change of the spin, the load per mass, the squared traction of a roll per mass, and the squared braking of the
/// spin by the air in a slide.</summary>
internal struct PlaneRates
{
    public double BX;
    public double BY;
    public double BZ;
    public double Load;
    public double TractionSquared;
    public double BrakingSquared;
}

/// <summary>A step to its end: the motion there, the means of the motion, and the last stage of the integrator.</summary>
internal struct PlaneMotionStep
{
    /// <summary>The motion at the end.</summary>
    public PlaneMotion End;

    /// <summary>The velocity that moves the ball, and the spin that turns it.</summary>
    public PlaneMotion Mean;

    /// <summary>The motion at the last stage, its load and its squared traction.</summary>
    public PlaneMotion Stage;
    public double Load;
    public double TractionSquared;
}
