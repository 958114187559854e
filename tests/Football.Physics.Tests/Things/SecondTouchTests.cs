namespace FootballPhysics.Tests.Things;

/// <summary>A ball that rebounds and is shot at once: each impact obeys the impact law, however soon after another one, and nothing of it stays in the state.</summary>
public sealed class SecondTouchTests
{
    private const double Restitution = 0.6;
    private const double Speed = 9;
    private const double BootSpeed = 8;
    private static readonly Vector3d s_half = new(0.05, 0.5, 0.5);
    private static readonly BoxShape s_box = new(default, s_half);
    private static readonly SurfaceMaterial s_smooth = new()
    {
        NormalRestitution = Restitution,
        RestitutionSpeedScale = double.PositiveInfinity,
        GrazingRestitutionGain = 0,
        ImpactFriction = 0,
        TangentialRestitution = 0,
        TorsionalPatchRadius = 0,
    };

    public static TheoryData<string, string, double, double, bool> Cases
    {
        get
        {
            var cases = new TheoryData<string, string, double, double, bool>();
            int count = 0;
            foreach (string leg in new[] { "plain", "creeps", "body", "engine", "light" })
            {
                foreach (string boot in new[] { "obstacle", "body", "engine" })
                {
                    foreach (double step in new[] { 0.002, 1.0 / 60, 0.05 })
                    {
                        cases.Add(leg, boot, double.PositiveInfinity, step, count++ % 2 == 1);
                        cases.Add(leg, boot, 1.9, step, count++ % 2 == 0);
                    }
                }
            }

            return cases;
        }
    }

    /// <summary>The ball leaves a leg at −5.4 m/s, and a boot of mass M at 8 m/s meets it 22 ms later: v' = v + (1 + e) (u − v) M/(m + M), 16.04 m/s for a boot that the ball cannot move.</summary>
    [Theory]
    [MemberData(nameof(Cases))]
    public void A_shot_after_a_rebound_obeys_the_impact_law(string leg, string boot, double mass, double step, bool inGroup)
    {
        const double Between = 0.3;
        double back = leg == "light" ? Speed - ((1 + Restitution) * Speed * 3 / (3 + BallProperties.Tunnel.Mass)) : -Restitution * Speed;
        double meets = (0.3 / Speed) + (Between / (BootSpeed - back));
        Vector3d standing = new(0.16, 0, 0);
        Vector3d running = new(-0.16 + (back * Between / (BootSpeed - back)) - (BootSpeed * meets), 0, 0);
        var table = new Table();
        table.Add("leg", leg == "light" ? "obstacle" : leg, standing, leg == "creeps" ? new Vector3d(0, 0, 0.001) : default, leg == "light" ? 3 : double.PositiveInfinity);
        table.Add("boot", boot, running, new Vector3d(BootSpeed, 0, 0), mass);
        double share = double.IsInfinity(mass) ? 1 : mass / (mass + BallProperties.Tunnel.Mass);
        Assert.Equal(back + ((1 + Restitution) * share * (BootSpeed - back)), table.SpeedAfterBoot(step, inGroup), 1e-6);
    }

