namespace Football.Physics;

/// <summary>
/// Lambert's problem for a ball: with which velocity must it be kicked to be at the target at a given time? For every time there is one such
/// velocity, and it changes smoothly with the time, whatever the wind: by it speeds, arcs and times of kicks are found where elevation and
/// azimuth do not tell them apart. Only a steep kick with topspin may have a second one, horizontally the other way.
/// </summary>
internal abstract class TimedProblem
{
    /// <summary>How many other first kicks there are.</summary>
    public const int OtherStarts = 3;

    /// <summary>Flights of one search at most.</summary>
    public const int MostFlights = 40;

    /// <summary>An iteration must shrink the miss to this share of it; else the Jacobian is measured.</summary>
    private const double Progress = 0.7;

    /// <summary>Largest change of the velocity in one iteration, as a share of it.</summary>
    private const double LargestChange = 0.6;

    /// <summary>Change of the velocity by which a Jacobian is measured, as a share of it.</summary>
    private const double Difference = 1e-4;

    private int _flights;

    protected TimedProblem(AimContext context) => Context = context;

    public AimRequest Request { get; private set; } = new();

    /// <summary>The frame of the target.</summary>
    public TargetFrame Frame { get; private set; }

    /// <summary>Miss distance within which a search ends, m.</summary>
    public double Tolerance { get; protected set; }

    /// <summary>Whether nothing more can be searched.</summary>
    public bool IsSpent => Context.IsSpent;

    /// <summary>Speeds above this are not asked for, m/s.</summary>
    public double FastestOfUse { get; private set; }

    protected AimContext Context { get; }

    protected double Top { get; private set; }

    protected double Side { get; private set; }

    /// <summary>Prepares for a request.</summary>
    /// <param name="request">The request.</param>
    /// <param name="top">Topspin of the kicks, rad/s.</param>
    /// <param name="side">Their sidespin, rad/s.</param>
    public virtual void Set(AimRequest request, double top, double side)
    {
        Request = request;
        Top = top;
        Side = side;
        Frame = Context.Frame(request);
        Tolerance = AimContext.Sharp(request.Tolerance);
        FastestOfUse = Math.Min(Limits.Speed, 1.5 * request.Speed);
        IsRuledByAir = Context.IsRuledByAir(request.Speed, Math.Sqrt((top * top) + (side * side)));
    }

    /// <summary>Whether there may be several kicks for one time.</summary>
    public bool IsRuledByAir { get; private set; }

    /// <summary>A first kick for a time, no faster than is asked for.</summary>
    public TimedKick Guess(double time) => Slowed(Model(time), Request.Speed);

    /// <summary>Another one, far from it.</summary>
    /// <param name="time">The time, s.</param>
    /// <param name="start">Which; 1 … <see cref="OtherStarts"/>.</param>
    public TimedKick Guess(double time, int start)
    {
        TimedKick kick = Guess(time);
        Vector3d v = kick.Velocity;
        Vector3d straight = Frame.Target + (time * Request.TargetVelocity) - Frame.From;
        Vector3d flat = v.Horizontal;
        kick.Velocity = start switch
        {
            1 => 0.4 * v,
            2 => 0.3 * Request.Speed * ((flat / Math.Max(flat.Length, 1e-9)) + (1.5 * Vector3d.Up)),
            _ => Request.Speed / Math.Max(straight.Length, 1e-9) * straight,
        };
        return kick;
    }

    /// <summary>A first kick for another solution at the time of one that was found: where its horizontal direction is the opposite.</summary>
    /// <param name="kick">The one that was found.</param>
    /// <param name="across">The first kick.</param>
    /// <returns>Whether there may be one.</returns>
    public virtual bool Across(in TimedKick kick, out TimedKick across)
    {
        across = kick;
        return false;
    }

    private static TimedKick Slowed(TimedKick kick, double fastest)
    {
        double speed = kick.Velocity.Length;
        kick.Velocity *= speed > fastest ? fastest / speed : 1.0;
        return kick;
    }

    /// <summary>By how much a kick violates the bounds of the request; negative within them, and about proportional to what it is off.</summary>
    public abstract double Violation(in TimedKick kick);

    /// <summary>Whether two kicks lie on either side of all that the bounds allow.</summary>
    /// <param name="one">One kick.</param>
    /// <param name="other">The other.</param>
    /// <param name="between">A time at which the kick lies about in the middle of the bounds.</param>
    public abstract bool PassesBounds(in TimedKick one, in TimedKick other, out double between);

    /// <summary>The two angles of a kick.</summary>
    public abstract Kick KickOf(in Vector3d velocity);

