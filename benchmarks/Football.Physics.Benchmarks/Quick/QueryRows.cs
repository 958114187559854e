namespace FootballPhysics.Benchmarks;

/// <summary>The rows of queries: derivatives by the launch, and interceptions.</summary>
internal static class QueryRows
{
    private const int Count = 32;
    private const double TimeStep = 0.01;

    public static IReadOnlyList<TargetRow> All { get; } =
    [
        Derivatives("published laws", Scene.Published),
        Derivatives("measured laws", Scene.Measured),
        new("22 runners on a 3 s look-ahead of 80 ms: all windows, of the look-ahead", () => Runners((path, query, runners) => query.Find(path, runners), Path()), LookAhead) { Target = 2 },
        new("22 runners on a 3 s look-ahead of 80 ms: who is first, of the look-ahead", () => Runners((path, query, runners) => query.FindFirst(path, runners, out _), Path()), LookAhead),
        new("22 runners on a 3 s look-ahead of 80 ms: windows and shares, of the look-ahead", () => Runners(Shares, Path()), LookAhead),
        new("best pass of a fan of 1 000 kicks among 13 players (2 ms are to be reached), of a 3 s look-ahead of 80 ms", () => Passes(Scene.Default, 8), LookAhead),
        new("the same, 100 of them along the ground", () => Passes(Scene.Default, 0), LookAhead),
        new("the same, each time with another spin, so that no way along the ground is known", () => Passes(Scene.Default, 0, isNew: true), LookAhead),
        new("the same in wind: 100 ways along the ground", () => Passes(Windy, 0), LookAhead),
        OfItsSteps("without air, RK4, 60 Hz", Scene.Vacuum, 1 / 60.0, 2),
        OfItsSteps("without air, RK4, 80 ms steps", Scene.Vacuum, 0.08, 2),
        OfItsSteps("default scene, RK4, 60 Hz", new Scene(), 1 / 60.0, null),
        OfItsSteps("default scene, RK4, 80 ms steps", new Scene(), 0.08, null),
        .. GoalChanceRows.All,
        .. BankShotRows.All,
    ];

    private static TargetRow Derivatives(string name, Scene scene) =>
        new($"flight with all derivatives, RK4 10 ms, {name}, of the flight without", () => WithDerivatives(scene), () => Without(scene)) { Target = 3 };

    private static BallState[] Kicks(Simulator simulator)
    {
        var random = new SeededRandom(11L);
        var kicks = new BallState[Count];
        for (int i = 0; i < Count; i++)
        {
            kicks[i] = simulator.Launch(Shot.Spot, random.Velocity(18, 30, 8, 35), random.Uniform(10, 60) * random.Direction());
        }

        return kicks;
    }

    private static Workload Without(Scene scene)
    {
        var simulator = new Simulator(scene);
        BallState[] kicks = Kicks(simulator);
        var log = new StepLog();
        return new Workload(
            () =>
            {
                double sum = 0;
                foreach (BallState kick in kicks)
                {
                    BallState state = kick;
                    log.Clear();
                    simulator.Run(ref state, TimeStep, 10, StopAt.Impact, log);
                    sum += state.Position.X;
                }

                return sum;
            },
            Count);
    }

    private static Workload WithDerivatives(Scene scene)
    {
        var derivatives = new LaunchDerivatives(new Simulator(scene));
        BallState[] kicks = Kicks(derivatives.Simulator);
        return new Workload(
            () =>
            {
                double sum = 0;
                foreach (BallState kick in kicks)
                {
                    BallState state = kick;
                    derivatives.Run(ref state, TimeStep, 10, StopAt.Impact);
                    sum += derivatives.PositionByVelocity.X.X;
                }

                return sum;
            },
            Count);
    }

    private static LookAheadRequest Request { get; } = new() { Duration = 3, StopAt = StopAt.Time };

    private static Trajectory Path()
    {
        var simulator = new Simulator(Scene.Default);
        var path = new Trajectory();
        simulator.LookAhead(Kicks(simulator)[0], Request, path);
        return path;
    }

    /// <summary>Computes a look-ahead of 3 s.</summary>
    public static Workload LookAhead() => LookAhead(Scene.Default, Request.TimeStep);

    /// <summary>Computes all windows of 22 players on a look-ahead of 3 s.</summary>
    public static Workload Windows() => Runners((path, query, runners) => query.Find(path, runners), Path());

    /// <summary>Runs the steps of a look-ahead, without its path.</summary>
    private static Workload Steps(Scene scene, double h)
    {
        var simulator = new Simulator(scene);
        BallState kick = Kicks(simulator)[0];
        var log = new StepLog();
        return new Workload(
            () =>
            {
                double sum = 0;
                for (int i = 0; i < Count; i++)
                {
                    BallState state = kick;
                    log.Clear();
                    simulator.Run(ref state, h, Request.Duration, StopAt.Time, log);
                    sum += state.Position.X;
                }

                return sum;
            },
            Count);
    }

    private static Workload LookAhead(Scene scene, double h)
    {
        var simulator = new Simulator(scene);
        BallState kick = Kicks(simulator)[0];
        var path = new Trajectory();
        LookAheadRequest request = Request with { TimeStep = h };
        return new Workload(
            () =>
            {
                for (int i = 0; i < Count; i++)
                {
                    simulator.LookAhead(in kick, request, path);
                }

                return path.EndTime;
            },
            Count);
    }

    private static TargetRow OfItsSteps(string name, Scene scene, double h, double? target) =>
        new($"3 s look-ahead, {name}, of its steps", () => LookAhead(scene, h), () => Steps(scene, h)) { Target = target };

    private static Workload Runners(Action<Trajectory, Interception, Player[]> ask, Trajectory path)
    {
        var random = new SeededRandom(5L);
        var query = new Interception();
        Vector3d middle = path.PositionAt(1.5);
        Player[] runners = [.. Enumerable.Range(0, 22).Select(_ => new Player { Position = (middle + (random.Uniform(2, 35) * random.Heading())).Horizontal, Velocity = random.Uniform(0, 5) * random.Heading() })];
        return new Workload(
            () =>
            {
                for (int i = 0; i < Count; i++)
                {
                    ask(path, query, runners);
                }

                return query.TimeMargin;
            },
            Count);
    }

    private static void Shares(Trajectory path, Interception query, Player[] runners)
    {
        query.Find(path, runners);
        query.FindShares();
    }

    private static Scene Windy => Scene.Default with { Air = Scene.Default.Air with { Wind = new Vector3d(4, 0, -2) } };

    private static Workload Passes(Scene scene, double lowest, bool isNew = false)
    {
        var fan = new PassFan(scene);
        PassFanRequest[] requests =
        [
            .. Enumerable.Range(0, isNew ? 2 : 1).Select(
                i => new PassFanRequest { From = Shot.Spot, Direction = new Vector3d(0, 0, -1), MinimumElevationDegrees = lowest, TopSpin = 1e-3 * i }),
        ];
        Player[] mates = [new Player { Position = new Vector3d(5, 0, -30), Velocity = new Vector3d(1, 0, -4) }, new Player { Position = new Vector3d(-12, 0, -25) }];
        Player[] opponents = [.. Enumerable.Range(0, 11).Select(i => new Player { Position = new Vector3d(-20 + (4 * i), 0, -22 - (i % 3 * 4)) })];
        int round = 0;
        return new Workload(() => fan.Find(requests[round++ % requests.Length], mates, opponents).Open, 1);
    }
}
