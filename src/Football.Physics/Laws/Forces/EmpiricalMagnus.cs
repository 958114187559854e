using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>Magnus force with the fitted lift coefficient, F_M = ½ ρ C_L A |u|² (ω̂ × û) (thesis 2.8 to 2.10, corrected).</summary>
internal struct EmpiricalMagnus : IAirLaw
{
    /// <summary>The exponent of the spin parameter.</summary>
    public const double Beta = 0.83;

    /// <summary>The factor of the law.</summary>
    public const double Alpha = 1.15;

    /// <summary>1.15 / (C_D0 − a).</summary>
    public static readonly double Scale = Alpha / (FittedDrag.AtRest - FittedDrag.A);

    private static readonly PowerTable PowerBeta = new(Beta);

    private double _k; // ½ ρ A / m, 1/m
    private double _radius;

    // C_L is the lift coefficient, Sp the spin parameter, C_D0 the drag coefficient at rest, and a the constant of FittedDrag.
    // C_L |u| ≤ 1.15 Sp^β |u| = 1.15 (r|ω|)^β |u|^(1−β) ≤ 1.15 (β r|ω| + (1−β)|u|); the quotient of the deficit is at most C_D0/(C_D0 − a).
    public readonly RateBound Bound => new(
        _k * Scale * FittedDrag.AtRest * (1 - Beta),
        _k * Scale * FittedDrag.AtRest * Beta * _radius,
        0);

    /// <summary>Returns 1.15 Sp^β / (C_D0 − a).</summary>
    public static double OfSpin(double spinParameter) => Scale * PowerBeta.Of(spinParameter);

    public void Prepare(Scene scene)
    {
        _k = AirScale.DynamicArea(scene);
        _radius = scene.Ball.Radius;
    }

    // C_L = 1.15 Sp^0.83 (C_D0 − min(C_D, C_D0)) / (C_D0 − a),  L = ½ ρ C_L A |u| / m
    public readonly double Factor(in AirFlow flow)
    {
        double deficit = FittedDrag.AtRest - flow.FittedDragCoefficient;
        return deficit > 0 ? _k * Scale * PowerBeta.Of(flow.SpinParameter) * deficit * flow.Speed : 0;
    }
}
