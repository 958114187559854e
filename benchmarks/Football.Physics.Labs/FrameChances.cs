namespace FootballPhysics.Labs;

/// <summary>Compares the chance of a goal near the frame with simulated random kicks.</summary>
internal static class FrameChances
{
    private const double Away = 15;
    private const double Speed = 24;
    private const int PerTask = 500;

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -Away), Facing = new Vector3d(0, 0, 1) };

    /// <summary>The targets of the kicks: next to the posts, under the bar, at a corner; and their spread, degrees.</summary>
    public static (double Aside, double Height, double Degrees)[] Cases { get; } =
        [(3.58, 1.1, 0.3), (3.64, 1.1, 0.3), (-3.6, 2, 0.3), (3.7, 0.5, 0.8), (0, 2.4, 0.3), (1, 2.5, 0.8), (3.5, 2.3, 0.3), (-3.5, 2.3, 0.8)];

    /// <summary>Computes one case: by derivatives, by flights, and by full simulation.</summary>
    public static (GoalChanceResult Derived, GoalChanceResult Flown, double Played) Of((double Aside, double Height, double Degrees) item, int seed, int kicks)
    {
        var from = new Vector3d(0, 0.11, 0);
        AimResult aim = new Aimer().Find(new AimRequest { From = from, Target = new Vector3d(item.Aside, item.Height, -Away), Speed = Speed });
        var spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = item.Degrees, AzimuthDegrees = item.Degrees };
        var chance = new GoalChance();
        var simulator = new Simulator(new Scene { Goals = [s_goal] });
        int goals = 0;
        Parallel.For(0, (kicks + PerTask - 1) / PerTask, task =>
        {
            var random = new Random((seed * 100_003) + task);
            var log = new StepLog();
            int own = 0;
            for (int i = 0; i < Math.Min(PerTask, kicks - (task * PerTask)); i++)
            {
                (Vector3d velocity, Vector3d spin) = spread.Draw(random, aim.Velocity, aim.Spin);
                BallState ball = simulator.Launch(from, velocity, spin);
                log.Clear();
                simulator.Run(ref ball, 0.01, 2.5, StopAt.Time, log);
                own += log.Events.Span.ToArray().Count(happened => happened.Kind == BallEventKind.Goal);
            }

            Interlocked.Add(ref goals, own);
        });
        return (chance.Find(from, aim.Velocity, aim.Spin, spread, s_goal), chance.FindByFlights(from, aim.Velocity, aim.Spin, spread, s_goal, null, kicks, seed), (double)goals / kicks);
    }
}
