using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>A group of balls in flight, and where their flights ended. Small enough for the first-level cache.</summary>
internal sealed class LaneGroup
{
    /// <summary>Balls in a group.</summary>
    public const int Size = 256;

    /// <summary>Room for the widest register beyond the last ball.</summary>
    private const int Room = Size + 16;

    /// <summary>A flight crosses the jump three times: into the branch with spin, out of it as it slows down, into it as it falls.</summary>
    private const int MostCrossings = 3;

    private LaneState _now = new(Room);
    private LaneState _next = new(Room);

    /// <summary>Is shown the group after every step; null costs nothing.</summary>
    public LaneWatch? Watch;

    /// <summary>How many are flying: the first places.</summary>
    public int Flying;

    /// <summary>Which ball of the group is at a place.</summary>
    public readonly int[] Ball = new int[Size];

    /// <summary>Unit axis of the spin.</summary>
    public readonly float[] Nx = new float[Room];
    public readonly float[] Ny = new float[Room];
    public readonly float[] Nz = new float[Room];

    /// <summary>A flight ends when its way along y and the wind's, <see cref="Drift"/> times the time, fall below this, m.</summary>
    public readonly float[] Limit = new float[Room];
    public readonly float[] Drift = new float[Room];

    /// <summary>Mask: whether the drag law with spin holds.</summary>
    public readonly float[] Inside = new float[Room];

    /// <summary>Mask: the same after the step.</summary>
    public readonly float[] InsideAfter = new float[Room];

    /// <summary>Mask: whether the drag law's jump was near at the end of the step.</summary>
    public readonly float[] Near = new float[Room];

    /// <summary>How often a ball crossed the jump.</summary>
    public readonly int[] Crossings = new int[Size];

    /// <summary>Places whose balls crossed the drag law's jump in the step, and those balls side by side.</summary>
    public readonly int[] Crossing = new int[Size];
    public int CrossingCount;
    public readonly LaneCrossings Crossed = new(Room);

    /// <summary>Places whose balls ended in the last step, ascending.</summary>
    public readonly int[] Ended = new int[Size];
    public int EndedCount;

    /// <summary>Places whose balls were at their highest in the last step.</summary>
    public readonly int[] Topped = new int[Size];
    public int ToppedCount;

    /// <summary>By ball: the greatest y of the way, the wind's part included, m.</summary>
    public readonly double[] Apex = new double[Size];

    /// <summary>By ball: when its flight ended, s.</summary>
    public readonly double[] EndTime = new double[Size];

    /// <summary>By ball: whether it flies no further here: floats do not do for it, as it grazes the drag law's jump or slides along it, or who watches has seen enough.</summary>
    public readonly bool[] GivenUp = new bool[Size];

    /// <summary>By ball: whether it ended at its limit.</summary>
    public readonly bool[] Reached = new bool[Size];

    /// <summary>By ball: way through the air, velocity relative to it and size of the spin at the end.</summary>
    public readonly Vector3d[] EndPath = new Vector3d[Size];
    public readonly Vector3d[] EndVelocity = new Vector3d[Size];
    public readonly double[] EndSpin = new double[Size];

    /// <summary>Before the step.</summary>
    public LaneState Now => _now;

    /// <summary>After the step.</summary>
    public LaneState Next => _next;

    /// <summary>Forgets all balls.</summary>
    public void Clear()
    {
        Flying = 0;
        EndedCount = 0;
        ToppedCount = 0;
        CrossingCount = 0;
    }

    /// <summary>Adds a ball.</summary>
    /// <param name="ball">Its number in the group.</param>
    /// <param name="u">Velocity relative to the air.</param>
    /// <param name="axis">Unit axis of the spin.</param>
    /// <param name="spinRate">Size of the spin.</param>
    /// <param name="limit">Where along y its flight ends.</param>
    /// <param name="drift">How fast the wind carries it along y.</param>
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

    /// <summary>Writes down how a flight ended.</summary>
    public void End(int at, double time, bool reached, in Vector3d path, in Vector3d velocity, double spin)
    {
        int ball = Ball[at];
        EndTime[ball] = time;
        Reached[ball] = reached;
        EndPath[ball] = path;
        EndVelocity[ball] = velocity;
        EndSpin[ball] = spin;
    }

    /// <summary>Notes the places of one register whose balls crossed the drag law's jump, and gives up those that graze it.</summary>
    /// <param name="at">The register's first place.</param>
    /// <param name="count">How many balls it holds.</param>
    /// <param name="jump">Where the law jumps.</param>
    /// <param name="length">Length of the step, s.</param>
    [MethodImpl(Hot.Path)]
    public void NoteCrossings(int at, int count, in LaneJump jump, float length)
    {
        int end = at + count < Flying ? at + count : Flying;
        for (int i = at; i < end; i++)
        {
            // A mask that is set is not a number, or 1.
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

    /// <summary>Puts the balls that crossed the jump back in their places.</summary>
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

    /// <summary>Where in <see cref="Crossed"/> the ball at a place is, if it crossed the jump in this step; else −1.</summary>
    public int CrossingOf(int at) => CrossingCount > 0 ? Array.IndexOf(Crossing, at, 0, CrossingCount) : -1;

    /// <summary>Flies a ball no further here: it is taken out with those that end in the step.</summary>
    public void GiveUp(int at)
    {
        GivenUp[Ball[at]] = true;
        Limit[at] = float.PositiveInfinity;
    }

    /// <summary>Takes the balls that ended out of the state after the step, the last ones into their places.</summary>
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

    /// <summary>Notes the places of one register whose balls ended or were at their highest in this step.</summary>
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
