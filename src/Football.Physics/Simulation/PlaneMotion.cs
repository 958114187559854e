using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Constants of a material, per mass or per moment of inertia.</summary>
internal readonly struct PlaneMaterial(in ContactMaterial of, BallProperties ball)
{
    /// <summary>μ_s.</summary>
    public readonly double Sliding = of.SlidingFriction;

    /// <summary>μ_s/(α r), 1/m: the angular acceleration per load and mass.</summary>
    public readonly double SlidingTorque = of.SlidingFriction / (ball.InertiaFactor * ball.Radius);

    /// <summary>(1 + 1/α) μ_s: the rate at which friction alone ends the slip, per load and mass.</summary>
    public readonly double SlipFriction = (1.0 + (1.0 / ball.InertiaFactor)) * of.SlidingFriction;

    /// <summary>c₀.</summary>
    public readonly double Rolling = of.RollingFriction;

    /// <summary>c₁, s/m.</summary>
    public readonly double RollingBySpeed = of.RollingFrictionBySpeed;

    /// <summary>b μ_s m/I, 1/m.</summary>
    public readonly double Drilling = of.DrillingLength * of.SlidingFriction * ball.Mass / ball.MomentOfInertia;

    /// <summary>c_ω/I, 1/s.</summary>
    public readonly double Damping = of.SpinDamping / ball.MomentOfInertia;
}

/// <summary>Constants of a step.</summary>
internal struct PlaneStart
{
    public Vector3d From;
    public double Time;

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
}

/// <summary>Rates of change of the motion, the load per mass, the squared traction of a roll per mass, and the squared braking of the
/// spin by the air in a slide.</summary>
internal struct PlaneRates
{
    public double AX;
    public double AZ;
    public double BX;
    public double BY;
    public double BZ;
    public double Load;
    public double TractionSquared;
    public double BrakingSquared;
}
