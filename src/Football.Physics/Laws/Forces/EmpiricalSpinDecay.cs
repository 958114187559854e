using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>Spin decay by skin friction on two plates (Tuplin; thesis 2.11 to 2.15, with |U±|).</summary>
internal struct EmpiricalSpinDecay : IAirLaw
{
    /// <summary>The exponent of the Reynolds number in the skin friction of a plate, C = 0.0074 Re^(−0.2), as published.</summary>
    public const decimal ReynoldsExponent = 0.2m;

    /// <summary>The exponent of a plate's speed in the torque, U² C ∝ U^1.8.</summary>
    public const decimal SpeedExponent = 2m - ReynoldsExponent;

    /// <summary>The factor of the skin friction.</summary>
    public const double SkinFriction = 0.0074;

    private static readonly PowerTable SpeedPower = new((double)SpeedExponent);

    private double _k; // (r/2) ρ π r² 0.0074 (2r/ν)^(−0.2) / I
    private double _halfRadius;

    /// <remarks>
    /// Near zero spin, the torque on a moving ball does not vanish; a separate check prevents a reversal of the spin. Otherwise the torque changes with the
    /// spin by 1.8 k r/2 (U₊^0.8 ± U₋^0.8), less than 3.6 k r/2 U^0.8 with U = |u| + r|ω|/2, and U^0.8 is less than 0.8 U + 0.2.
    /// </remarks>
    public readonly RateBound Bound => new(2.88 * _k * _halfRadius, 2.88 * _k * _halfRadius * _halfRadius, 0.72 * _k * _halfRadius);

    /// <summary>The angular deceleration by one plate at 1 m/s, in rad/s².</summary>
    public readonly double Plate => _k;

    /// <summary>Returns |u|^1.8.</summary>
    public static double OfSpeed(double speed) => SpeedPower.Of(speed);

    /// <summary>Returns the sum of both plates divided by |u|^1.8: (1 + Sp/2)^1.8 + |1 − Sp/2|^1.8.</summary>
    public static double OfSpin(double spinParameter)
    {
        double plate = 0.5 * spinParameter;
        return SpeedPower.Of(1.0 + plate) + SpeedPower.Of(Math.Abs(1.0 - plate));
    }

    public void Prepare(Scene scene)
    {
        double r = scene.Ball.Radius;
        _halfRadius = 0.5 * r;
        _k = 0.5 * r * scene.Air.Density * Math.PI * r * r * SkinFriction
            * Elementary.Pow(2.0 * r / scene.Air.KinematicViscosity, -(double)ReynoldsExponent) / scene.Ball.MomentOfInertia;
    }

    // T_D is the torque of the air. U₊ and U₋ are the speeds of the two sides of the ball, C₊ and C₋ their friction coefficients, ν is the viscosity.
    // T_D = (r/2) ρ π r² (U₊² C₊ + U₋² C₋), U± = abs(|u| ± r|ω|/2), C± = 0.0074 (U± 2r/ν)^(−0.2), so U² C ∝ U^1.8
    public readonly double Factor(in AirFlow flow)
    {
        double plate = _halfRadius * flow.SpinRate;
        return _k * (SpeedPower.Of(flow.Speed + plate) + SpeedPower.Of(Math.Abs(flow.Speed - plate)));
    }
}
