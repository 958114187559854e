using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>A group of balls in flight, and the ends of their flights. It fits into the first-level cache.</summary>
internal sealed class LaneGroup
{
    /// <summary>The number of balls in a group.</summary>
    public const int Size = 256;

    /// <summary>The array length, with space for the widest register after the last ball.</summary>
    private const int Room = Size + 16;

    /// <summary>The maximum number of jump crossings: into the branch with spin, out of it while slowing down, and into it while falling.</summary>
    private const int MostCrossings = 3;

    private LaneState _now = new(Room);
    private LaneState _next = new(Room);

    /// <summary>Observes the group after every step; null for none.</summary>
    public LaneWatch? Watch;

    /// <summary>The number of balls in flight; they occupy the first slots.</summary>
    public int Flying;

    /// <summary>The ball of the group in each slot.</summary>
    public readonly int[] Ball = new int[Size];

    /// <summary>The unit axis of the spin.</summary>
    public readonly float[] Nx = new float[Room];
    public readonly float[] Ny = new float[Room];
    public readonly float[] Nz = new float[Room];

    /// <summary>The limit along y, in m.</summary>
    /// <remarks>A flight ends when y, including the wind's <see cref="Drift"/> times the time, falls below it.</remarks>
    public readonly float[] Limit = new float[Room];
    public readonly float[] Drift = new float[Room];

    /// <summary>Mask: the branch with spin holds.</summary>
    public readonly float[] Inside = new float[Room];

    /// <summary>Mask: the branch with spin holds after the step.</summary>
    public readonly float[] InsideAfter = new float[Room];

    /// <summary>Mask: the jump in the drag law was near at the end of the step.</summary>
    public readonly float[] Near = new float[Room];

    /// <summary>The number of jump crossings of each ball.</summary>
    public readonly int[] Crossings = new int[Size];

    /// <summary>The slots whose balls crossed the jump in this step, and copies of these balls.</summary>
    public readonly int[] Crossing = new int[Size];
    public int CrossingCount;
    public readonly LaneCrossings Crossed = new(Room);

    /// <summary>The slots whose balls ended in the last step, in ascending order.</summary>
    public readonly int[] Ended = new int[Size];
    public int EndedCount;

    /// <summary>The slots whose balls reached their highest point in the last step.</summary>
    public readonly int[] Topped = new int[Size];
    public int ToppedCount;

    /// <summary>For each ball: the greatest y of its path, including the wind's drift, in m.</summary>
    public readonly double[] Apex = new double[Size];

    /// <summary>For each ball: the end time of its flight, in s.</summary>
    public readonly double[] EndTime = new double[Size];

    /// <summary>For each ball: true if it left the lanes early.</summary>
    /// <remarks>Either it grazes the jump or slides along it, or the observer needs no more.</remarks>
    public readonly bool[] GivenUp = new bool[Size];

    /// <summary>For each ball: true if it ended at its limit.</summary>
    public readonly bool[] Reached = new bool[Size];

    /// <summary>For each ball at the end: displacement relative to the air, velocity relative to the air, and spin magnitude.</summary>
    public readonly Vector3d[] EndPath = new Vector3d[Size];
    public readonly Vector3d[] EndVelocity = new Vector3d[Size];
    public readonly double[] EndSpin = new double[Size];

    /// <summary>The state before the step.</summary>
    public LaneState Now => _now;

    /// <summary>The state after the step.</summary>
    public LaneState Next => _next;

    /// <summary>Removes all balls.</summary>
    public void Clear()
    {
        Flying = 0;
        EndedCount = 0;
        ToppedCount = 0;
        CrossingCount = 0;
    }

    /// <summary>Adds a ball.</summary>
    /// <param name="ball">The index of the ball in the group.</param>
    /// <param name="u">The velocity relative to the air.</param>
    /// <param name="axis">The unit axis of the spin.</param>
    /// <param name="spinRate">The magnitude of the spin.</param>
    /// <param name="limit">The y at which the flight ends.</param>
    /// <param name="drift">The speed of the wind along y.</param>
    [MethodImpl(Hot.Path)]
    public void Add(int ball, in Vector3d u, in Vector3d axis, double spinRate, double limit, double drift)
    {
        int at = Flying++;
        Ball[at] = ball;
        _now.Launch(at, in u, spinRate);
        Nx[at] = (float)axis.X;
        Ny[at] = (float)axis.Y;
        Nz[at] = (float)axis.Z;
        Limit[at] = (float)limit;
        Drift[at] = (float)drift;
        Inside[at] = 0;
        Crossings[at] = 0;
        Apex[ball] = 0;
        GivenUp[ball] = false;
    }

