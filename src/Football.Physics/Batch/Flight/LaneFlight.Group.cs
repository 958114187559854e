namespace Football.Physics;

/// <summary>The flight of a group: step by step, in each all balls, so that the processor always has independent work.</summary>
#if NET8_0_OR_GREATER
internal sealed partial class LaneFlight<F, TLaw, TMethod> : LaneFlight
    where F : struct, ILane<F>
    where TLaw : struct, ILaneLaw<F>
    where TMethod : struct, ILaneMethod
#else
internal sealed partial class LaneFlight<TLane, TLaw, TMethod> : LaneFlight
    where TLaw : struct, ILaneLaw<TLane>
    where TMethod : struct, ILaneMethod
#endif
{
    private readonly LaneWeight _weight;
    private readonly LaneJump _jump;

    // Not readonly: a call through a type parameter would copy the law first.
    private TLaw _law;

    /// <param name="scene">The scene.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <param name="upAlongX">Whether up is along x of the lanes, else y.</param>
    /// <param name="findsApex">Whether the highest point of each way is wanted.</param>
    public LaneFlight(Scene scene, double timeStep, bool upAlongX, bool findsApex)
        : base(timeStep, findsApex)
    {
        _weight = new LaneWeight(scene, upAlongX);
        _jump = new LaneJump(scene);
        _law.Prepare(scene);
    }

    public override void Fly(LaneGroup group, double duration)
    {
        double h = TimeStep;
        double time = 0;
        double last = duration - (1e-9 * h);
        if (_law.Jumps)
        {
            FindBranch(group);
        }

        for (int step = 1; group.Flying > 0 && time < last; step++)
        {
            double end = step * h;
            float length = TimeStep;
            if (end > duration)
            {
                end = duration;
                length = (float)(end - time);
            }

            Step(group, length);
            Note(group, (float)end);
            for (int i = 0; i < group.ToppedCount; i++)
            {
                Top(group, group.Topped[i], time, length);
            }

            group.ToppedCount = 0;
            for (int i = 0; i < group.EndedCount; i++)
            {
                int at = group.Ended[i];
                if (group.GivenUp[group.Ball[at]])
                {
                    group.Reached[group.Ball[at]] = false;
                }
                else
                {
                    Reach(group, at, time, length);
                }
            }

            group.Compact();
            group.Swap();
            time = end;
        }

        for (int i = 0; i < group.Flying; i++)
        {
            LaneState now = group.Now;
            group.End(i, time, reached: false, now.Path(i), now.Velocity(i), now.W[i]);
        }
    }

    /// <summary>Ends a flight where its cubic Hermite interpolant comes to the limit.</summary>
    private static void Reach(LaneGroup group, int at, double time, double length)
    {
        double limit = group.Limit[at];
        var piece = new LanePiece(group, at, time, length);
        if (group.CrossingOf(at) is >= 0 and int crossing)
        {
            var first = new LanePiece(group, at, crossing, first: true, time, length);
            piece = first.EndHeight < limit ? first : new LanePiece(group, at, crossing, first: false, time, length);
        }

        double start = piece.StartHeight - limit;
        double end = piece.EndHeight - limit;
        var arc = new HeightArc(start > 0 ? start : 0, piece.StartRise, 0, end < 0 ? end : 0, piece.EndRise, piece.Length);
        double tau = arc.HermiteRoot();
        piece.At(tau, out Vector3d path, out Vector3d velocity, out double spin);
        group.End(at, piece.Start + tau, reached: true, in path, in velocity, spin);
    }

    /// <summary>Notes the highest point of the last step.</summary>
    private static void Top(LaneGroup group, int at, double time, double length)
    {
        var piece = new LanePiece(group, at, time, length);
        if (group.CrossingOf(at) is >= 0 and int crossing)
        {
            var first = new LanePiece(group, at, crossing, first: true, time, length);
            piece = first.EndRise < 0 ? first : new LanePiece(group, at, crossing, first: false, time, length);
        }

        var height = new CubicHermite(piece.StartHeight, piece.StartRise * piece.Length, piece.EndHeight, piece.EndRise * piece.Length);
        double top = height.At(height.Highest);
        int ball = group.Ball[at];
        group.Apex[ball] = top > group.Apex[ball] ? top : group.Apex[ball];
    }
}
