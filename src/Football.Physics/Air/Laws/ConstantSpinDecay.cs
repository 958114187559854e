namespace Football.Physics;

/// <summary>Spin decay with a constant coefficient, T_D = −k ω.</summary>
internal struct ConstantSpinDecay : IAirLaw
{
    private double _k; // k / I, 1/s

    public readonly RateBound Bound => new(0, 0, _k);

    public void Prepare(Scene scene)
    {
        _k = scene.Forces.SpinDecayCoefficient / scene.Ball.MomentOfInertia;
    }

    // ω̇ = −k ω / I
    public readonly double Factor(in AirFlow flow) => _k * flow.SpinRate;
}
