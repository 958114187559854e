namespace Football.Physics;

/// <summary>The kick along the ground that is at the target in a given time.</summary>
internal sealed class TimedRoll : TimedProblem
{
    /// <summary>Step of the roll, s, and of one that is fast enough to meet the drag law's jump.</summary>
    private const double Step = 0.5;
    private const double FastStep = 0.1;
    private const double Fast = 11;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private ElevationBounds _bounds;
    private double _elevation;
    private double _cosine;
    private double _height;

    /// <param name="context">What the searches share.</param>
    /// <param name="simulator">The scene.</param>
    public TimedRoll(AimContext context, Simulator simulator)
        : base(context) => _simulator = simulator;

    /// <summary>Whether a ball on the ground can hit the target at all.</summary>
    public bool CanHit { get; private set; }

    public override void Set(AimRequest request, double top, double side)
    {
        base.Set(request, top, side);
        _bounds = ElevationBounds.Of(request);
        _elevation = _bounds.Clamp(0);
        Elementary.SinCos(_elevation, out _, out _cosine);
        _height = Math.Abs(Frame.Target.Y - Context.Game.ContactHeight);
        CanHit = Frame.From.Y <= Context.Game.ContactHeight && Context.Upward <= 0 && _height < request.Tolerance && request.TargetVelocity.Y == 0
            && Frame.Distance > request.Tolerance && _cosine > 0.5;
        Tolerance = Math.Min(Tolerance, 0.5 * Math.Sqrt(Math.Max(0, (request.Tolerance * request.Tolerance) - (_height * _height))));
    }

    public override TimedKick Model(double time)
    {
        Vector3d way = (Frame.Target + (time * Request.TargetVelocity) - Frame.From).Horizontal;

        // A ball that rolls slows down by friction, and by what its slide costs it first.
        double slowing = Context.Scene.Ground.RollingFriction * Context.Scene.Gravity;
        double length = way.Length;
        double rolled = Math.Min(time, slowing > 0 ? Math.Sqrt(2.0 * length / slowing) : time);
        double speed = 1.2 * ((length / rolled) + (0.5 * slowing * rolled));
        Vector3d direction = length > 0 ? way / length : Frame.Forward;
        return new TimedKick
        {
            Time = time,
            Velocity = speed * direction,
            Jacobian = VelocityJacobian.Along(in direction, 0.8 * rolled, length / speed).Horizontal(rolled),
        };
    }

    public override double Violation(in TimedKick kick)
    {
        Elementary.SinCos(_elevation, out double sine, out _);
        return ((kick.Speed * Math.Abs(sine)) - Context.Scene.Ground.MinimumBounceSpeed) / Math.Max(kick.Speed, 1e-9);
    }

    public override bool PassesBounds(in TimedKick one, in TimedKick other, out double between)
    {
        between = one.Time;
        return false;
    }

    public override Kick KickOf(in Vector3d velocity)
    {
        Kick kick = Frame.Turned(new Kick { Top = Top, Side = Side }, in velocity, in _bounds);
        kick.Elevation = _elevation;
        return kick;
    }

    protected override double SpeedOf(in Vector3d velocity) => velocity.Length / _cosine;

    protected override bool Varies(int axis) => axis != 1;

    protected override Vector3d FlyTo(ref TimedKick kick)
    {
        BallState state = _simulator.Launch(Frame.From, kick.Velocity.Horizontal, SpinOf(in kick.Velocity));
        _log.Clear();
        double last = kick.Time - (1e-9 * kick.Time);
        while (state.Time < last && state.Motion != MotionState.Stopped && _log.Steps < AimContext.MostPieces)
        {
            double step = state.Motion == MotionState.Sliding || state.Velocity.LengthSquared > Fast * Fast ? FastStep : Step;
            _simulator.StepToImpact(ref state, Math.Min(step, kick.Time - state.Time), _log);
        }

        Context.CountSimulation(_log.Steps);
        kick.Arrival = (state.Velocity - Request.TargetVelocity).Horizontal;
        kick.Lowest = state.Position.Y;
        return (state.Position - Frame.Target - (kick.Time * Request.TargetVelocity)).Horizontal;
    }
}
