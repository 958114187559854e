namespace FootballPhysics.Benchmarks;

/// <summary>The shot sets in the form that each yardstick needs.</summary>
internal static class Shots
{
    /// <summary>Returns the same shots, so high up that they do not come down.</summary>
    public static IReadOnlyList<Shot> HighUp(IReadOnlyList<Shot> shots) => [.. shots.Select(shot => shot.From(ShotSets.HighUp))];

    public static BallState[] Launch(Simulator simulator, IReadOnlyList<Shot> shots) =>
        [.. shots.Select(shot => simulator.Launch(shot.Position, shot.Velocity, shot.Spin))];

    public static PlainState[] Plain(IReadOnlyList<Shot> shots) => [.. shots.Select(PlainState.Of)];

    /// <summary>Returns a free kick from the ground: 27 m/s, 17° up, backspin of 20 rad/s and 45 rad/s about the vertical.</summary>
    public static BallState FreeKick(Simulator simulator)
    {
        var direction = new Vector3d(-0.1, Math.Tan(17 * Math.PI / 180), -1);
        Vector3d velocity = 27 / direction.Length * direction;
        return simulator.Launch(Shot.Spot, velocity, KickVectors.Spin(velocity, -20, 45));
    }

    /// <summary>Returns balls that have come to rest.</summary>
    public static BallState[] Stopped(Simulator simulator)
    {
        BallState[] shots = Launch(simulator, ShotSets.Mixed);
        var log = new StepLog();
        for (int i = 0; i < shots.Length; i++)
        {
            simulator.Run(ref shots[i], ShotSets.TimeStep, 60, StopAt.Rest, log);
        }

        return shots.All(s => s.Motion == MotionState.Rest) ? shots : throw new InvalidOperationException("A ball has not come to rest within 60 s.");
    }
}
