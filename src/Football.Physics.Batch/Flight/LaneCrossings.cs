using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The balls that cross the jump in the drag law in a step, packed to fill SIMD registers.</summary>
internal sealed class LaneCrossings
{
    public LaneCrossings(int size)
    {
        Now = new LaneState(size);
        Middle = new LaneState(size);
        Next = new LaneState(size);
        Share = new float[size];
        Nx = new float[size];
        Ny = new float[size];
        Nz = new float[size];
        Inside = new float[size];
        InsideAfter = new float[size];
        Astray = new float[size];
    }

    public LaneState Now { get; }

    /// <summary>The state at the jump.</summary>
    public LaneState Middle { get; }

    public LaneState Next { get; }

    /// <summary>The fraction of the step before the jump, 0 … 1.</summary>
    public float[] Share { get; }

    public float[] Nx { get; }

    public float[] Ny { get; }

    public float[] Nz { get; }

    /// <summary>Masks: the branch of the drag law before and after the step.</summary>
    public float[] Inside { get; }

    public float[] InsideAfter { get; }

    /// <summary>Mask: balls that ended on the side of the jump that they came from.</summary>
    public float[] Astray { get; }

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
