namespace FootballPhysics.Labs.Stress;

/// <summary>A body of an asked match: it runs at a ball, turns or stands, and is told every nth tick.</summary>
internal sealed class AskedBody
{
    private const double Fastest = 7;
    private const double Far = 5;

    private readonly Manner _manner;
    private readonly Vector3d _axis;
    private readonly int _every;
    private readonly double _keepsAway;
    private Vector3d _place;
    private Vector3d _velocity;
    private double _angle;
    private double _before;

    public AskedBody(SeededRandom random, int index, bool weighs)
    {
        Name = FormattableString.Invariant($"body {index}");
        Shape = AnyShape(random);
        Mass = weighs && random.Chance(0.6) ? random.Log(0.5, 80) : double.PositiveInfinity;

        // The first body turns, and most others do.
        _manner = index == 0 ? random.Any(Manner.Turned, Manner.Spins) : random.Any(Manner.Turned, Manner.Spins, Manner.Spins, Manner.Runs, Manner.Stands);
        _axis = random.Chance(0.7) ? Vector3d.Up : random.Direction();
        _every = random.Chance(0.6) ? 1 : 1 + random.Below(8);
        _keepsAway = random.Any(0, random.Uniform(0.2, 0.6), random.Uniform(0.4, 1.2));
        _place = random.Uniform(0.6, 3) * random.Heading();
        _angle = random.Uniform(-3, 3);
        _before = _angle;
    }

    private enum Manner
    {
        Stands,
        Runs,
        Turned,
        Spins,
    }

    public string Name { get; }

    public IShape Shape { get; }

    public double Mass { get; }

    /// <summary>True if its orientation changes from tick to tick.</summary>
    public bool Turns => _manner is Manner.Turned or Manner.Spins;

    public static IShape AnyShape(SeededRandom random)
    {
        double radius = random.Uniform(0.05, 0.3);
        return random.Below(5) switch
        {
            0 => new CapsuleShape(new Vector3d(0, radius, 0), new Vector3d(0, 1.5, 0), radius),
            1 => new SphereShape(new Vector3d(0, radius, 0), radius),
            2 => new CapsuleShape(new Vector3d(0, 0.06, 0.3), new Vector3d(0, 0.06, -0.3), 0.05),
            3 => new BoxShape(new Vector3d(0, 0.1, 0.05), new Vector3d(0.045, 0.08, 0.33)),
            _ => new BoxShape(new Vector3d(0.3, 0.4, 0), new Vector3d(0.35, 0.4, 0.06)),
        };
    }

    /// <summary>Chooses where it goes in the next tick.</summary>
    public void Decide(SeededRandom random, Vector3d ball, double dt)
    {
        _place += dt * _velocity;
        Vector3d way = (ball - _place).Horizontal;
        if (way.Length > Far && random.Chance(0.05))
        {
            // Somebody else comes on.
            _place = ball.Horizontal + (random.Uniform(0.5, 1.5) * random.Heading());
            way = (ball - _place).Horizontal;
        }

        double far = way.Length - _keepsAway;
        Vector3d wanted = _manner == Manner.Stands || far <= 0 ? Vector3d.Zero : Math.Min(Fastest, 3 * far) / way.Length * way;
        _velocity += Math.Min(1, 6 * dt) * (wanted - _velocity);
        _velocity = random.Chance(0.02) ? random.Uniform(0, Fastest) * random.Heading() : _velocity;
        _before = _angle;
        _angle += Turns ? random.Uniform(-0.2, 0.25) : 0;
    }

    /// <summary>Returns its move for a tick: none if it is not its turn.</summary>
    public AskedMove Move(SeededRandom random, bool isWithdrawn, long tick, double dt)
    {
        if (tick % _every != 0)
        {
            return default;
        }

        if (isWithdrawn ? random.Chance(0.9) : random.Chance(0.003))
        {
            return AskedMove.Withdrawal;
        }

        Vector3d spin = _manner == Manner.Spins ? (_angle - _before) / dt * _axis : Vector3d.Zero;
        return AskedMove.To(new AskedPose(_place, Quaterniond.FromAxisAngle(_axis, _angle), _velocity, spin), Turns);
    }
}

/// <summary>Where an object is, and how it moves.</summary>
internal readonly record struct AskedPose(Vector3d Position, Quaterniond Orientation, Vector3d Velocity, Vector3d Spin);

/// <summary>What a body is told for a tick: nothing, to leave, or where it is.</summary>
internal readonly record struct AskedMove(bool IsTold, bool Leaves, bool IsTurned, AskedPose Pose)
{
    public static AskedMove Withdrawal => new(true, true, false, default);

    public static AskedMove To(in AskedPose pose, bool isTurned = true) => new(true, false, isTurned, pose);

    public void Tell(KinematicBody body, double time)
    {
        if (!IsTold)
        {
            return;
        }

        if (Leaves)
        {
            body.Withdraw();
        }
        else if (IsTurned)
        {
            body.MoveTo(Pose.Position, Pose.Orientation, Pose.Velocity, Pose.Spin, time);
        }
        else
        {
            body.MoveTo(Pose.Position, Pose.Velocity, time);
        }
    }
}
