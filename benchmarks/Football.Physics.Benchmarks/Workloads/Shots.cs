using Football.Physics.Yardsticks;

namespace Football.Physics.Benchmarks;

/// <summary>The shot sets as each competitor takes them.</summary>
internal static class Shots
{
    /// <summary>The same shots, so high up that they do not come down.</summary>
    public static IReadOnlyList<Shot> HighUp(IReadOnlyList<Shot> shots) => [.. shots.Select(shot => shot.From(ShotSets.HighUp))];

    public static BallState[] Launch(Simulator simulator, IReadOnlyList<Shot> shots) =>
        [.. shots.Select(shot => simulator.Launch(shot.Position, shot.Velocity, shot.Spin))];

    public static PlainState[] Plain(IReadOnlyList<Shot> shots) => [.. shots.Select(PlainState.Of)];

    /// <summary>Balls that have come to rest.</summary>
    public static BallState[] Stopped(Simulator simulator)
    {
        BallState[] shots = Launch(simulator, ShotSets.Mixed);
        var log = new StepLog();
        for (int i = 0; i < shots.Length; i++)
        {
            simulator.Run(ref shots[i], ShotSets.TimeStep, 60, StopAt.Rest, log);
        }

        return shots.All(s => s.Motion == MotionState.Stopped) ? shots : throw new InvalidOperationException("A ball has not come to rest within 60 s.");
    }
}
