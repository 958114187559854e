namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "A ball in a group": RK2 at 10 ms, the default scene, a group of one compared with its ball alone; and a ball that is kicked in a net.</summary>
internal static class GroupTable
{
    private const int Steps = 30;
    private const double H = ShotSets.TimeStep;
    private const double Mass = 75;
    private const string Alone = "the ball alone";

    private static readonly Vector3d s_midfield = new(4, 1, 1);

    public static IReadOnlyList<GroupRow> Rows { get; } =
    [
        new("a group of one, flight", 1.05, Alone, () => Pair(() => new Scene(), Flights)),
        new("a group of one, roll", 1.05, Alone, () => Pair(() => new Scene(), Rolls)),
        new("a group of one, among 22 bodies", 1.05, Alone, () => Pair(() => WithBodies(double.PositiveInfinity), Flights)),
        new("a group of one, among 22 bodies that have a mass", 1.3, Alone, () => Pair(() => WithBodies(Mass), Flights)),
        new("a group of one, pushes a crate in each step", 1.3, Alone, () => Pair(WithCrate, Presses)),
        new("two balls far apart, among 22 bodies that have a mass", 1.3, "the same without a mass", () => (Two(WithBodies(Mass)), Two(WithBodies(double.PositiveInfinity)))),
        new("a group of one, kicked in the net", 1.05, Alone, () => (Kicked(inGroup: true, kicks: true), Kicked(inGroup: false, kicks: true))),
        new("a ball alone, kicked in the net with its own velocity", 1.3, "the same without the kick", () => (Kicked(inGroup: false, kicks: true), Kicked(inGroup: false, kicks: false))),
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<GroupRow> rows, double share)
    {
        (GroupRow Row, Workload Subject, Workload Yardstick)[] work = [.. rows.Select(row => (row, row.Make())).Select(item => (item.row, item.Item2.Subject, item.Item2.Yardstick))];
        Stopwatching.WarmUp([.. work.SelectMany(w => new[] { w.Subject, w.Yardstick })]);
        print("");
        print("## A ball in a group");
        print("");
        print("RK2 at 10 ms in the default scene, relative to the yardstick in the same run.");
        print("");
        print("| | ns a step | yardstick | ns a step | ratio | reach | | bytes |");
        print("|---|--:|---|--:|--:|--:|---|--:|");
        foreach ((GroupRow row, Workload subject, Workload yardstick) in work)
        {
            Timing time = Stopwatching.Measure(subject, yardstick, share);
            string verdict = row.Target is { } target ? (time.Ratio <= target ? "reached" : "**missed**") : "";
            string reach = row.Target is { } t ? $"≤ {Text.Number(t)}" : "";
            print($"| {row.Name} | {Text.Number(time.Nanoseconds)} | {row.Yardstick} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {reach} | {verdict} | {Text.Number(time.Bytes)} |");
        }
    }

    /// <summary>Returns a group of one, and its ball alone in an equal scene.</summary>
    private static (Workload Subject, Workload Yardstick) Pair(Func<Scene> scene, Func<Simulator, BallState[]> starts)
    {
        Simulator alone = Compile(scene());
        return (Grouped(Compile(scene()), starts), Single(alone, starts(alone)));
    }

    /// <summary>Steps two balls of a group; the time is per ball.</summary>
    private static Workload Two(Scene scene)
    {
        Simulator simulator = Compile(scene);
        BallState[] states = Flights(simulator);
        var group = new BallGroup(simulator, 2);
        var balls = new BallState[2];
        var log = new StepLog();
        return new Workload(() => Chain(group, balls, states, log), 2 * states.Length * Steps);
    }

    private static Simulator Compile(Scene scene) => new(scene, new SolverSettings { Integrator = Integrator.Rk2 });

    private static Workload Single(Simulator simulator, BallState[] states)
    {
        var log = new StepLog();
        return new Workload(
            () =>
            {
                double sum = 0;
                foreach (BallState start in states)
                {
                    BallState s = start;
                    simulator.ResetObstacles();
                    log.Clear();
                    for (int i = 0; i < Steps; i++)
                    {
                        simulator.Step(ref s, H, log);
                    }

                    sum += s.Position.X;
                }

                return sum;
            },
            states.Length * Steps);
    }

