using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The balls that cross the jump in the drag law in a step, packed to fill SIMD registers.</summary>
internal sealed class LaneCrossings(int size)
{
    public LaneState Now { get; } = new(size);

    /// <summary>The state at the jump.</summary>
    public LaneState Middle { get; } = new(size);

    public LaneState Next { get; } = new(size);

    /// <summary>The fraction of the step before the jump, 0 … 1.</summary>
    public float[] Share { get; } = new float[size];

    public float[] Nx { get; } = new float[size];

    public float[] Ny { get; } = new float[size];

    public float[] Nz { get; } = new float[size];

    /// <summary>Masks: the branch of the drag law before and after the step.</summary>
    public float[] Inside { get; } = new float[size];

    public float[] InsideAfter { get; } = new float[size];

    /// <summary>Mask: balls that ended on the side of the jump that they came from.</summary>
    public float[] Astray { get; } = new float[size];

    /// <summary>Copies a ball from its group.</summary>
    [MethodImpl(Hot.Path)]
    public void Take(LaneGroup group, int from, int to)
    {
        Now.Take(group.Now, from, to);
        Next.Take(group.Next, from, to);
        Nx[to] = group.Nx[from];
        Ny[to] = group.Ny[from];
        Nz[to] = group.Nz[from];
        Inside[to] = group.Inside[from];
        InsideAfter[to] = group.InsideAfter[from];
    }
}
