namespace Football.Physics;

/// <summary>The balls that cross the drag law's jump in a step, side by side, so that registers are full of them.</summary>
internal sealed class LaneSplit
{
    public LaneSplit(int size)
    {
        Now = new LaneState(size);
        Next = new LaneState(size);
        Nx = new float[size];
        Ny = new float[size];
        Nz = new float[size];
        Inside = new float[size];
        InsideAfter = new float[size];
    }

    public LaneState Now { get; }

    public LaneState Next { get; }

    public float[] Nx { get; }

    public float[] Ny { get; }

    public float[] Nz { get; }

    /// <summary>Masks: the drag law's branch before and after the step.</summary>
    public float[] Inside { get; }

    public float[] InsideAfter { get; }

    /// <summary>Takes a ball out of its group.</summary>
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
