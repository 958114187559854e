namespace FootballPhysics.Labs.Stress;

/// <summary>
/// A scene with bodies that turn, drawn from a seed, and built as often as needed: one ball or a group, bodies with and without mass, an engine's
/// colliders, obstacles that the ball pushes, goals, wind.
/// </summary>
internal sealed class AskedHall
{
    private const int IgnoredLayer = 5;

    private readonly Scene _scene;
    private readonly SolverSettings _settings;
    private readonly BallProperties[] _balls;
    private readonly bool _isGroup;
    private readonly IShape[] _engineShapes;
    private readonly double _engineMass;

    public AskedHall(SeededRandom random)
    {
        int balls = random.Chance(0.55) ? 1 : 2 + random.Below(4);
        _isGroup = balls > 1 || random.Chance(0.2);
        bool hasGoals = random.Chance(0.25);
        Ghosts = !hasGoals && random.Chance(0.4) ? 1 + random.Below(2) : 0;
        BallProperties ball = random.Chance(0.7) ? BallProperties.Modern : random.Any(BallProperties.Futsal, BallProperties.BeachBall, BallProperties.MedicineBall);
        ball = ball with { Ignores = Layers.Of(IgnoredLayer) };
        bool isMixed = balls > 1 && random.Chance(0.3);
        _balls = [.. Enumerable.Range(0, balls).Select(i => isMixed && i % 2 == 1 ? BallProperties.YouthFootball with { Ignores = ball.Ignores } : ball)];
        bool weighs = random.Chance(0.35);
        Bodies = [.. Enumerable.Range(0, 1 + random.Below(5)).Select(i => new AskedBody(random, i, weighs))];
        bool hasEngine = random.Chance(0.3);
        _engineMass = random.Chance(0.3) ? random.Log(0.5, 50) : double.PositiveInfinity;
        _engineShapes = [.. Enumerable.Range(0, hasEngine ? 1 + random.Below(3) : 0).Select(_ => AskedBody.AnyShape(random))];
        Scene basis = random.Any(Scene.Default, Scene.Default, Scene.Published, Scene.Measured);
        Scene scene = hasGoals ? Pitch.Cage.On(basis) : basis;
        _scene = scene with
        {
            Ball = ball,
            Air = Air(random, scene.Air),
            Forces = random.Chance(0.15) ? scene.Forces with { KnuckleSeed = random.Below(100) } : scene.Forces,
            Obstacles = [.. scene.Obstacles, .. Obstacles(random)],
        };
        _settings = new SolverSettings { Integrator = random.Chance(0.75) ? Integrator.Rk4 : random.Any(Integrator.Rk2, Integrator.SemiImplicitEuler, Integrator.Euler) };
    }

    /// <summary>The bodies that the ball does not ignore.</summary>
    public AskedBody[] Bodies { get; }

    /// <summary>The number of bodies that the ball ignores; a fresh scene lacks them.</summary>
    public int Ghosts { get; }

    public int Balls => _balls.Length;

    /// <summary>The radius of the largest ball, m.</summary>
    public double LargestRadius => _balls.Max(ball => ball.Radius);

    public int EngineColliders => _engineShapes.Length;

    /// <summary>Builds the scene anew, with new bodies, colliders and simulators.</summary>
    /// <param name="withGhosts">True to add the bodies that the ball ignores.</param>
    public AskedPitch Build(bool withGhosts)
    {
        var bodies = new KinematicBodies();
        foreach (AskedBody body in Bodies)
        {
            bodies.Add(body.Name, body.Shape, SurfaceMaterial.Boot, body.Mass);
        }

        for (int i = 0; withGhosts && i < Ghosts; i++)
        {
            bodies.Add(FormattableString.Invariant($"ghost {i}"), new BoxShape(new Vector3d(0.1, 0.3, 0), new Vector3d(0.4, 0.3, 0.1)), SurfaceMaterial.PublishedSand, layer: IgnoredLayer);
        }

        AskedEngine? engine = _engineShapes.Length > 0 ? new AskedEngine(_engineShapes, _engineMass) : null;
        Scene scene = _scene with { Bodies = bodies, EngineColliders = engine };
        BallGroup? group = _isGroup ? new BallGroup(scene, _balls, _settings) : null;
        return new AskedPitch(group?.SimulatorOf(0) ?? new Simulator(scene, _settings), group, bodies, engine);
    }

