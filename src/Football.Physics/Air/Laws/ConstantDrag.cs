namespace Football.Physics;

/// <summary>Drag with a constant coefficient, F_D = −½ ρ C_D A |u| u.</summary>
internal struct ConstantDrag : IAirLaw
{
    private double _k; // ½ ρ C_D A / m, 1/m

    public readonly RateBound Bound => new(_k, 0, 0);

    public void Prepare(Scene scene)
    {
        _k = AirScale.DynamicArea(scene) * scene.Forces.DragCoefficient;
    }

    // D = ½ ρ C_D A |u| / m
    public readonly double Factor(in AirFlow flow) => _k * flow.Speed;
}
