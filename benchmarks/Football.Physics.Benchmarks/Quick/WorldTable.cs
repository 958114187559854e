namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "The ball among things": RK2 at 10 ms, flights that hit nothing, compared with the same flights over an empty pitch.</summary>
internal static class WorldTable
{
    private const int Steps = 60;
    private const double H = ShotSets.TimeStep;

    private static readonly Vector3d s_midfield = new(4, 1, 1);
    private static readonly Vector3d s_nearGoal = new(1, 0.5, -49.5);

    public static IReadOnlyList<WorldRow> Rows { get; } =
    [
        new("goals, nets and boards, midfield", 1.15, scenes => Flights(scenes.WithoutPlayers, s_midfield), s_midfield),
        new("and 22 players who stand, midfield", 1.15, scenes => Flights(scenes.WithStandingPlayers, s_midfield), s_midfield),
        new("and 22 players who run, midfield", 1.15, scenes => Flights(scenes.WithRunningPlayers, s_midfield), s_midfield),
        new("and 22 bodies, midfield", 1.15, scenes => Flights(scenes.WithBodies(out _), s_midfield), s_midfield),
        new("and 22 bodies that the game moves before every step, midfield", null, MovedFlights, s_midfield),
        new("goals, nets and boards, before the goal", 2, scenes => Flights(scenes.WithoutPlayers, s_nearGoal), s_nearGoal),
        new("and 22 players who stand, before the goal", 2, scenes => Flights(scenes.WithStandingPlayers, s_nearGoal), s_nearGoal),
        new("and 22 bodies, before the goal", 2, scenes => Flights(scenes.WithBodies(out _), s_nearGoal), s_nearGoal),
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<WorldRow> rows, double share)
    {
        Scene[] scenes = [new Scene(), Scene.Published];
        (WorldRow Row, Workload[] Subjects, Workload[] Empty)[] work =
        [
            .. rows.Select(row => (row, scenes.Select(scene => row.Subject(new StadiumScenes(scene))).ToArray(), scenes.Select(scene => Flights(scene, row.From)).ToArray())),
        ];
        Stopwatching.WarmUp([.. work.SelectMany(w => w.Subjects.Concat(w.Empty))]);
        print("");
        print("## The ball among things");
        print("");
        print("RK2 at 10 ms: fast shots of 0.6 s that hit nothing, relative to the same shots over an empty pitch, in the default scene and in the published one. Before the goal: from 3 m before its line, in any direction.");
        print("");
        print("| | ns a step | empty pitch then, ns | ratio | reach | | bytes | published: ns | ratio |");
        print("|---|--:|--:|--:|--:|---|--:|--:|--:|");
        foreach ((WorldRow row, Workload[] subjects, Workload[] empty) in work)
        {
            Timing time = Stopwatching.Measure(subjects[0], empty[0], 0.5 * share);
            Timing published = Stopwatching.Measure(subjects[1], empty[1], 0.5 * share);
            string verdict = row.Target is { } target ? (time.Ratio <= target ? "reached" : "**missed**") : "";
            string reach = row.Target is { } t ? $"≤ {Text.Number(t)}" : "";
            print($"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {reach} | {verdict} | {Text.Number(time.Bytes)} | {Text.Number(published.Nanoseconds)} | {Text.Number(published.Ratio)} |");
        }
    }

    /// <summary>Simulates flights from before the goal, with the default integrator.</summary>
    public static Workload BeforeTheGoal(Scene scene) => Flights(scene, s_nearGoal, SolverSettings.Default.Integrator);

    private static Workload Flights(Scene scene, in Vector3d from, Integrator integrator = Integrator.Rk2)
    {
        var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
        BallState[] states = Shots.Launch(simulator, Free(from));
        var log = new StepLog();
        return new Workload(() => Batches.Chain(simulator, states, Steps, H, log), states.Length * Steps);
    }

    /// <summary>Simulates the flights and moves every body before every step: the time includes both.</summary>
    private static Workload MovedFlights(StadiumScenes scenes)
    {
        var simulator = new Simulator(scenes.WithBodies(out KinematicBodies players), new SolverSettings { Integrator = Integrator.Rk2 });
        BallState[] states = Shots.Launch(simulator, Free(s_midfield));
        var log = new StepLog();
        return new Workload(() => Batches.ChainAmong(simulator, players, states, Steps, H, log), states.Length * Steps);
    }

    /// <summary>Returns fast shots that hit nothing in any of the scenes.</summary>
    private static IReadOnlyList<Shot> Free(Vector3d from)
    {
        Simulator[] all =
        [
            .. new[] { new StadiumScenes(new Scene()), new StadiumScenes(Scene.Published) }.SelectMany(
                of => new Simulator[] { new(of.WithoutPlayers), new(of.WithStandingPlayers), new(of.WithRunningPlayers), new(of.WithBodies(out _)) }),
        ];
        return [.. ShotSets.Make(7, 24, 24, 20, 30, 20, 45, 4 * ShotSets.Count).Select(shot => shot with { Position = from }).Where(shot => all.All(simulator => MeetsNothing(simulator, shot))).Take(16)];
    }

    private static bool MeetsNothing(Simulator simulator, Shot shot)
    {
        BallState state = simulator.Launch(shot.Position, shot.Velocity, shot.Spin);
        var log = new StepLog();
        simulator.Run(ref state, H, Steps * H, StopAt.Time, log);
        return log.Events.Count == 0;
    }
}
