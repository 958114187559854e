namespace FootballPhysics.Labs.Rebounds;

/// <summary>A ball of a meeting, at time 0.</summary>
internal sealed record MeetingBall(double Mass, double Radius, double InertiaFactor, Vector3d Position, Vector3d Velocity, Vector3d Spin)
{
    /// <summary>The moment of inertia, kg m².</summary>
    public double Inertia => InertiaFactor * Mass * Radius * Radius;

    public BallProperties Properties => new() { Mass = Mass, Radius = Radius, InertiaFactor = InertiaFactor };
}

/// <summary>A ball that meets two or three objects in quick succession, in empty space: drawn from a seed, so that the ball hits each of them.</summary>
internal sealed class Meeting
{
    public const double BallRestitution = 0.78;

    /// <summary>Successive meetings lie at most this far apart, s.</summary>
    private const double Apart = 0.5;

    /// <summary>The least closing speed of a drawn meeting, m/s.</summary>
    private const double Closing = 0.3;

    /// <summary>The least gap at the start, m.</summary>
    private const double Gap = 0.01;

    private const int MostTries = 200;

    private readonly SeededRandom _random;
    private readonly List<Mover> _movers = [];
    private readonly List<MeetingBall> _balls = [];

    public Meeting(SeededRandom random)
    {
        _random = random;
        TimeStep = random.Log(0.002, 0.05);
        BallFriction = random.Chance(0.5) ? 0 : random.Uniform(0, 0.6);
        _balls.Add(new MeetingBall(random.Uniform(0.2, 0.6), random.Uniform(0.08, 0.13), random.Uniform(0.4, 0.67), Vector3d.Zero, random.Log(1, 30) * random.Direction(), random.Chance(0.5) ? Vector3d.Zero : random.Uniform(0, 60) * random.Direction()));
        int wanted = random.Chance(0.25) ? 3 : 2;
        double time = 0;
        for (int i = 0; i < wanted; i++)
        {
            time = i == 0 ? random.Uniform(0.005, 0.1) : time + random.Log(0.002, Apart);
            var integrator = new EventIntegrator(this, Vector3d.Zero);
            integrator.PlayTo(time);
            AddAt(time, integrator.PositionOf(0), integrator.VelocityOf(0), random.Chance(0.1) && i == wanted - 1);
        }

        Duration = time + 0.05;
    }

    public double TimeStep { get; }

    /// <summary>The friction of a ball on another.</summary>
    public double BallFriction { get; }

    /// <summary>The length of the meeting, s.</summary>
    public double Duration { get; }

    public IReadOnlyList<Mover> Movers => _movers;

    public IReadOnlyList<MeetingBall> Balls => _balls;

    /// <summary>Adds an object, or a second ball, that the ball hits at a time.</summary>
    private void AddAt(double time, Vector3d position, Vector3d velocity, bool isBall)
    {
        for (int i = 0; i < MostTries; i++)
        {
            // The normal of the contact, and the velocity of the object; the ball must close on its surface.
            Vector3d n = _random.Direction();
            Vector3d motion = _random.Chance(0.3) ? Vector3d.Zero : _random.Uniform(0.001, 12) * _random.Direction();
            Vector3d contact = position - (_balls[0].Radius * n);
            if (isBall)
            {
                double radius = _random.Uniform(0.03, 0.15);
                Vector3d start = contact - (radius * n) - (time * motion);
                bool isFree = (start - _balls[0].Position).Length > radius + _balls[0].Radius + Gap && _movers.TrueForAll(mover => mover.From(start, mover.At(0)).Distance > radius + Gap);
                if (isFree && Vector3d.Dot(velocity - motion, n) < -Closing)
                {
                    _balls.Add(new MeetingBall(_random.Uniform(0.1, 0.8), radius, 0.4, start, motion, _random.Uniform(0, 40) * _random.Direction()));
                    return;
                }
            }
            else if (Hit(time, in contact, n, in motion) is { } mover)
            {
                Vector3d surface = motion + Vector3d.Cross(mover.Spin, contact - mover.At(time).Origin);
                if (Vector3d.Dot(velocity - surface, n) < -Closing && _balls.All(ball => mover.From(ball.Position, mover.At(0)).Distance > ball.Radius + Gap))
                {
                    _movers.Add(mover);
                    return;
                }
            }
        }
    }

