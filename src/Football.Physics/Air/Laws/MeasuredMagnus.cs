using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Lift of the measured laws alone, by <see cref="SaturatingLift"/>.</summary>
internal struct MeasuredMagnus : IAirLaw
{
    private MeasuredLaw _law;

    public readonly bool Acts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool NeedsFit
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool NeedsSpeed
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly RateBound Bound => _law.LiftBound;

    public void Prepare(Scene scene) => _law.Prepare(scene);

    public readonly double Factor(in AirFlow flow)
    {
        _law.At(in flow, out _, out double lift, out _);
        return lift;
    }
}
