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
