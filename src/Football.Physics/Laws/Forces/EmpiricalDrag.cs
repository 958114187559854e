namespace FootballPhysics.Laws;

/// <summary>Drag with the fitted coefficient, F_D = −½ ρ C_D A |u| u (thesis 2.3, corrected for its missing density).</summary>
internal struct EmpiricalDrag : IAirLaw
{
    private double _k; // ½ ρ A / m, 1/m
    private double _radius;

    // C_D0 is the coefficient at rest, Sp = r|ω|/|u| the spin parameter, c and d are the constants of FittedDrag.
    // C_D |u| ≤ C_D0 |u| + c Sp^d |u|, and Sp^d |u| = (r|ω|)^d |u|^(1−d) ≤ d r|ω| + (1−d)|u|
    public readonly RateBound Bound => new(
        _k * (FittedDrag.AtRest + (FittedDrag.C * (1 - FittedDrag.D))),
        _k * FittedDrag.C * FittedDrag.D * _radius,
        0);

    public void Prepare(Scene scene)
    {
        _k = AirScale.DynamicArea(scene);
        _radius = scene.Ball.Radius;
    }

    // D = ½ ρ C_D A |u| / m
    public readonly double Factor(in AirFlow flow) => _k * flow.FittedDragCoefficient * flow.Speed;
}
