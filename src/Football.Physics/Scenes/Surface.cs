using System.Text.Json.Serialization;

namespace Football.Physics;

/// <summary>What a thing that can be hit is made of: how the ball bounces off it, slides and rolls on it.</summary>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Surface
{
    /// <summary>Normal restitution e. 0 … 1; default 0.7. Where <see cref="RestitutionSpeed"/> is finite, that at 6 m/s.</summary>
    public double NormalRestitution { get; init; } = 0.7;

    /// <summary>Approach speed V_e at which restitution has fallen, e ∝ 1/√(1 + (v_n/V_e)²), m/s. Above 0; default infinite: the same at every speed.</summary>
    public double RestitutionSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Tangential restitution e_t: where the contact grips, the slip after is −e_t times the slip before. −1 … 1; default 0.3.</summary>
    public double TangentialRestitution { get; init; } = 0.3;

    /// <summary>Restitution of the spin about the normal, e_ω. 0 … 1; default 0.8.</summary>
    public double SpinRestitution { get; init; } = 0.8;

    /// <summary>Coefficient of friction of an impact μ: the tangential impulse is at most μ times the normal one. Not negative; infinite is no limit; default 0.3.</summary>
    public double ImpactFriction { get; init; } = 0.3;

    /// <summary>Coefficient of sliding friction μ_s. Not negative; default 0.3.</summary>
    public double SlidingFriction { get; init; } = 0.3;

    /// <summary>Coefficient of rolling friction μ_r. Not negative; default 0.05.</summary>
    public double RollingFriction { get; init; } = 0.05;

    /// <summary>What rolling friction gains by speed, c₁, s/m. Not negative; default 0.</summary>
    public double RollingFrictionBySpeed { get; init; }

    /// <summary>Damping c_ω of the spin about the normal of a ball that is carried, N m s. Not negative; default 0.002.</summary>
    public double SpinDamping { get; init; } = 0.002;

    /// <summary>Lever b of the drilling friction about the normal, which takes b μ_s of the normal force as torque, m. Not negative; default 0.</summary>
    public double DrillingLength { get; init; }

    /// <summary>The frame of a goal.</summary>
    public static Surface GoalFrame { get; } = new();

    /// <summary>The frame of a goal in the measured profile: steel or aluminium. Evidence: guess (others' priors for e₆ are 0.65 … 0.80).</summary>
    public static Surface MeasuredFrame { get; } = new()
    {
        NormalRestitution = 0.80,
        RestitutionSpeed = 30,
        TangentialRestitution = 0.10,
        SpinRestitution = 1,
        SpinDamping = 0,
    };

    /// <summary>Checks every number.</summary>
    /// <param name="field">What the surface belongs to.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    internal void Validate(string field)
    {
        Check.Within(field + ".normalRestitution", NormalRestitution, 0, 1);
        Check.Within(field + ".restitutionSpeed", RestitutionSpeed, 0, double.PositiveInfinity, exclusiveLow: true);
        Check.Within(field + ".tangentialRestitution", TangentialRestitution, -1, 1);
        Check.Within(field + ".spinRestitution", SpinRestitution, 0, 1);
        Check.Within(field + ".impactFriction", ImpactFriction, 0, double.PositiveInfinity);
        Check.NotNegative(field + ".slidingFriction", SlidingFriction);
        Check.NotNegative(field + ".rollingFriction", RollingFriction);
        Check.NotNegative(field + ".rollingFrictionBySpeed", RollingFrictionBySpeed);
        Check.NotNegative(field + ".spinDamping", SpinDamping);
        Check.NotNegative(field + ".drillingLength", DrillingLength);
    }
}
