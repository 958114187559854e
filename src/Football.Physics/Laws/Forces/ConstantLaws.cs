namespace FootballPhysics.Laws;

/// <summary>Drag with a constant coefficient, F_D = −½ ρ C_D A |u| u.</summary>
internal struct ConstantDrag : IAirLaw
{
    private double _k; // ½ ρ C_D A / m, 1/m

    public readonly RateBound Bound => new(_k, 0, 0);

    /// <summary>½ ρ C_D A / m, 1/m.</summary>
    public static double Scale(Scene scene) => AirScale.DynamicArea(scene) * scene.Forces.DragCoefficient;

    public void Prepare(Scene scene) => _k = Scale(scene);

    // D = ½ ρ C_D A |u| / m
    public readonly double Factor(in AirFlow flow) => _k * flow.Speed;
}

/// <summary>Magnus force with a constant coefficient, F_M = C_M π ρ r³ (ω × u).</summary>
internal struct ConstantMagnus : IAirLaw
{
    private double _k; // C_M π ρ r³ / m

    public readonly RateBound Bound => new(0, Math.Abs(_k), 0);

    /// <summary>C_M π ρ r³ / m.</summary>
    public static double Scale(Scene scene)
    {
        double r = scene.Ball.Radius;
        return scene.Forces.MagnusCoefficient * Math.PI * scene.Air.Density * r * r * r / scene.Ball.Mass;
    }

    public void Prepare(Scene scene) => _k = Scale(scene);

    // L = C_M π ρ r³ |ω| / m
    public readonly double Factor(in AirFlow flow) => _k * flow.SpinRate;
}

/// <summary>Spin decay with a constant coefficient, T_D = −k ω.</summary>
internal struct ConstantSpinDecay : IAirLaw
{
    private double _k; // k / I, 1/s

    public readonly RateBound Bound => new(0, 0, _k);

    /// <summary>k / I, 1/s.</summary>
    public static double Scale(Scene scene) => scene.Forces.SpinDecayCoefficient / scene.Ball.MomentOfInertia;

    public void Prepare(Scene scene) => _k = Scale(scene);

    // ω̇ = −k ω / I
    public readonly double Factor(in AirFlow flow) => _k * flow.SpinRate;
}
