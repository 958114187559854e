namespace FootballPhysics.Labs.People;

/// <summary>Spheres of an engine that lie about a pitch; every second one moves. They throw after very many sphere casts, to end a step that never ends.</summary>
internal sealed class StadiumSpheres : IEngineColliders
{
    private const double Fastest = 6;

    /// <summary>The distance of the spheres from the ends of the pitch, m.</summary>
    private const double Margin = 4;
    private const double EndMargin = 7;

    /// <summary>The limit of sphere casts; five balls at their 8 192 pieces need a fraction of it per step or look-ahead.</summary>
    private const long MostCasts = 400_000;

    private readonly double _halfWidth;
    private readonly double _halfLength;
    private readonly EngineCollider[] _colliders;
    private readonly double[] _radii;
    private readonly Vector3d[] _velocities;
    private readonly Vector3d[] _places;
    private long _castsLeft = long.MaxValue;

    /// <summary>Places spheres on a pitch.</summary>
    /// <param name="count">The number of spheres.</param>
    /// <param name="random">The random numbers.</param>
    /// <param name="halfWidth">Half the width of the pitch, m.</param>
    /// <param name="halfLength">Half the length of the pitch, m.</param>
    /// <param name="mass">Mass of each, kg; default infinite.</param>
    public StadiumSpheres(int count, SeededRandom random, double halfWidth = 34, double halfLength = 52, double mass = double.PositiveInfinity)
    {
        _halfWidth = halfWidth;
        _halfLength = halfLength;
        _colliders = new EngineCollider[count];
        _radii = new double[count];
        _velocities = new Vector3d[count];
        _places = new Vector3d[count];
        for (int i = 0; i < count; i++)
        {
            _radii[i] = random.Uniform(0.1, 0.6);
            _colliders[i] = new EngineCollider(FormattableString.Invariant($"sphere {i}"), new SphereShape(Vector3d.Zero, _radii[i]), SurfaceMaterial.Wood) { Mass = mass };
            double x = random.Uniform(Margin - halfWidth, halfWidth - Margin);
            double y = (_radii[i] * random.Uniform(0.8, 1)) + random.Uniform(0, 2.2);
            _places[i] = new Vector3d(x, y, random.Uniform(EndMargin - halfLength, halfLength - EndMargin));
            _velocities[i] = i % 2 == 0 ? Vector3d.Zero : random.Uniform(0.5, 5) * random.Heading();
        }
    }

    public double Time { get; set; }

    public double MaximumSpeed => Count > 0 ? Fastest : 0;

    public int Count => _colliders.Length;

    /// <summary>Starts to count the casts of the next step or look-ahead.</summary>
    public void Begin() => _castsLeft = MostCasts;

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        if (--_castsLeft < 0)
        {
            throw new TimeoutException($"more than {MostCasts} sphere casts in one call");
        }

        for (int i = 0; i < _colliders.Length; i++)
        {
            Vector3d way = _places[i] - cast.From;
            double along = Math.Clamp(Vector3d.Dot(way, cast.Direction), 0, cast.Distance);
            if ((way - (along * cast.Direction)).Length <= _radii[i] + cast.Radius)
            {
                _colliders[i].MoveTo(_places[i], Quaterniond.Identity, _velocities[i], Vector3d.Zero);
                hits.Add(_colliders[i]);
            }
        }
    }

    /// <summary>Moves the spheres by a frame, and reflects them at the boards.</summary>
    public void Move(double duration)
    {
        for (int i = 0; i < _places.Length; i++)
        {
            Vector3d to = _places[i] + (duration * _velocities[i]);
            Vector3d v = _velocities[i];
            double x = Math.Abs(to.X) > _halfWidth ? -Math.Sign(to.X) * Math.Abs(v.X) : v.X;
            double z = Math.Abs(to.Z) > _halfLength ? -Math.Sign(to.Z) * Math.Abs(v.Z) : v.Z;
            _velocities[i] = new Vector3d(x, 0, z);
            _places[i] = to;
        }
    }

    /// <summary>Returns the distance from the nearest of their surfaces, a time after the frame began.</summary>
    public double Distance(Vector3d place, double after) => Distance(place, after, 1);

    /// <summary>Returns the distance from the nearest surface of the spheres that never move, which is every second one.</summary>
    public double ToStanding(Vector3d place) => Distance(place, 0, 2);

    private double Distance(Vector3d place, double after, int every)
    {
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < _places.Length; i += every)
        {
            nearest = Math.Min(nearest, (place - (_places[i] + (after * _velocities[i]))).Length - _radii[i]);
        }

        return nearest;
    }

    /// <summary>Stops all of them.</summary>
    public void Stop() => Array.Clear(_velocities);

    /// <summary>Returns their positions and velocities, for a later restore.</summary>
    public (Vector3d[] Places, Vector3d[] Velocities) Keep() => ([.. _places], [.. _velocities]);

    /// <summary>Restores their positions and velocities.</summary>
    public void Restore((Vector3d[] Places, Vector3d[] Velocities) kept)
    {
        kept.Places.CopyTo(_places, 0);
        kept.Velocities.CopyTo(_velocities, 0);
    }
}
