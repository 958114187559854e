using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The fitted C_D as published: with spin where |u| &gt; v_c and Sp &gt; 0.05, without elsewhere. It jumps between them.</summary>
internal readonly struct PublishedDragFit : IDragFit
{
    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Coefficient(in AirFlow flow, DragBranch branch) =>
        branch == DragBranch.Spinning ? FittedDrag.WithSpin(flow.SpinParameter) : FittedDrag.WithoutSpin(flow.Speed);
}
