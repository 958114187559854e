using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The state of a group of balls that changes in a step: floats, and their rounding errors.</summary>
internal sealed class LaneState
{
    private readonly float[][] _all;

    public LaneState(int size)
    {
        _all = new float[13][];
        for (int i = 0; i < _all.Length; i++)
        {
            _all[i] = new float[size];
        }

        Ux = _all[0];
        Uy = _all[1];
        Uz = _all[2];
        W = _all[3];
        Px = _all[4];
        Py = _all[5];
        Pz = _all[6];
        UxRest = _all[7];
        UyRest = _all[8];
        UzRest = _all[9];
        PxRest = _all[10];
        PyRest = _all[11];
        PzRest = _all[12];
    }

    /// <summary>The velocity relative to the air, in m/s.</summary>
    public float[] Ux { get; }

    public float[] Uy { get; }

    public float[] Uz { get; }

    /// <summary>The magnitude of the spin, in rad/s.</summary>
    public float[] W { get; }

    /// <summary>The displacement relative to the air since the launch, in m.</summary>
    public float[] Px { get; }

    public float[] Py { get; }

    public float[] Pz { get; }

    /// <summary>The negative rounding errors of the sums above (compensated summation).</summary>
    public float[] UxRest { get; }

    public float[] UyRest { get; }

    public float[] UzRest { get; }

    public float[] PxRest { get; }

    public float[] PyRest { get; }

    public float[] PzRest { get; }

    /// <summary>Moves a ball to another slot.</summary>
    [MethodImpl(Hot.Path)]
    public void Move(int from, int to)
    {
        foreach (float[] values in _all)
        {
            values[to] = values[from];
        }
    }

    /// <summary>Copies a ball from another state.</summary>
    [MethodImpl(Hot.Path)]
    public void Take(LaneState other, int from, int to)
    {
        float[][] theirs = other._all;
        for (int i = 0; i < _all.Length; i++)
        {
            _all[i][to] = theirs[i][from];
        }
    }

    /// <summary>Initializes a ball at its launch.</summary>
    [MethodImpl(Hot.Path)]
    public void Launch(int at, in Vector3d u, double spinRate)
    {
        Ux[at] = (float)u.X;
        Uy[at] = (float)u.Y;
        Uz[at] = (float)u.Z;
        UxRest[at] = (float)(Ux[at] - u.X);
        UyRest[at] = (float)(Uy[at] - u.Y);
        UzRest[at] = (float)(Uz[at] - u.Z);
        W[at] = (float)spinRate;
        Px[at] = 0;
        Py[at] = 0;
        Pz[at] = 0;
        PxRest[at] = 0;
        PyRest[at] = 0;
        PzRest[at] = 0;
    }

    public Vector3d Velocity(int at) => new((double)Ux[at] - UxRest[at], (double)Uy[at] - UyRest[at], (double)Uz[at] - UzRest[at]);

    public Vector3d Path(int at) => new((double)Px[at] - PxRest[at], (double)Py[at] - PyRest[at], (double)Pz[at] - PzRest[at]);
}
