using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The flight of a group. Each step advances all balls, so that the processor always has independent work.</summary>
#if NET8_0_OR_GREATER
internal sealed partial class LaneKernel<F, TLaw, TMethod> : LaneFlight
    where F : struct, ILane<F>
    where TLaw : struct, ILaneLaw<F>
    where TMethod : struct, ILaneMethod
#else
internal sealed partial class LaneKernel<TLane, TLaw, TMethod> : LaneFlight
    where TLaw : struct, ILaneLaw<TLane>
    where TMethod : struct, ILaneMethod
#endif
{
    private readonly LaneWeight _weight;
    private readonly LaneJump _jump;

    // Not readonly: otherwise each call through the type parameter would copy the law.
    private TLaw _law;

    /// <param name="scene">The scene.</param>
    /// <param name="timeStep">The length of a step, in s.</param>
    /// <param name="upAlongX">True if up is the lanes' x, false for y.</param>
    /// <param name="findsApex">True to compute the highest point of each path.</param>
    public LaneKernel(Scene scene, double timeStep, bool upAlongX, bool findsApex)
        : base(timeStep, findsApex)
    {
        _weight = new LaneWeight(scene, upAlongX);
        _jump = new LaneJump(scene);
        _law.Prepare(scene);
    }

    [MethodImpl(Hot.Path)]
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
                LaneLocator.Top(group, group.Topped[i], time, length);
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
                    LaneLocator.Reach(group, at, time, length);
                }
            }

            group.Compact();
            group.Swap();
            time = end;
            group.Watch?.Step(group, time);
        }

        for (int i = 0; i < group.Flying; i++)
        {
            LaneState now = group.Now;
            group.End(i, time, reached: false, now.Path(i), now.Velocity(i), now.W[i]);
        }
    }
}
