namespace Football.Physics;

/// <summary>The kick that flies to the target in a given time.</summary>
internal sealed class TimedFlight : TimedProblem
{
    /// <summary>Step of a flight that the air rules, s.</summary>
    private const double RuledByAirStep = 0.03;

    /// <summary>Above this elevation, rad, spin and wind may bring a ball to the target that was kicked elsewhere.</summary>
    private const double SteepKick = 0.8;

    /// <summary>Speeds of the wind and of the kick, both horizontally, above whose ratio that is likely.</summary>
    private const double Drift = 1.25;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private double _step;

    /// <param name="context">What the searches share.</param>
    /// <param name="simulator">The scene without ground.</param>
    public TimedFlight(AimContext context, Simulator simulator)
        : base(context) => _simulator = simulator;

    /// <summary>The elevations that are allowed.</summary>
    public ElevationBounds Bounds { get; private set; }

    public override void Set(AimRequest request, double top, double side)
    {
        base.Set(request, top, side);
        Bounds = ElevationBounds.Of(request);
        _step = IsRuledByAir ? Math.Min(RuledByAirStep, Context.Steps.HitWithin(Tolerance)) : Context.Steps.HitWithin(Tolerance);
    }

    public override TimedKick Model(double time)
    {
        Vector3d wind = Context.Scene.Air.Wind;
        Vector3d toTarget = Frame.Target + (time * Request.TargetVelocity) - Frame.From;
        double spinRate = Math.Sqrt((Top * Top) + (Side * Side));
        Vector3d through = toTarget - (time * wind); // through the air
        double way = through.Length;
        FlatFire model = Context.Model(Math.Max(way / time, 1.0), spinRate, way);
        var kick = new TimedKick { Time = time };
        Vector3d axis = spinRate > 0 ? SpinOf(toTarget) / spinRate : Vector3d.Zero;
        kick.Velocity = model.Launch(in through, in axis, time, out Vector3d direction, out double along, out double across) + wind;
        kick.Jacobian = VelocityJacobian.Along(in direction, along, across);
        return kick;
    }

    public override double Violation(in TimedKick kick)
    {
        Vector3d v = kick.Velocity;
        double elevation = Elevation(in kick);
        double violation = Math.Max(Bounds.Lowest - elevation, elevation - Bounds.Highest);
        double contact = Context.Game.ContactHeight;
        if (Frame.From.Y <= contact && Context.Upward <= 0)
        {
            // From the ground it must leave it at once.
            violation = Math.Max(violation, (Context.Scene.Ground.MinimumBounceSpeed - v.Y) / Math.Max(kick.Speed, 1e-9));
        }

        return Math.Max(violation - 1e-12, (contact - Tolerance - kick.Lowest) / Math.Max(kick.Speed * kick.Time, 1e-9));
    }

    /// <summary>Whether a kick may be one of several that are slower than their neighbours: it is steep, and the wind drives it more than it was kicked.</summary>
    public bool IsDriven(in TimedKick kick) =>
        Top != 0 && Elevation(in kick) > SteepKick && Context.Scene.Air.Wind.Horizontal.Length > Drift * kick.Velocity.Horizontal.Length;

    public override bool Across(in TimedKick kick, out TimedKick across)
    {
        across = kick;
        double length = kick.Velocity.Horizontal.Length;
        if (!(Top < 0 && Elevation(in kick) > SteepKick && length > 0))
        {
            return false;
        }

        Sharpen(ref across);
        Vector3d ahead = across.Velocity.Horizontal / length;
        Vector3d left = Vector3d.Cross(Vector3d.Up, in ahead);

        // A steep kick is pushed back by its backspin, by −L along its horizontal direction d̂: horizontally it gets to (A v + L) d̂, and with −d̂ to the same place
        // where A v' + L = −(A v + L). A is the Jacobian along d̂, and (A v + L)/v that across it.
        double along = Vector3d.Dot(across.Jacobian.Product(in ahead), in ahead);
        double aside = Vector3d.Dot(across.Jacobian.Product(in left), in left);
        double other = length * (1.0 - (2.0 * aside / along));
        if (!(other > 0))
        {
            return false;
        }

        across.Velocity -= (length + other) * ahead;
        across.Jacobian.Update(in left, -(length * aside / other) * left);
        return true;
    }

    public override bool PassesBounds(in TimedKick one, in TimedKick other, out double between)
    {
        double middle = 0.5 * (Bounds.Lowest + Bounds.Highest);
        double low = Elevation(in one) - middle;
        double high = Elevation(in other) - middle;
        between = one.Time + ((other.Time - one.Time) * low / (low - high));
        return low < 0 != high < 0;
    }

    public override Kick KickOf(in Vector3d velocity) => Frame.Turned(new Kick { Top = Top, Side = Side }, in velocity, Bounds);

    protected override Vector3d FlyTo(ref TimedKick kick)
    {
        BallState state = _simulator.Launch(Frame.From, kick.Velocity, SpinOf(in kick.Velocity));
        double steps = Math.Ceiling(kick.Time / _step);
        double step = kick.Time / steps;
        _log.Clear();
        double lowest = double.PositiveInfinity;
        for (int i = 0; i < steps && _log.Steps < AimContext.MostPieces; i++)
        {
            _simulator.StepToImpact(ref state, step, _log);
            lowest = Math.Min(lowest, state.Position.Y);
        }

        Context.CountSimulation(_log.Steps);

        kick.Lowest = lowest;
        kick.Arrival = state.Velocity - Request.TargetVelocity;
        return state.Position - Frame.Target - (kick.Time * Request.TargetVelocity);
    }

    /// <summary>Elevation of a kick, rad.</summary>
    public static double Elevation(in TimedKick kick) => Elementary.Atan2(kick.Velocity.Y, kick.Velocity.Horizontal.Length);
}

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
