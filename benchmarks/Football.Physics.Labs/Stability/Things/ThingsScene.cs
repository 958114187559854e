namespace FootballPhysics.Labs.Stability.Things;

/// <summary>A scene with objects, and a shot among them, all from one number. Its mirror image in x has the same numbers, except for their signs.</summary>
internal sealed class ThingsScene
{
    private const double Radius = 0.11;

    private readonly SeededRandom _random;
    private readonly SeededRandom _motion;
    private readonly double _sign;

    /// <summary>The objects, without the shot.</summary>
    private Scene Scene { get; }

    /// <summary>Draws a scene.</summary>
    /// <param name="seed">Seed.</param>
    /// <param name="index">The number of the scene.</param>
    /// <param name="mirrored">True for its mirror image.</param>
    public ThingsScene(long seed, long index, bool mirrored)
    {
        _random = new SeededRandom(SeededRandom.Mix(seed, index));
        _motion = new SeededRandom(SeededRandom.Mix(seed, ~index));
        _random.Next();
        _sign = mirrored ? -1 : 1;
        int kinds = Enum.GetValues<ThingsKind>().Length;
        Kind = (ThingsKind)(index % kinds);
        Integrator integrator = _random.Any(Integrator.Rk4, Integrator.Rk4, Integrator.Rk2, Integrator.SemiImplicitEuler, Integrator.Euler);
        int count = Kind == ThingsKind.Nets ? _random.Below(6) : 1 + _random.Below(60);
        Obstacle[] obstacles = [.. Enumerable.Range(0, count).Select(_ => DrawObstacle(Kind == ThingsKind.Moving && _random.Chance(0.3)))];
        Ground ground = DrawGround();
        Scene = Scene.Published with
        {
            Ground = ground,
            Obstacles = obstacles,
            Goals = Kind == ThingsKind.Nets ? [new Goal { Center = Polar(new Vector3d(_random.Uniform(-2, 2), 0, -8)), Facing = Polar(new Vector3d(_random.Uniform(-0.4, 0.4), 0, 1)) }] : [],
            Nets = Kind == ThingsKind.Nets && _random.Chance(0.5)
                ? [new Net { Center = Place(1), Normal = Polar(new Vector3d(_random.Uniform(-1, 1), 0, 1)), Along = Vector3d.Up, HalfLength = 1, HalfWidth = 2 }]
                : [],
            Bodies = Kind == ThingsKind.Bodies ? DrawBodies() : null,
        };
        Vector3d position = FreePlace();
        Vector3d velocity = Polar(new Vector3d(_random.Uniform(-25, 25), _random.Uniform(-8, 15), _random.Uniform(-40, 10)));
        if ((obstacles.Length > 0 || Kind == ThingsKind.Nets) && _random.Chance(0.6))
        {
            // Aim at one of the objects, or into the goal.
            Vector3d at = Polar(new Vector3d(_random.Uniform(-2, 2), _random.Uniform(0.2, 2), -8));
            Bounds3d box = Kind == ThingsKind.Nets ? new Bounds3d(in at, in at) : obstacles[_random.Below(obstacles.Length)].Shape.Bounds;
            Vector3d way = (0.5 * (box.Min + box.Max)) - position;
            double size = _random.Log(5, 60);
            velocity = way.IsFinite ? (size / way.Length * way) + new Vector3d(0, 4.9 * way.Length / size, 0) : velocity;
        }

        Vector3d spin = Axial(_random.Log(0.1, 100) * _random.Direction());
        double frame = _random.Any(0.005, 0.01, 1.0 / 60, 0.04, 0.1);
        Shot = new StressScene
        {
            Number = index,
            Scene = Scene,
            Settings = new SolverSettings { Integrator = integrator },
            Position = position,
            Velocity = velocity,
            Spin = spin,
            Frames = [.. Enumerable.Repeat(frame, (int)Math.Min(200, 3 / frame))],
        };
    }

    public ThingsKind Kind { get; }

    /// <summary>The scene, the shot and its frames.</summary>
    public StressScene Shot { get; }

    /// <summary>True if the mirror image has the same numbers: on uneven ground the two sides round differently.</summary>
    public bool HasMirrorImage => Kind != ThingsKind.Hills;

    /// <summary>Returns the mirror image of a vector in a mirrored scene.</summary>
    public Vector3d Polar(Vector3d v) => new(_sign * v.X, v.Y, v.Z);

    /// <summary>Moves the bodies, as a game would before a frame.</summary>
    public void MoveBodies(double time)
    {
        foreach (KinematicBody body in Scene.Bodies ?? [])
        {
            Vector3d jump = _motion.Chance(0.05) ? _motion.Log(0.01, 5) * _motion.Direction() : Vector3d.Zero;
            Vector3d change = _motion.Log(0.1, 3) * _motion.Direction();
            Vector3d spin = _motion.Chance(0.1) ? 5 * _motion.Direction() : Vector3d.Zero;

            // Start from the reached position and velocity, with a small unexpected change.
            Vector3d velocity = (0.9 * body.Velocity) + Polar(change);
            Vector3d place = body.Position + ((time - body.Time) * body.Velocity) + Polar(jump);
            body.MoveTo(new Vector3d(place.X, Math.Max(0, place.Y), place.Z), body.Orientation, velocity, Axial(spin), time);
        }
    }