    /// <summary>A look-ahead predicts the same impacts as the steps.</summary>
    [Fact]
    public void A_look_ahead_obeys_it_too()
    {
        var table = new Table();
        table.Add("leg", "creeps", new Vector3d(0.16, 0, 0), new Vector3d(0, 0, 0.001), double.PositiveInfinity);
        table.Add("boot", "obstacle", new Vector3d(-0.8, 0, 0), new Vector3d(BootSpeed, 0, 0), double.PositiveInfinity);
        Simulator simulator = table.Build();
        BallState ball = Table.Start(simulator);
        var path = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.3, StopAt = StopAt.Time }, path);
        Assert.Equal(16.04, path.VelocityAt(0.065).X, 1e-6);
    }

    /// <summary>The 24 bytes hold every state from the tick after a touch on, and give back the same bits.</summary>
    [Theory]
    [InlineData("head")]
    [InlineData("stands")]
    [InlineData("cone")]
    [InlineData("engine")]
    public void The_24_bytes_hold_each_state_after_a_touch(string kind)
    {
        var shape = new SphereShape(default, 0.11);
        var bodies = new KinematicBodies();
        KinematicBody? head = kind is "head" or "stands" ? bodies.Add("head", shape, SurfaceMaterial.Head) : null;
        var engine = new ShapesAsEngine();
        engine.Add("head", new SphereShape(new Vector3d(0, 1.5, 0.1), 0.11));
        var cone = new Obstacle { Name = "head", Shape = new SphereShape(new Vector3d(0, 1.5, 0.1), 0.11), Mass = 5 };
        Scene scene = Scene.Default with { Bodies = bodies, EngineColliders = kind == "engine" ? engine : null, Obstacles = kind == "cone" ? [cone] : [] };
        var runner = new FixedStepRunner(new Simulator(scene), timeStep: 1.0 / 60) { QuantizationInterval = 1 };
        Vector3d velocity = kind == "head" ? new Vector3d(0, 0.5, -1.5) : default;
        runner.MoveBodies = time => head?.MoveTo(new Vector3d(0, 1.4, kind == "head" ? 0.6 : 0.1) + (time * velocity), velocity, time);
        runner.Place(new Vector3d(0, 3, 0));
        bool isTouched = false;
        int ticks = 0;
        var bytes = new byte[Snapshot.QuantizedSize];
        for (int i = 0; i < 80; i++)
        {
            runner.Step();
            if (isTouched)
            {
                ticks++;
                Assert.True(runner.TryWriteQuantized(runner.State, bytes), $"tick {runner.Tick}: {runner.State}");
                Assert.True(Snapshot.Same(runner.State, runner.ReadQuantized(bytes)));
            }

            foreach (BallEvent item in runner.Events)
            {
                isTouched |= item.Kind == BallEventKind.Impact && runner.Simulator.NameOf(item.ColliderIndex) == "head";
            }
        }

        Assert.InRange(ticks, 20, 80);
    }

    /// <summary>Objects in empty space: obstacles, bodies that the game moves, and the colliders of an engine.</summary>
    private sealed class Table : IEngineColliders
    {
        private readonly KinematicBodies _bodies = new();
        private readonly List<Obstacle> _obstacles = [];
        private readonly List<Action<double>> _moves = [];
        private readonly List<EngineCollider> _colliders = [];

        public double Time { get; set; }

        public double MaximumSpeed => BootSpeed;

        public static BallState Start(Simulator simulator) => simulator.Launch(new Vector3d(-0.3, 0, 0), new Vector3d(Speed, 0, 0), default);

        public void Add(string name, string kind, Vector3d at, Vector3d velocity, double mass)
        {
            if (kind == "body")
            {
                KinematicBody body = _bodies.Add(name, s_box, s_smooth, mass);
                _moves.Add(time => body.MoveTo(at + (time * velocity), velocity, time));
            }
            else if (kind == "engine")
            {
                var collider = new EngineCollider(name, s_box, s_smooth) { Mass = mass };
                _colliders.Add(collider);
                _moves.Add(time => collider.MoveTo(at + (time * velocity), Quaterniond.Identity, velocity, default));
            }
            else
            {
                _obstacles.Add(new Obstacle { Name = name, Shape = new BoxShape(at, s_half), Surface = s_smooth, Velocity = velocity, Mass = mass });
            }
        }

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            foreach (EngineCollider collider in _colliders)
            {
                hits.Add(collider);
            }
        }

        public Simulator Build() => new(new Scene
        {
            Ball = BallProperties.Tunnel,
            Air = new Air { Density = 0 },
            Gravity = 0,
            Ground = Ground.None,
            Obstacles = _obstacles,
            Bodies = _bodies,
            EngineColliders = _colliders.Count > 0 ? this : null,
        });

        /// <summary>Returns the ball's speed after the boot; NaN if they do not meet.</summary>
        public double SpeedAfterBoot(double step, bool inGroup)
        {
            Simulator simulator = Build();
            BallGroup? group = inGroup ? new BallGroup(simulator, 2) : null;
            BallState[] balls = [Start(simulator), simulator.Launch(new Vector3d(0, 0, 40), default, default)];
            var log = new StepLog();
            for (int i = 0; i < 0.2 / step; i++)
            {
                Time = balls[0].Time;
                _moves.ForEach(move => move(Time));
                log.Clear();
                if (group is not null)
                {
                    group.Step(balls, step, log);
                }
                else
                {
                    simulator.Step(ref balls[0], step, log);
                }

                foreach (BallEvent item in log.Events)
                {
                    if (item.Kind == BallEventKind.Impact && simulator.NameOf(item.ColliderIndex) == "boot")
                    {
                        return item.Velocity.X;
                    }
                }
            }

            return double.NaN;
        }
    }
}
