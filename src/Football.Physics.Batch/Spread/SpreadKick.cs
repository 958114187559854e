using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>An intended kick, and its variations in speed, elevation, azimuth and relative spin.</summary>
internal readonly struct SpreadKick
{
    private readonly double _speed;
    private readonly double _elevation;
    private readonly Vector3d _direction;
    private readonly Vector3d _left;

    public SpreadKick(in Vector3d position, in Vector3d velocity, in Vector3d spin)
        : this(in position, in velocity, in spin, Quaterniond.Identity)
    {
    }

    public SpreadKick(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation)
    {
        Position = position;
        Orientation = orientation;
        Velocity = velocity;
        Spin = spin;
        double flat = velocity.Horizontal.Length;
        if (!(flat > 0))
        {
            throw Check.Refusal("launch.velocity", velocity.ToString(), "a direction that is not vertical");
        }

        _speed = velocity.Length;
        _elevation = Elementary.Atan2(velocity.Y, flat);
        _direction = velocity.Horizontal / flat;
        _left = Vector3d.Cross(Vector3d.Up, in _direction);
    }

    /// <summary>The position of the ball, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The orientation of the ball, the same for all variations.</summary>
    public Quaterniond Orientation { get; }

    /// <summary>The intended velocity, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The intended spin, in rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>Computes a variation of the kick.</summary>
    /// <param name="by">The deviations: relative speed, elevation, azimuth, relative spin.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    public void With(double[] by, out Vector3d velocity, out Vector3d spin)
    {
        double speed = _speed * Math.Max(0, 1.0 + by[0]);
        Elementary.SinCos(_elevation + by[1], out double up, out double flat);
        Elementary.SinCos(by[2], out double sine, out double cosine);

        // v = V (cos ε d + sin ε ŷ), where d and the spin are rotated about ŷ by the azimuth.
        velocity = KickVectors.Limited(speed * ((flat * ((cosine * _direction) + (sine * _left))) + new Vector3d(0, up, 0)), Limits.Speed);
        Vector3d turned = new((cosine * Spin.X) + (sine * Spin.Z), Spin.Y, (cosine * Spin.Z) - (sine * Spin.X));
        spin = KickVectors.Limited((1.0 + by[3]) * turned, Limits.Spin);
    }

    /// <summary>Computes the derivatives of velocity and spin by one of the four variables.</summary>
    public void Derivative(int number, out Vector3d velocity, out Vector3d spin)
    {
        velocity = Vector3d.Zero;
        spin = Vector3d.Zero;
        switch (number)
        {
            case 0:
                velocity = Velocity;
                break;
            case 1:
                Elementary.SinCos(_elevation, out double up, out double flat);
                velocity = _speed * ((-up * _direction) + new Vector3d(0, flat, 0));
                break;
            case 2:
                velocity = Vector3d.Cross(Vector3d.Up, Velocity);
                spin = Vector3d.Cross(Vector3d.Up, Spin);
                break;
            default:
                spin = Spin;
                break;
        }
    }
}