    /// <summary>Returns an object whose surface has a point with a normal at a time.</summary>
    private Mover Hit(double time, in Vector3d contact, Vector3d n, in Vector3d motion)
    {
        MoverShape shape = _random.Any(MoverShape.Sphere, MoverShape.Capsule, MoverShape.Box);
        Vector3d size = shape switch
        {
            MoverShape.Sphere => new Vector3d(_random.Uniform(0.04, 0.4), 0, 0),
            MoverShape.Capsule => new Vector3d(_random.Uniform(0.04, 0.3), _random.Uniform(0.05, 0.7), 0),
            _ => new Vector3d(_random.Uniform(0.03, 0.6), _random.Uniform(0.03, 0.6), _random.Uniform(0.03, 0.6)),
        };
        MoverKind kind = motion == Vector3d.Zero && _random.Chance(0.3) ? MoverKind.Standing : _random.Any(MoverKind.Obstacle, MoverKind.Body, MoverKind.Engine);
        Quaterniond turned = new Quaterniond(_random.Uniform(-1, 1), _random.Uniform(-1, 1), _random.Uniform(-1, 1), _random.Uniform(-1, 1)).Normalized();
        var toLocal = new MoverPose(Vector3d.Zero, turned);
        Vector3d local = toLocal.ToLocal(in n);
        Vector3d point;
        switch (shape)
        {
            case MoverShape.Sphere:
                point = size.X * local;
                break;
            case MoverShape.Capsule:
                // On an end, or turned so that the normal is across the axis.
                if (_random.Chance(0.3))
                {
                    point = new Vector3d(0, local.Y > 0 ? size.Y : -size.Y, 0) + (size.X * local);
                    break;
                }

                Turn(new Vector3d(1, 0, 0));
                point = new Vector3d(size.X, _random.Uniform(-0.95, 0.95) * size.Y, 0);
                break;
            default:
                if (_random.Chance(0.25))
                {
                    point = new Vector3d(Math.CopySign(size.X, local.X), Math.CopySign(size.Y, local.Y), Math.CopySign(size.Z, local.Z));
                    break;
                }

                Turn(new Vector3d(1, 0, 0));
                point = new Vector3d(size.X, _random.Uniform(-0.95, 0.95) * size.Y, _random.Uniform(-0.95, 0.95) * size.Z);
                break;
        }

        // Bodies and colliders may rotate about their origin.
        bool rotates = kind is MoverKind.Body or MoverKind.Engine && _random.Chance(0.3);
        Vector3d spin = rotates ? _random.Uniform(0.5, 12) * _random.Direction() : Vector3d.Zero;
        double mass = kind != MoverKind.Standing && _random.Chance(0.3) ? _random.Log(2, 90) : double.PositiveInfinity;
        Vector3d origin = contact - turned.Rotate(point);
        Quaterniond start = spin == Vector3d.Zero ? turned : (Quaterniond.FromAxisAngle(spin / spin.Length, -spin.Length * time) * turned).Normalized();
        return new Mover
        {
            Shape = shape,
            Size = size,
            Kind = kind,
            Origin = origin - (time * motion),
            Orientation = start,
            Velocity = kind == MoverKind.Standing ? Vector3d.Zero : motion,
            Spin = spin,
            Mass = mass,
            Restitution = _random.Uniform(0.3, 1),
            TangentialRestitution = _random.Uniform(-1, 0.3),
            Friction = _random.Chance(0.5) ? 0 : _random.Uniform(0, 0.8),
        };

        // Turns the object so that a direction of its own is the normal of the contact.
        void Turn(Vector3d own)
        {
            Vector3d from = turned.Rotate(own);
            Vector3d axis = Vector3d.Cross(from, n);
            double sine = axis.Length;
            turned = sine > 1e-9 ? (Quaterniond.FromAxisAngle(axis / sine, Math.Atan2(sine, Vector3d.Dot(from, n))) * turned).Normalized() : turned;
        }
    }
}
