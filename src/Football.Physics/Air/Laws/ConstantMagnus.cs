namespace Football.Physics;

/// <summary>Magnus force with a constant coefficient, F_M = C_M π ρ r³ (ω × u).</summary>
internal struct ConstantMagnus : IAirLaw
{
    private double _k; // C_M π ρ r³ / m

    public readonly RateBound Bound => new(0, Math.Abs(_k), 0);

    public void Prepare(Scene scene)
    {
        double r = scene.Ball.Radius;
        _k = scene.Forces.MagnusCoefficient * Math.PI * scene.Air.Density * r * r * r / scene.Ball.Mass;
    }

    // L = C_M π ρ r³ |ω| / m
    public readonly double Factor(in AirFlow flow) => _k * flow.SpinRate;
}
