using System.Text.Json.Serialization;

namespace Football.Physics;

/// <summary>A material: how the ball bounces off a thing made of it, slides and rolls on it. Its numbers are those of <see cref="GoalFrame"/> by default.</summary>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Surface
{
    /// <summary>The greatest restitution of an object.</summary>
    private const double MostRestitution = 3;

    /// <summary>Normal restitution e. 0 … 3; above 1 a bumper, which adds energy; at most 1 between balls and in a pattern of the ground. That at an approach of 6 m/s where <see cref="RestitutionSpeed"/> is finite. Default 0.8.</summary>
    public double NormalRestitution { get; init; } = 0.8;

    /// <summary>Approach speed V_e at which restitution has fallen, e ∝ 1/√(1 + (v_n/V_e)²), m/s. Above 0; infinite for the same at every speed; default 30.</summary>
    public double RestitutionSpeed { get; init; } = 30;

    /// <summary>Rise η of restitution with obliqueness, as in <see cref="Ground.RestitutionRise"/>. 0 … 1; default 0.</summary>
    public double RestitutionRise { get; init; }

    /// <summary>Tangential restitution e_t: where the contact grips, the slip after is −e_t times the slip before. −1 … 1; default 0.1.</summary>
    public double TangentialRestitution { get; init; } = 0.1;

    /// <summary>Restitution of the spin about the normal, e_ω. 0 … 1; default 1.</summary>
    public double SpinRestitution { get; init; } = 1;

    /// <summary>
    /// The least speed with which the ball leaves an impact along the normal, relative to the surface, m/s: a bumper of a pinball. 0 … 1000; default 0. A ball that lands on top slower than
    /// <see cref="Ground.MinimumBounceSpeed"/> stays down all the same. Between balls, and in a pattern of the ground, it is 0.
    /// </summary>
    public double MinimumExitSpeed { get; init; }

    /// <summary>Coefficient of friction of an impact μ: the tangential impulse is at most μ times the normal one. Not negative; infinite is no limit; default 0.3.</summary>
    public double ImpactFriction { get; init; } = 0.3;

    /// <summary>Coefficient of sliding friction μ_s. 0 … 10; default 0.3.</summary>
    public double SlidingFriction { get; init; } = 0.3;

    /// <summary>Coefficient of rolling friction μ_r. 0 … 10; default 0.05.</summary>
    public double RollingFriction { get; init; } = 0.05;

    /// <summary>Growth of rolling friction with speed, c₁, s/m. 0 … 1; default 0.</summary>
    public double RollingFrictionBySpeed { get; init; }

    /// <summary>Damping c_ω of the spin about the normal of a ball that is carried, N m s. 0 … 1, at most 1e5 1/s times the moment of inertia; default 0.</summary>
    public double SpinDamping { get; init; }

    /// <summary>Lever b of the drilling friction about the normal, which takes b μ_s of the normal force as torque, m. 0 … 1; default 0.</summary>
    public double DrillingLength { get; init; }

    /// <summary>The frame of a goal: steel or aluminium. Restitution 0.80 at 6 m/s. Evidence: guess (others' priors for e₆ are 0.65 … 0.80).</summary>
    public static Surface GoalFrame { get; } = new();

    /// <summary>The frame of a goal in the published profile: restitution 0.7 at every speed. Evidence: guess.</summary>
    public static Surface PublishedGoalFrame { get; } = new()
    {
        NormalRestitution = 0.7,
        RestitutionSpeed = double.PositiveInfinity,
        TangentialRestitution = 0.3,
        SpinRestitution = 0.8,
        SpinDamping = 0.002,
    };

    /// <summary>Wooden boards round a pitch. Evidence: guess (stiffer than a panel of plastic, softer than concrete).</summary>
    public static Surface Wood { get; } = PublishedGoalFrame with { NormalRestitution = 0.65, ImpactFriction = 0.4, SlidingFriction = 0.4, RollingFriction = 0.02 };

    /// <summary>Advertising boards: thin panels that give. Evidence: guess.</summary>
    public static Surface Board { get; } = PublishedGoalFrame with { NormalRestitution = 0.5, ImpactFriction = 0.35, SlidingFriction = 0.35, RollingFriction = 0.03 };

    /// <summary>Concrete. Evidence: e measured (a test ball rises to 1.35 ± 0.03 m from 2 m, EN 12235); the rest guess.</summary>
    public static Surface Concrete { get; } = PublishedGoalFrame with
    {
        NormalRestitution = 0.82,
        TangentialRestitution = 0.2,
        ImpactFriction = 0.8,
        SlidingFriction = 0.6,
        RollingFriction = 0.013,
    };

    /// <summary>A boot, or a leg: leather on a limb that gives. Evidence: guess (e of kicks is measured at 0.4 … 0.7 with the foot's mass taken in).</summary>
    public static Surface Boot { get; } = PublishedGoalFrame with { NormalRestitution = 0.5, TangentialRestitution = 0.1, ImpactFriction = 0.5, SlidingFriction = 0.5 };

    /// <summary>A head. Evidence: guess.</summary>
    public static Surface Head { get; } = PublishedGoalFrame with { NormalRestitution = 0.45, TangentialRestitution = 0.1, ImpactFriction = 0.5, SlidingFriction = 0.5 };

    /// <summary>A keeper's glove: soft, and it grips. Evidence: guess.</summary>
    public static Surface Glove { get; } = PublishedGoalFrame with { NormalRestitution = 0.25, TangentialRestitution = 0, ImpactFriction = 1, SlidingFriction = 0.9, RollingFriction = 0.1 };

    /// <summary>A football that another football hits. No measurement was found. Evidence: guess (two shells of air bounce about as one off a floor).</summary>
    public static Surface Ball { get; } = new()
    {
        NormalRestitution = 0.78,
        TangentialRestitution = 0,
        ImpactFriction = 0.4,
        SlidingFriction = 0.4,
    };

    /// <summary>Makes the material of a pitch, for a thing of the same: a bank of turf, a ramp.</summary>
    /// <param name="ground">The pitch; of its two tangential restitutions that along x counts.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ground"/> is null.</exception>
    public static Surface Of(Ground ground)
    {
        Check.Given(nameof(ground), ground);

        // A thing has one tangential restitution: that along x is taken.
        return new Surface
        {
            NormalRestitution = ground.NormalRestitution,
            RestitutionSpeed = ground.RestitutionSpeed,
            RestitutionRise = ground.RestitutionRise,
            TangentialRestitution = ground.TangentialRestitutionX,
            SpinRestitution = ground.SpinRestitution,
            ImpactFriction = ground.ImpactFriction,
            SlidingFriction = ground.SlidingFriction,
            RollingFriction = ground.RollingFriction,
            RollingFrictionBySpeed = ground.RollingFrictionBySpeed,
            SpinDamping = ground.SpinDamping,
            DrillingLength = ground.DrillingLength,
        };
    }

    /// <summary>Checks every number.</summary>
    /// <param name="field">What the surface belongs to.</param>
    /// <param name="mostDamping">The most that may damp a spin of the ball, N m s.</param>
    /// <param name="mayAdd">Whether it may add energy: objects may, balls and the ground may not.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    internal void Validate(string field, double mostDamping = 1, bool mayAdd = true)
    {
        Check.Within(field + ".normalRestitution", NormalRestitution, 0, mayAdd ? MostRestitution : 1);
        Check.Within(field + ".minimumExitSpeed", MinimumExitSpeed, 0, mayAdd ? Limits.Speed : 0);
        Check.Within(field + ".restitutionSpeed", RestitutionSpeed, 0, double.PositiveInfinity, exclusiveLow: true);
        Check.Within(field + ".restitutionRise", RestitutionRise, 0, 1);
        Check.Within(field + ".tangentialRestitution", TangentialRestitution, -1, 1);
        Check.Within(field + ".spinRestitution", SpinRestitution, 0, 1);
        Check.Within(field + ".impactFriction", ImpactFriction, 0, double.PositiveInfinity);
        Check.Within(field + ".slidingFriction", SlidingFriction, 0, 10);
        Check.Within(field + ".rollingFriction", RollingFriction, 0, 10);
        Check.Within(field + ".rollingFrictionBySpeed", RollingFrictionBySpeed, 0, 1);
        Check.Within(field + ".spinDamping", SpinDamping, 0, mostDamping);
        Check.Within(field + ".drillingLength", DrillingLength, 0, 1);
    }
}
