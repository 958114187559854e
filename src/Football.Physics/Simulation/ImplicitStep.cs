namespace Football.Physics;

/// <summary>A step of implicit Euler in flight, which can be taken again with another length.</summary>
internal struct ImplicitStep
{
    /// <summary>The ball at the start.</summary>
    public readonly Motion From;

    private readonly MotionRates _push;
    private readonly Vector3d _wind;
    private readonly double _upward;
    private ImplicitEuler _euler;

    /// <param name="around">What acts on the ball.</param>
    /// <param name="from">The ball at the start.</param>
    /// <param name="push">What is taken as constant: own forces and side forces, and the rate of the spin.</param>
    /// <param name="wind">Velocity of the air, m/s.</param>
    public ImplicitStep(Surroundings around, in Motion from, in MotionRates push, in Vector3d wind)
        : this(in from, in push, in wind, around.Upward, new ImplicitEuler { Air = around.Air, RadiusSquared = around.RadiusSquared })
    {
    }

    private ImplicitStep(in Motion from, in MotionRates push, in Vector3d wind, double upward, ImplicitEuler euler)
    {
        From = from;
        _push = push;
        _wind = wind;
        _upward = upward;
        _euler = euler;
    }

    /// <summary>Speed relative to the air at the start, m/s, where the air varies.</summary>
    public readonly double AirSpeed => _push.AirSpeed;

    /// <summary>Right-hand sides evaluated so far.</summary>
    public readonly int Evaluations => _euler.Evaluations;

    /// <summary>The same where the ground takes up all that is vertical: lift must not turn a fall that does not happen into a speed along the ground.</summary>
    public readonly ImplicitStep AlongGround()
    {
        var from = new Motion(From.Position, new Vector3d(From.Velocity.X, 0, From.Velocity.Z), From.Spin);
        var acceleration = new Vector3d(_push.Acceleration.X, 0, _push.Acceleration.Z);
        return new ImplicitStep(in from, new MotionRates(in acceleration, in _push.SpinAcceleration, AirSpeed), in _wind, 0, _euler);
    }

    /// <summary>Velocity, and position with the new velocity; the spin is what <see cref="Spun"/> makes of it.</summary>
    /// <param name="h">Length, s.</param>
    public Motion To(double h)
    {
        Vector3d spin = From.Spin + (h * _push.SpinAcceleration);
        double rate = spin.Length;
        Vector3d axis = rate > 0 ? spin / rate : Vector3d.Up;
        Vector3d acceleration = _push.Acceleration + new Vector3d(0, _upward, 0);
        Vector3d velocity = _euler.Velocity(From.Velocity - _wind, in acceleration, in axis, rate, h) + _wind;
        return new Motion(From.Position + (h * velocity), in velocity, in spin);
    }

    /// <summary>The end of a step with the decay of its spin, which nothing else of the step depends on.</summary>
    /// <param name="end">What <see cref="To"/> found.</param>
    /// <param name="h">Length, s.</param>
    public Motion Spun(in Motion end, double h)
    {
        double rate = end.Spin.Length;
        Vector3d axis = rate > 0 ? end.Spin / rate : Vector3d.Up;
        return new Motion(end.Position, end.Velocity, _euler.Spin(rate, (end.Velocity - _wind).Length, h) * axis);
    }
}
