using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A force or torque that is left out: no code remains of it.</summary>
internal struct NoAirLaw : IAirLaw
{
    public readonly bool Acts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool NeedsFit
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool NeedsSpeed
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly RateBound Bound => default;

    public readonly void Prepare(Scene scene)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double Factor(in AirFlow flow) => 0;
}
