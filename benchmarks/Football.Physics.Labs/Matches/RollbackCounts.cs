namespace FootballPhysics.Labs.Matches;

/// <summary>Compares matches whose kicks arrive late, at frames of several lengths, with the same matches and all kicks in time.</summary>
internal static class RollbackCounts
{
    private const int Ticks = 200;
    private const int MostLate = 8;
    private const int MostSteps = 12;
    private static readonly double[] Frames = [0.01, 1 / 30.0, 0.1, 0];

    /// <summary>The kind of moving objects, and the source of their positions.</summary>
    private enum Kind
    {
        CallbackBodies,
        KeptBodies,
        CallbackEngine,
        SeveralBalls,
        Hall,
    }

    /// <summary>The number of ticks between two roundings to the wire form, in a hall.</summary>
    private const int HallWireTicks = 6;

    /// <summary>Simulates the matches.</summary>
    /// <param name="run">The run that receives the table.</param>
    /// <param name="count">The number of matches with bodies; the other kinds have a quarter each.</param>
    /// <param name="inHalls">True to add as many matches in a cage with nets, wind and kicks at the goals, rounded to the wire form.</param>
    public static void Play(LabRun run, int count, bool inHalls = false)
    {
        LabTable table = run.Table("Late kicks among 22 moving players: balls that end elsewhere than in time", "what moves", "matches", "runs", "kicks", "late", "balls apart", "verdict");
        Kind[] kinds = [Kind.CallbackBodies, Kind.KeptBodies, Kind.CallbackEngine, Kind.SeveralBalls, .. inHalls ? (Kind[])[Kind.Hall] : []];
        for (int k = 0; k < kinds.Length; k++)
        {
            var counts = new LabCounts();

            // All matches for bodies and halls, a quarter of them for the other kinds.
            int matches = kinds[k] is Kind.CallbackBodies or Kind.Hall ? count : Math.Max(1, count / 4);
            for (int i = 0; i < matches; i++)
            {
                int kind = k;
                run.Progress.Report((k * count) + i, kinds.Length * count, () => Name(kinds[kind]));
                Play(kinds[k], run.Random((k * 1_000_003L) + i), counts);
            }

            table.Judge(counts["balls apart"] == 0, [Name(kinds[k]), matches, .. counts.Cells("runs", "kicks", "late", "balls apart")]);
        }

        table.Judge(RefusesUnknown(engine: false) & RefusesUnknown(engine: true), "nobody says where: refused by name", 2, 2, null, null, null);
    }

    private static string Name(Kind kind) => kind switch
    {
        Kind.CallbackBodies => "bodies, by MoveBodies",
        Kind.KeptBodies => "bodies, as the rollback kept them",
        Kind.CallbackEngine => "an engine's colliders, by MoveBodies",
        Kind.SeveralBalls => "bodies and three balls, by MoveBodies",
        _ => "bodies in a cage with nets and wind, by MoveBodies, wire form",
    };

    private static void Play(Kind kind, SeededRandom random, LabCounts counts)
    {
        var squad = new Squad(random);
        KickInput[] all = Kicks(random, kind == Kind.SeveralBalls ? 3 : 1, kind == Kind.Hall ? 25 : 9);
        int[] delays = [.. all.Select(_ => 1 + random.Below(MostLate))];
        counts.Add("kicks", all.Length);

        // Reference: kicks in time, one tick at a time.
        FixedStepRunner inTime = Runner(kind, squad);
        foreach (KickInput kick in all)
        {
            inTime.Kicks.Add(in kick);
        }

        // A frame may advance the other runners beyond the last tick.
        var states = new BallState[Ticks + MostSteps + 1][];
        while (inTime.Tick < states.Length)
        {
            states[inTime.Tick] = [.. Enumerable.Range(0, inTime.Balls).Select(inTime.StateOf)];
            Step(kind, squad, inTime);
        }

        // If the rollback stores the bodies, the game moves them itself once per tick, so there is only one frame rate.
        foreach (double frame in kind == Kind.KeptBodies ? Frames[..1] : Frames)
        {
            FixedStepRunner runner = Runner(kind, squad);
            var rollback = new Rollback(runner, MostLate + 20);
            int next = 0;
            while (runner.Tick < Ticks)
            {
                for (; next < all.Length && all[next].Tick + delays[next] <= runner.Tick; next++)
                {
                    counts.AddIf(rollback.ApplyKick(in all[next]) is not null, "late");
                }

                if (frame == Frames[0])
                {
                    Step(kind, squad, runner);
                }
                else
                {
                    runner.Advance(frame > 0 ? frame : random.Uniform(0.001, 0.12));
                }
            }

            for (; next < all.Length; next++)
            {
                counts.AddIf(rollback.ApplyKick(in all[next]) is not null, "late");
            }

            counts.Add("runs");
            for (int ball = 0; ball < runner.Balls; ball++)
            {
                BallState one = runner.StateOf(ball);
                counts.AddIf(!Snapshot.Same(in one, in states[runner.Tick][ball]), "balls apart");
            }
        }
    }

    private static void Step(Kind kind, Squad squad, FixedStepRunner runner)
    {
        if (kind == Kind.KeptBodies)
        {
            squad.MoveTo(runner.Time);
        }

        runner.Step();
    }