    /// <summary>Makes the end of a step the start of the next.</summary>
    public void Swap() => (_now, _next) = (_next, _now);

    /// <summary>Stores the end of a flight.</summary>
    public void End(int at, double time, bool reached, in Vector3d path, in Vector3d velocity, double spin)
    {
        int ball = Ball[at];
        EndTime[ball] = time;
        Reached[ball] = reached;
        EndPath[ball] = path;
        EndVelocity[ball] = velocity;
        EndSpin[ball] = spin;
    }

    /// <summary>Collects the balls of one register that crossed the jump, and gives up those that graze it.</summary>
    /// <param name="at">The first slot of the register.</param>
    /// <param name="count">The number of balls in it.</param>
    /// <param name="jump">The jump in the drag law.</param>
    /// <param name="length">The length of the step, in s.</param>
    [MethodImpl(Hot.Path)]
    public void NoteCrossings(int at, int count, in LaneJump jump, float length)
    {
        int end = at + count < Flying ? at + count : Flying;
        for (int i = at; i < end; i++)
        {
            // A set mask is NaN or 1, so compare with 0.
            bool crosses = (Inside[i] == 0) != (InsideAfter[i] == 0);
            if ((crosses || Near[i] != 0) && LaneJumpCheck.Grazes(_now, _next, i, in jump, Inside[i] != 0, crosses, length))
            {
                GiveUp(i);
            }
            else if (crosses)
            {
                Crossed.Take(this, i, CrossingCount);
                Crossing[CrossingCount++] = i;
            }
        }
    }

    /// <summary>Copies the balls that crossed the jump back to their slots.</summary>
    [MethodImpl(Hot.Path)]
    public void Rejoin(in LaneJump jump, float length)
    {
        for (int i = 0; i < CrossingCount; i++)
        {
            int place = Crossing[i];
            _next.Take(Crossed.Next, i, place);
            Inside[place] = InsideAfter[place];
            double rest = (1.0 - Crossed.Share[i]) * length;
            if (Crossed.Astray[i] != 0
                || LaneJumpCheck.Slides(Crossed.Middle, i, _next, place, in jump, InsideAfter[place] != 0, rest)
                || ++Crossings[place] > MostCrossings)
            {
                GiveUp(place);
            }
        }
    }

    /// <summary>Returns the index in <see cref="Crossed"/> of the ball in a slot if it crossed the jump in this step; otherwise −1.</summary>
    public int CrossingOf(int at) => CrossingCount > 0 ? Array.IndexOf(Crossing, at, 0, CrossingCount) : -1;

    /// <summary>Gives a ball up: it leaves the group together with those that end in this step.</summary>
    public void GiveUp(int at)
    {
        GivenUp[Ball[at]] = true;
        Limit[at] = float.PositiveInfinity;
    }

    /// <summary>Removes the balls that ended, and moves the last ones into their slots.</summary>
    [MethodImpl(Hot.Path)]
    public void Compact()
    {
        for (int i = EndedCount - 1; i >= 0; i--)
        {
            int to = Ended[i];
            int from = --Flying;
            if (from != to)
            {
                _next.Move(from, to);
                Ball[to] = Ball[from];
                Nx[to] = Nx[from];
                Ny[to] = Ny[from];
                Nz[to] = Nz[from];
                Limit[to] = Limit[from];
                Drift[to] = Drift[from];
                Inside[to] = Inside[from];
                Crossings[to] = Crossings[from];
            }
        }

        EndedCount = 0;
    }

    /// <summary>Collects the balls of one register that ended, or reached their highest point, in this step.</summary>
    [MethodImpl(Hot.Path)]
    public void Note(int at, int count, float time, bool tops)
    {
        int end = at + count < Flying ? at + count : Flying;
        for (int i = at; i < end; i++)
        {
            if ((float)(_next.Py[i] + (float)(Drift[i] * time)) < Limit[i])
            {
                Ended[EndedCount++] = i;
            }

            if (tops && _now.Uy[i] + Drift[i] > 0 && !(_next.Uy[i] + Drift[i] > 0))
            {
                Topped[ToppedCount++] = i;
            }
        }
    }
}
