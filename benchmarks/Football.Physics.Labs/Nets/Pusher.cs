namespace FootballPhysics.Labs.Nets;

/// <summary>A body that pushes the ball: a sphere, a standing player or a box. It goes forward, stays, and goes back or away.</summary>
internal sealed class Pusher
{
    private readonly SeededRandom _random;
    private readonly double _speed;
    private Vector3d _position;
    private Vector3d _velocity;
    private Vector3d _way;
    private double _pause;
    private double _left;
    private bool _steers;
    private bool _leaves;

    public Pusher(SeededRandom random)
    {
        _random = random;
        _speed = random.Log(0.3, 8);
        double size = random.Uniform(0.1, 0.3);
        Shape = random.Below(3) switch
        {
            0 => new SphereShape(Vector3d.Zero, size),
            1 => new CapsuleShape(new Vector3d(0, -0.5, 0), new Vector3d(0, 0.5, 0), size),
            _ => new BoxShape(Vector3d.Zero, new Vector3d(size, 0.4, size)),
        };
    }

    /// <summary>Its shape, around the origin.</summary>
    public IShape Shape { get; }

    /// <summary>The body of the scene.</summary>
    public KinematicBody? Body { get; set; }

    /// <summary>True if it is far from the ball.</summary>
    public bool IsGone { get; private set; }

    /// <summary>Its speed, m/s.</summary>
    public double Speed => _velocity.Length;

    /// <summary>Puts the body behind the ball.</summary>
    /// <param name="ball">The ball's centre, m.</param>
    /// <param name="way">The direction in which it pushes.</param>
    /// <param name="radius">The ball's radius, m.</param>
    /// <param name="play">Whether it walks through the net, or presses and goes back.</param>
    public void Begin(in Vector3d ball, in Vector3d way, double radius, NetPlay play)
    {
        _way = way;
        double gap = _random.Uniform(0, 0.3);
        _position = ball - (2 * way);

        // As near as the shape allows.
        _position += (DistanceTo(in ball) - radius - gap) * way;
        _left = play == NetPlay.Walked ? _random.Uniform(1, 8) : _random.Uniform(0.2, 1.5);
        _pause = _random.Uniform(0, 1);
        _steers = play == NetPlay.Walked && _random.Chance(0.4);
        _leaves = play == NetPlay.Pressed || _random.Chance(0.5);
    }

    /// <summary>Returns the distance of a point from its surface, m.</summary>
    public double DistanceTo(in Vector3d point) => Shape.At(point - _position).Distance;

    /// <summary>Moves the body for a frame.</summary>
    public void MoveTo(in BallState ball, double step)
    {
        Vector3d to = (ball.Position - _position).Horizontal;
        _way = _steers && to.Length > 0.01 ? to.Normalized() : _way;
        _velocity = _left > 0 ? _speed * _way : default;
        if (_left <= 0)
        {
            _pause -= step;
            _velocity = _pause <= 0 && _leaves && !IsGone ? -_speed * _way : default;
            bool isFar = DistanceTo(ball.Position) > 1;
            IsGone |= _pause <= (_leaves ? -4 : 0) || (_pause <= 0 && isFar);
            _position = IsGone ? new Vector3d(0, 50, 60) : _position;
            _velocity = IsGone ? default : _velocity;
        }

        Body!.MoveTo(_position, _velocity, ball.Time);
    }

    /// <summary>Advances the body by a frame.</summary>
    public void Advance(double step)
    {
        _position += step * _velocity;
        _left -= step * _velocity.Length;
    }
}