    /// <summary>Improves a kick until it is at the target at its time: Newton's method with Broyden's updates, the Jacobian measured where they fail.</summary>
    /// <returns>Whether it was found.</returns>
    public bool Solve(ref TimedKick kick)
    {
        _flights = 0;
        kick.Found = false;
        if (Context.IsSpent)
        {
            return NotFound(ref kick);
        }

        kick.Velocity = kick.Velocity.IsFinite ? Limited(in kick.Velocity) : Vector3d.Zero;
        Vector3d gap = Fly(ref kick);
        kick.Miss = gap.Length;
        bool measured = false;
        double share = 1;
        while (!(kick.Miss <= Tolerance))
        {
            if (_flights >= MostFlights || Context.IsWorn || !kick.Jacobian.Solve(-gap, out Vector3d change))
            {
                return NotFound(ref kick);
            }

            double size = change.Length;
            double largest = LargestChange * Math.Max(kick.Velocity.Length, 0.3 * kick.Arrival.Length);
            change *= share * (size > largest ? largest / size : 1.0);
            TimedKick next = kick;
            next.Velocity = Limited(kick.Velocity + change);
            change = next.Velocity - kick.Velocity;
            Vector3d nextGap = Fly(ref next);
            next.Miss = nextGap.Length;
            next.Jacobian.Update(in change, nextGap - gap);
            bool slow = !(next.Miss < Progress * kick.Miss);
            if (next.Miss < kick.Miss)
            {
                kick = next;
                gap = nextGap;
                share = 1;
                measured &= !slow;
            }
            else if (measured)
            {
                share *= 0.4;
            }

            if (slow && !measured && !(kick.Miss <= Tolerance))
            {
                Measure(ref kick, in gap);
                measured = true;
            }
        }

        kick.Speed = SpeedOf(in kick.Velocity);
        kick.Found = true;
        return true;
    }

    /// <summary>Flies a kick.</summary>
    /// <returns>From the target to the ball at the kick's time.</returns>
    public Vector3d Fly(ref TimedKick kick)
    {
        _flights++;
        return FlyTo(ref kick);
    }

    /// <summary>Measures the Jacobian of a kick that was found.</summary>
    public void Sharpen(ref TimedKick kick)
    {
        Vector3d gap = Fly(ref kick);
        Measure(ref kick, in gap);
    }

    /// <summary>Speed of the kick that starts with a velocity, m/s.</summary>
    protected virtual double SpeedOf(in Vector3d velocity) => velocity.Length;

    /// <summary>A kick of a model in closed form, with its Jacobian.</summary>
    public abstract TimedKick Model(double time);

    /// <summary>Flies a kick until its time.</summary>
    /// <returns>From the target to the ball then.</returns>
    protected abstract Vector3d FlyTo(ref TimedKick kick);

    /// <summary>A direction in which the velocity is changed to measure its influence.</summary>
    protected virtual bool Varies(int axis) => true;

    /// <summary>Spin of a kick.</summary>
    protected Vector3d SpinOf(in Vector3d velocity)
    {
        Vector3d flat = velocity.Horizontal;
        double length = flat.Length;
        Vector3d d = length > 1e-9 ? flat / length : Frame.Forward;
        return Kick.Limited(new Vector3d(Top * d.Z, Side, -(Top * d.X)), Limits.Spin);
    }

    /// <summary>Measures the Jacobian by differences.</summary>
    private void Measure(ref TimedKick kick, in Vector3d gap)
    {
        double step = Difference * Math.Max(kick.Velocity.Length, 1.0);
        Vector3d x = Column(in kick, in gap, 0, new Vector3d(step, 0, 0)) / step;
        Vector3d y = Column(in kick, in gap, 1, new Vector3d(0, step, 0)) / step;
        Vector3d z = Column(in kick, in gap, 2, new Vector3d(0, 0, step)) / step;
        kick.Jacobian = new VelocityJacobian(in x, in y, in z);
    }

    private Vector3d Column(in TimedKick kick, in Vector3d gap, int axis, in Vector3d step)
    {
        if (!Varies(axis))
        {
            return kick.Time * step;
        }

        TimedKick other = kick;
        other.Velocity = Limited(kick.Velocity + step);
        return Fly(ref other) - gap;
    }

    private bool NotFound(ref TimedKick kick)
    {
        // One that asks for more and more speed is too fast; of another, nothing is known.
        kick.Speed = kick.Velocity.Length >= 0.9 * FastestOfUse ? double.PositiveInfinity : double.NaN;
        return false;
    }

    private Vector3d Limited(in Vector3d velocity) => Kick.Limited(in velocity, FastestOfUse);
}
