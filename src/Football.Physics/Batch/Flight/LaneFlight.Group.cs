using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The flight of a group: step by step, in each all balls, so that the processor always has independent work.</summary>
#if NET8_0_OR_GREATER
internal sealed partial class LaneFlight<F, TLaw, TMethod> : LaneFlight
    where F : struct, ILane<F>
    where TLaw : struct, ILaneLaw
    where TMethod : struct, ILaneMethod
#else
internal sealed partial class LaneFlight<TLaw, TMethod> : LaneFlight
    where TLaw : struct, ILaneLaw
    where TMethod : struct, ILaneMethod
#endif
{
    private readonly LaneAir _air;

    public LaneFlight(in LaneAir air) => _air = air;

    private static bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TLaw).Fitted && !default(TLaw).Regularised;
    }

    public override void Fly(LaneGroup group, double duration)
    {
        double h = TimeStep;
        double time = 0;
        double last = duration - (1e-9 * h);
        if (Jumps)
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
                Reach(group, group.Ended[i], time, length);
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

    /// <summary>The height arc of the last step of a ball, from its limit up.</summary>
    private static HeightArc Arc(LaneGroup group, int at, double time, double length)
    {
        double drift = group.Drift[at];
        double limit = group.Limit[at];
        LaneState now = group.Now;
        LaneState next = group.Next;
        double start = ((double)now.Py[at] - now.PyRest[at]) + (drift * time) - limit;
        double end = ((double)next.Py[at] - next.PyRest[at]) + (drift * (time + length)) - limit;
        return new HeightArc(
            start > 0 ? start : 0,
            ((double)now.Uy[at] - now.UyRest[at]) + drift,
            0,
            end < 0 ? end : 0,
            ((double)next.Uy[at] - next.UyRest[at]) + drift,
            length);
    }

    /// <summary>Ends a flight where its cubic Hermite interpolant comes to the limit.</summary>
    private static void Reach(LaneGroup group, int at, double time, double length)
    {
        HeightArc arc = Arc(group, at, time, length);
        double tau = arc.HermiteRoot();
        double s = tau / length;
        LaneState now = group.Now;
        LaneState next = group.Next;
        Vector3d p0 = now.Path(at);
        Vector3d v0 = now.Velocity(at);
        Vector3d v1 = next.Velocity(at);
        Vector3d miss = next.Path(at) - p0 - (length * v0);
        Vector3d turn = length * (v1 - v0);
        Vector3d path = p0 + (tau * v0) + (s * s * ((3.0 * miss) - turn + (s * (turn - (2.0 * miss)))));
        Vector3d velocity = v0 + (s / length * ((6.0 * miss) - (2.0 * turn) + (3.0 * s * (turn - (2.0 * miss)))));
        double spin = now.W[at] + (s * ((double)next.W[at] - now.W[at]));
        group.End(at, time + tau, reached: true, in path, in velocity, spin);
    }

    /// <summary>Notes the highest point of the last step.</summary>
    private static void Top(LaneGroup group, int at, double time, double length)
    {
        LaneState now = group.Now;
        LaneState next = group.Next;
        double drift = group.Drift[at];
        double y0 = ((double)now.Py[at] - now.PyRest[at]) + (drift * time);
        double y1 = ((double)next.Py[at] - next.PyRest[at]) + (drift * (time + length));
        double v0 = (((double)now.Uy[at] - now.UyRest[at]) + drift) * length;
        double v1 = (((double)next.Uy[at] - next.UyRest[at]) + drift) * length;

        // Cubic Hermite upside down, for its lowest point.
        double rise = y1 - y0;
        double c2 = (3.0 * rise) - (2.0 * v0) - v1;
        double c3 = v0 + v1 - (2.0 * rise);
        double s = HeightArc.LowestPoint(-v0, -c2, -c3);
        double top = y0 + (s * (v0 + (s * (c2 + (s * c3)))));
        int ball = group.Ball[at];
        group.Apex[ball] = top > group.Apex[ball] ? top : group.Apex[ball];
    }
}
