namespace Football.Physics;

/// <summary>Drag of the measured laws alone, F_D = −½ ρ A C_D |u| u by <see cref="ReynoldsDrag"/> and <see cref="SpinDrag"/>.</summary>
internal struct MeasuredDrag : IAirLaw
{
    private MeasuredLaw _law;

    public readonly RateBound Bound => _law.DragBound(2.0 * Limits.Speed);

    public void Prepare(Scene scene) => _law.Prepare(scene);

    public readonly double Factor(in AirFlow flow)
    {
        _law.At(in flow, out double drag, out _, out _);
        return drag;
    }
}
