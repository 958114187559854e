namespace FootballPhysics.Labs.Matches;

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