    private static Workload Grouped(Simulator simulator, Func<Simulator, BallState[]> starts)
    {
        BallState[] states = starts(simulator);
        var group = new BallGroup(simulator, 1);
        var balls = new BallState[1];
        var log = new StepLog();
        return new Workload(() => Chain(group, balls, states, log), states.Length * Steps);
    }

    /// <summary>Simulates each start in turn, as the first ball of a group; a second one flies 40 m away.</summary>
    private static double Chain(BallGroup group, BallState[] balls, BallState[] states, StepLog log)
    {
        double sum = 0;
        foreach (BallState start in states)
        {
            for (int i = 0; i < balls.Length; i++)
            {
                balls[i] = start;
                balls[i].Position += new Vector3d(0, 0, 40 * i);
            }

            group.SimulatorOf(0).ResetObstacles();
            log.Clear();
            for (int i = 0; i < Steps; i++)
            {
                group.Step(balls, H, log);
            }

            sum += balls[0].Position.X;
        }

        return sum;
    }

    private static Scene WithBodies(double mass)
    {
        var players = new KinematicBodies();
        for (int i = 0; i < 22; i++)
        {
            var shape = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25);
            players.Add($"player {i}", shape, SurfaceMaterial.Boot, mass).MoveTo(StadiumScenes.Place(i), Vector3d.Zero, 0);
        }

        return new Scene { Bodies = players };
    }

    /// <summary>Returns a scene with a crate on the ground, which a ball in front of it pushes along.</summary>
    private static Scene WithCrate() => new()
    {
        Obstacles = [new Obstacle { Name = "crate", Shape = new BoxShape(new Vector3d(0, 0.25, -0.36), new Vector3d(0.5, 0.24, 0.25)), Mass = 4 }],
    };

    private static BallState[] Flights(Simulator simulator) =>
        [.. Enumerable.Range(0, 16).Select(i => simulator.Launch(s_midfield, new Vector3d(1 + (0.1 * i), 12, 2), new Vector3d(20, i, 0)))];

    private static BallState[] Rolls(Simulator simulator) =>
        [.. Enumerable.Range(0, 16).Select(i => simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -3 - (0.1 * i)), new Vector3d(-(3 + (0.1 * i)) / 0.11, 0, 0)))];

    private static BallState[] Presses(Simulator simulator) =>
        [.. Enumerable.Range(0, 16).Select(i => simulator.Launch(new Vector3d(0.01 * i, 0.11, 0.1), new Vector3d(0, 0, -8 - (0.1 * i)), Vector3d.Zero))];

    /// <summary>Simulates balls in the net of a goal: each is kicked there with its own velocity, or moves on.</summary>
    private static Workload Kicked(bool inGroup, bool kicks)
    {
        Simulator simulator = Compile(Pitch.Standard.On(new Scene()));
        BallState[] states = [.. Enumerable.Range(0, 16).Select(i => InNet(simulator, 0.1 * i)).Where(s => s.Motion == MotionState.Airborne)];
        var group = new BallGroup(simulator, 1);
        var balls = new BallState[1];
        var log = new StepLog();
        return new Workload(
            () =>
            {
                double sum = 0;
                foreach (BallState start in states)
                {
                    balls[0] = start;
                    log.Clear();
                    if (kicks)
                    {
                        simulator.Kick(ref balls[0], start.Velocity, start.Spin);
                    }

                    for (int i = 0; i < Steps; i++)
                    {
                        if (inGroup)
                        {
                            group.Step(balls, H, log);
                        }
                        else
                        {
                            simulator.Step(ref balls[0], H, log);
                        }
                    }

                    sum += balls[0].Position.X;
                }

                return sum;
            },
            states.Length * Steps);
    }

    /// <summary>Returns a shot at the goal at the moment when its net has absorbed half of the speed.</summary>
    private static BallState InNet(Simulator simulator, double aside)
    {
        BallState s = simulator.Launch(new Vector3d(aside, 1, -46), new Vector3d(0, 1, -20), Vector3d.Zero);
        var log = new StepLog();
        for (int i = 0; i < 100 && !(s.Velocity.Length < 10); i++)
        {
            simulator.Step(ref s, H, log);
        }

        return s;
    }
}
