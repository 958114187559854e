namespace Football.Physics;

/// <summary>Lift of the measured laws alone, by <see cref="SaturatingLift"/>.</summary>
internal struct MeasuredMagnus : IAirLaw
{
    private MeasuredLaw _law;

    public readonly RateBound Bound => _law.LiftBound;

    public void Prepare(Scene scene) => _law.Prepare(scene);

    public readonly double Factor(in AirFlow flow)
    {
        _law.At(in flow, out _, out double lift, out _);
        return lift;
    }
}