    private static FixedStepRunner Runner(Kind kind, Squad squad)
    {
        Scene scene = kind == Kind.Hall ? Pitch.Cage.On(Scene.Default with { Air = new Air { Wind = new Vector3d(3, 0, 6) } }) : Pitch.Standard.On(Scene.Default);
        scene = kind == Kind.CallbackEngine ? scene with { EngineColliders = squad.NewEngine() } : scene with { Bodies = squad.NewBodies() };
        var simulator = new Simulator(scene);
        FixedStepRunner runner = kind == Kind.SeveralBalls ? new FixedStepRunner(new BallGroup(simulator, 3)) : new FixedStepRunner(simulator);
        runner.QuantizationInterval = kind == Kind.Hall ? HallWireTicks : 0;
        runner.MoveBodies = kind == Kind.KeptBodies ? null : squad.Mover();
        return runner;
    }

    /// <summary>Draws a kick at every second tick.</summary>
    private static KickInput[] Kicks(SeededRandom random, int balls, double fastest) =>
    [
        .. Enumerable.Range(0, (Ticks / 2) - 1).Select(i => new KickInput(
            2 * i,
            new Vector3d(random.Uniform(-9, 9), random.Uniform(0, 4), random.Uniform(-fastest, fastest)),
            new Vector3d(random.Uniform(-40, 40), random.Uniform(-40, 40), 0),
            random.Below(22),
            random.Below(balls))),
    ];

    /// <summary>True if a rollback rejects a late kick when objects moved and their earlier positions are unknown.</summary>
    private static bool RefusesUnknown(bool engine)
    {
        var squad = new Squad(new SeededRandom(5UL));
        Scene scene = engine ? Scene.Default with { EngineColliders = squad.NewEngine() } : Scene.Default with { Bodies = squad.NewBodies() };
        var runner = new FixedStepRunner(new Simulator(scene));
        var rollback = new Rollback(runner, 16, keepsBodies: engine);
        Action<double> move = squad.Mover();
        for (int i = 0; i < 12; i++)
        {
            move(runner.Time);
            runner.Step();
        }

        try
        {
            rollback.ApplyKick(new KickInput(4, new Vector3d(0, 3, -9), Vector3d.Zero));
            return false;
        }
        catch (InvalidOperationException refusal)
        {
            return refusal.Message.StartsWith(engine ? "Engine colliders" : "Bodies", StringComparison.Ordinal);
        }
    }
}

/// <summary>Twenty-two players who run in curves, as bodies or as the colliders of an engine.</summary>
internal sealed class Squad
{
    private const int Players = 22;
    private readonly (Vector3d Middle, double Radius, double Rate, double Phase)[] _curves;
    private KinematicBodies? _bodies;
    private Engine? _engine;

    public Squad(SeededRandom random) => _curves = [.. Enumerable.Range(0, Players).Select(_ =>
    {
        var middle = new Vector3d(random.Uniform(-7, 7), 0, random.Uniform(-7, 7));
        double radius = random.Uniform(0.3, 3);
        return (middle, radius, random.Uniform(0.3, 7) / radius * (random.Chance(0.5) ? 1 : -1), random.Uniform(0, 6.28));
    })];

    /// <summary>Creates bodies for a scene: half of them with a mass.</summary>
    public KinematicBodies NewBodies()
    {
        _bodies = new KinematicBodies();
        for (int i = 0; i < Players; i++)
        {
            _bodies.Add("player", i % 2 == 0 ? BodyKind.Player : BodyKind.Player with { Mass = double.PositiveInfinity });
        }

        MoveTo(0);
        return _bodies;
    }

    /// <summary>Creates colliders for a scene.</summary>
    public IEngineColliders NewEngine()
    {
        _engine = new Engine(this);
        return _engine;
    }

    /// <summary>Moves the bodies or colliders that were created last to a time.</summary>
    public void MoveTo(double time) => Mover()(time);

    /// <summary>Returns a function that moves the bodies or colliders that were created last.</summary>
    public Action<double> Mover()
    {
        KinematicBodies? bodies = _bodies;
        Engine? engine = _engine;
        return time =>
        {
            for (int i = 0; i < Players && bodies is not null; i++)
            {
                (Vector3d place, Vector3d velocity) = At(i, time);
                bodies[i].MoveTo(place, velocity, time);
            }

            if (engine is not null)
            {
                engine.Time = time;
            }
        };
    }

    private (Vector3d Place, Vector3d Velocity) At(int player, double time)
    {
        (Vector3d middle, double radius, double rate, double phase) = _curves[player];
        double angle = phase + (rate * time);
        var out_ = new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
        return (middle + (radius * out_), radius * rate * new Vector3d(-out_.Z, 0, out_.X));
    }

    /// <summary>An engine with a capsule per player, which reports those near a path.</summary>
    private sealed class Engine(Squad squad) : IEngineColliders
    {
        private readonly EngineCollider[] _colliders =
            [.. Enumerable.Range(0, Players).Select(i => new EngineCollider("player", BodyKind.Player.Shape, SurfaceMaterial.Boot) { Mass = i % 2 == 0 ? 75 : double.PositiveInfinity })];

        public double Time { get; set; }

        public double MaximumSpeed => 8;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            for (int i = 0; i < Players; i++)
            {
                (Vector3d place, Vector3d velocity) = squad.At(i, Time);
                Vector3d way = cast.Distance * cast.Direction;
                double share = way.LengthSquared > 0 ? Math.Clamp(Vector3d.Dot(place - cast.From, way) / way.LengthSquared, 0, 1) : 0;
                if ((place - (cast.From + (share * way))).Horizontal.Length < cast.Radius + 2.0)
                {
                    _colliders[i].MoveTo(place, Quaterniond.Identity, velocity, Vector3d.Zero);
                    hits.Add(_colliders[i]);
                }
            }
        }
    }
}
