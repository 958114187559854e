using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>For scenes in which no law asks for the fitted C_D.</summary>
internal readonly struct NoDragFit : IDragFit
{
    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Coefficient(in AirFlow flow, DragBranch branch) => 0;
}