    private static Air Air(SeededRandom random, Air air)
    {
        double speed = random.Uniform(1, 8);
        Vector3d along = random.Heading();
        return random.Below(6) switch
        {
            0 or 1 => air with { Wind = speed * along },
            2 => air with { WindField = new WindByHeight(speed, along.X, along.Z, gusts: new Gusts { Seed = random.Below(1000) }) },
            _ => air,
        };
    }

    private static List<Obstacle> Obstacles(SeededRandom random)
    {
        var all = new List<Obstacle>();
        for (int i = random.Chance(0.5) ? 1 + random.Below(3) : 0; i > 0; i--)
        {
            Vector3d foot = random.Uniform(0.5, 3) * random.Heading();
            bool isPushed = random.Chance(0.5);
            all.Add(new Obstacle
            {
                Name = isPushed ? "cone" : "post",
                Shape = random.Chance(0.5)
                    ? new CapsuleShape(foot + new Vector3d(0, 0.1, 0), foot + new Vector3d(0, 0.5, 0), 0.1)
                    : new BoxShape(foot + new Vector3d(0, 0.3, 0), new Vector3d(random.Uniform(0.05, 1), 0.3, 0.1)),
                Mass = isPushed ? random.Log(0.3, 30) : double.PositiveInfinity,
                Velocity = random.Chance(0.3) ? random.Uniform(0, 0.3) * random.Heading() : Vector3d.Zero,
                Spin = random.Chance(0.3) ? random.Uniform(0, 3) * random.Direction() : Vector3d.Zero,
            });
        }

        return all;
    }
}

/// <summary>A scene as it was built: its simulator, its group if it has one, its bodies and its engine.</summary>
internal sealed record AskedPitch(Simulator Simulator, BallGroup? Group, KinematicBodies Bodies, AskedEngine? Engine)
{
    public Simulator SimulatorOf(int ball) => Group?.SimulatorOf(ball) ?? Simulator;

    /// <summary>Steps the balls once.</summary>
    public void Step(BallState[] balls, double dt, StepLog log)
    {
        if (Group is not null)
        {
            Group.Step(balls, dt, log);
        }
        else
        {
            Simulator.Step(ref balls[0], dt, log);
        }
    }

    /// <summary>Computes the paths of all balls.</summary>
    public void LookAhead(BallState[] balls, LookAheadRequest request, Trajectory[] into)
    {
        if (Group is not null)
        {
            Group.LookAhead(balls, request, into);
        }
        else
        {
            Simulator.LookAhead(in balls[0], request, into[0]);
        }
    }

    public FixedStepRunner Runner(double dt) => Group is not null ? new FixedStepRunner(Group, dt) : new FixedStepRunner(Simulator, dt);
}

/// <summary>Colliders of an engine that are told where they are for each step.</summary>
internal sealed class AskedEngine : IEngineColliders
{
    private readonly EngineCollider[] _colliders;
    private readonly double[] _bounds;
    private readonly AskedPose[] _poses;

    public AskedEngine(IShape[] shapes, double mass)
    {
        _colliders = [.. shapes.Select((shape, i) => new EngineCollider(FormattableString.Invariant($"thing {i}"), shape, SurfaceMaterial.Wood) { Mass = mass })];
        _bounds = [.. shapes.Select(shape => Math.Max(shape.Bounds.Min.Length, shape.Bounds.Max.Length))];
        _poses = new AskedPose[shapes.Length];
    }

    public double Time { get; private set; }

    public double MaximumSpeed { get; private set; }

    public void Put(AskedPose[] poses, double time)
    {
        poses.CopyTo(_poses, 0);
        Time = time;
        MaximumSpeed = Enumerable.Range(0, poses.Length).Max(i => poses[i].Velocity.Length + (_bounds[i] * poses[i].Spin.Length));
        for (int i = 0; i < poses.Length; i++)
        {
            _colliders[i].MoveTo(poses[i].Position, poses[i].Orientation, poses[i].Velocity, poses[i].Spin);
        }
    }

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        for (int i = 0; i < _colliders.Length; i++)
        {
            Vector3d way = _poses[i].Position - cast.From;
            double along = Math.Clamp(Vector3d.Dot(way, cast.Direction), 0, cast.Distance);
            if ((way - (along * cast.Direction)).Length <= _bounds[i] + cast.Radius)
            {
                hits.Add(_colliders[i]);
            }
        }
    }
}
