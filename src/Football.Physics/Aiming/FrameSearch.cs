namespace Football.Physics;

/// <summary>What the thesis' methods share: flights in the game's own frames, judged by the closest point between frames.</summary>
internal ref struct FrameSearch
{
    /// <summary>The closest point between frames is a little off the true one: methods end this far inside the tolerance.</summary>
    public const double Margin = 0.9;

    private const double Degree = Math.PI / 180.0;

    private readonly AimContext _context;
    private readonly double _speed;
    private readonly double _tolerance;
    private readonly Vector3d _left;
    private Kick _best;
    private double _bestMiss;

    public FrameSearch(AimContext context, AimRequest request, double top, double side)
    {
        _context = context;
        _speed = request.Speed;
        _tolerance = request.Tolerance;
        From = context.Start(request);
        Target = request.Target;
        Forward = AimContext.Forward(From, Target, out double distance);
        Distance = distance;
        _left = new Vector3d(Forward.Z, 0, -Forward.X);
        LowestElevation = request.MinimumElevation * Degree;
        HighestElevation = request.MaximumElevation * Degree;
        Kick = new Kick { Top = top, Side = side };
        Miss = double.PositiveInfinity;
        _bestMiss = double.PositiveInfinity;
        _best = Kick;
        Closest = From;
    }

    public Vector3d From { get; }

    public Vector3d Target { get; }

    /// <summary>Horizontal unit direction of the target.</summary>
    public Vector3d Forward { get; }

    /// <summary>Horizontal distance of the target, m.</summary>
    public double Distance { get; }

    public double LowestElevation { get; }

    public double HighestElevation { get; }

    /// <summary>The last kick.</summary>
    public Kick Kick { get; private set; }

    /// <summary>Its closest point between frames.</summary>
    public Vector3d Closest { get; private set; }

    /// <summary>Its miss between frames.</summary>
    public double Miss { get; private set; }

    public void Fly(in Kick kick)
    {
        Kick = kick;
        kick.Vectors(_speed, Forward, out Vector3d velocity, out Vector3d spin);
        _context.FlyFrames(From, in velocity, in spin, Target);
        Closest = _context.Frames.Closest;
        Miss = Vector3d.Distance(Closest, Target);
        if (Miss < _bestMiss)
        {
            _bestMiss = Miss;
            _best = kick;
        }
    }

    /// <summary>Flies the highest and the lowest kick: the target is in reach where they pass above and below it (4.1.2).</summary>
    /// <param name="extreme">Where it is not: the extreme kick to return.</param>
    public bool BetweenExtremes(out AimAnswer extreme)
    {
        extreme = default;
        Kick kick = Kick;
        kick.Elevation = LowestElevation;
        Elementary.SinCos(LowestElevation, out double sine, out _);
        double lowHeight = From.Y;
        double lowMiss = double.PositiveInfinity;
        if (!(Target.Y > From.Y + _tolerance && _context.StaysDown(From, _speed * sine)))
        {
            // Along the ground it passes below: that needs no flight.
            Fly(in kick);
            lowHeight = Closest.Y;
            lowMiss = Miss;
        }

        kick.Elevation = HighestElevation;
        Fly(in kick);
        bool above = Closest.Y > Target.Y || Miss <= _tolerance;
        if (above && (lowHeight < Target.Y || lowMiss <= _tolerance))
        {
            return true;
        }

        if (lowHeight > Target.Y)
        {
            kick.Elevation = LowestElevation;
        }

        // The extreme kick, turned horizontally as the thesis' later iterations would.
        extreme = Answer(in kick, kick.Elevation == HighestElevation ? Miss : lowMiss, 0);
        extreme.Status = Distance < 1e-6 && Math.Abs(Target.Y - From.Y) < 1e-6 ? AimStatus.Degenerate : AimStatus.OutOfReach;
        return false;
    }

    /// <summary>The horizontal angle from where the ball went to the target, rad.</summary>
    public readonly double HorizontalAngle()
    {
        Vector3d guess = Closest - From;
        Vector3d target = Target - From;

        // ŷ-component of guess × target over their horizontal scalar product
        double sine = (guess.Z * target.X) - (guess.X * target.Z);
        double cosine = (guess.X * target.X) + (guess.Z * target.Z);
        return Elementary.Atan2(sine, cosine);
    }

    /// <summary>The last kick with another direction, kept within the elevation bounds.</summary>
    public readonly Kick WithDirection(in Vector3d direction)
    {
        Kick kick = Kick;
        double elevation = Elementary.Atan2(direction.Y, direction.Horizontal.Length);
        kick.Elevation = Math.Min(Math.Max(elevation, LowestElevation), HighestElevation);
        kick.Azimuth = Elementary.Atan2(Vector3d.Dot(in direction, in _left), Vector3d.Dot(in direction, Forward));
        return kick;
    }

    /// <summary>The best kick so far.</summary>
    public readonly AimAnswer Best(int iterations) => Answer(in _best, _bestMiss, iterations);

    private readonly AimAnswer Answer(in Kick kick, double miss, int iterations) => new()
    {
        Status = miss <= _tolerance ? AimStatus.Hit : AimStatus.NotConverged,
        Kick = kick,
        Forward = Forward,
        Speed = _speed,
        Miss = miss,
        Iterations = iterations,
    };
}