    private Vector3d Axial(Vector3d v) => new(v.X, _sign * v.Y, _sign * v.Z);

    private Vector3d Place(double height) => Polar(new Vector3d(_random.Uniform(-9, 9), _random.Uniform(0.7, 0.7 + height), _random.Uniform(-9, 9)));

    private Vector3d FreePlace()
    {
        while (true)
        {
            Vector3d place = Place(4);
            bool above = Scene.Ground.Heights is { } heights ? heights.At(in place).Distance > Radius + 0.01
                : Vector3d.Dot(in place, Scene.Ground.Normal) > (Radius + 0.01) * Scene.Ground.Normal.Length;
            if (above && Scene.Obstacles.Concat(Scene.Goals.SelectMany(goal => goal.Frame(Scene.Forces))).All(item => item.Shape.At(place).Distance > Radius + 0.01)
                && (Scene.Bodies ?? []).All(body => (body.Position - place).Length > 1))
            {
                return place;
            }
        }
    }

    private Ground DrawGround()
    {
        Ground flat = Ground.PublishedTurf with
        {
            Material = SurfaceMaterial.PublishedTurf with
            {
                ImpactFriction = _random.Any(double.PositiveInfinity, 1.2, _random.Uniform(0, 1)),
                NormalRestitution = _random.Uniform(0, 0.95),
                SlidingFriction = _random.Uniform(0.05, 1),
                RollingResistance = _random.Log(0.003, 0.2),
                TorsionalPatchRadius = _random.Any(0, 0.02),
            },
            Aerodynamics = _random.Any(GroundAerodynamics.Horizontal, GroundAerodynamics.None, GroundAerodynamics.Full),
        };
        if (Kind == ThingsKind.Slopes)
        {
            return flat with { Normal = Polar(new Vector3d(_random.Uniform(-0.4, 0.4), 1, _random.Uniform(-0.4, 0.4))) };
        }

        return Kind == ThingsKind.Hills ? flat with { Heights = LabMath.Hills(-13, -13, 2, 14, (_, _) => _random.Uniform(0, 0.5)) } : flat;
    }

    private SurfaceMaterial DrawSurface() => SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = _random.Any(0, 1, _random.Next()),
        TangentialRestitution = _random.Uniform(-1, 1),
        SpinRestitution = _random.Next(),
        ImpactFriction = _random.Any(0, double.PositiveInfinity, _random.Uniform(0, 1.5)),
        SlidingFriction = _random.Uniform(0, 1),
        RollingResistance = _random.Log(0.003, 0.3),
    };

    private Obstacle DrawObstacle(bool moves)
    {
        if (!moves && _random.Chance(0.05))
        {
            // Walls around the scene.
            Vector3d normal = _random.Any(new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0));
            return new Obstacle { Name = "wall", Shape = new PlaneShape(Polar(-13 * normal), Polar(normal)), Surface = DrawSurface() };
        }

        return new Obstacle
        {
            Name = "thing",
            Shape = DrawShape(Place(2)),
            Surface = DrawSurface(),
            Velocity = moves ? Polar(_random.Log(0.1, 12) * _random.Heading()) : Vector3d.Zero,
        };
    }

    private IShape DrawShape(Vector3d at)
    {
        switch (_random.Below(3))
        {
            case 0:
                return new SphereShape(at, _random.Log(0.02, 0.6));
            case 1:
                return new CapsuleShape(at, at + Polar(_random.Log(0.1, 3) * _random.Direction()), _random.Log(0.005, 0.3));
            default:
                Quaterniond turn = Quaterniond.FromAxisAngle(_random.Direction(), _random.Uniform(0, 3));
                var half = new Vector3d(_random.Log(0.01, 1), _random.Log(0.01, 1), _random.Log(0.01, 1));
                return new BoxShape(at, half, new Quaterniond(turn.X, _sign * turn.Y, _sign * turn.Z, turn.W));
        }
    }

    private KinematicBodies DrawBodies()
    {
        var bodies = new KinematicBodies();
        int count = 1 + _random.Below(8);
        for (int i = 0; i < count; i++)
        {
            bodies.Add("body", DrawShape(Vector3d.Zero), DrawSurface());
        }

        foreach (KinematicBody body in bodies)
        {
            body.MoveTo(Place(1), Polar(_random.Log(0.1, 10) * _random.Direction()), 0);
        }

        return bodies;
    }
}

/// <summary>The kinds of scenes with objects.</summary>
internal enum ThingsKind
{
    /// <summary>Standing spheres, capsules, boxes and walls.</summary>
    Obstacles,

    /// <summary>As above, some of them in steady motion.</summary>
    Moving,

    /// <summary>As above, some of them moved by the game, before every frame and to any position.</summary>
    Bodies,

    /// <summary>Goals and free nets.</summary>
    Nets,

    /// <summary>Objects on a tilted pitch.</summary>
    Slopes,

    /// <summary>Objects on uneven ground.</summary>
    Hills,
}
