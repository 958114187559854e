namespace FootballPhysics.Numerics;

/// <summary>A straight path of a ball with a margin: the input of the broad phase.</summary>
/// <param name="from">The start, in m.</param>
/// <param name="velocity">The velocity, in m/s.</param>
/// <param name="time">The start time, in s.</param>
/// <param name="duration">The duration, in s.</param>
/// <param name="around">The margin, in m: the path counts as hitting everything within it.</param>
internal readonly struct StraightWay(in Vector3d from, in Vector3d velocity, double time, double duration, double around)
{
    /// <summary>The minimum speed along an axis, in m/s, to avoid a division by zero.</summary>
    private const double Slowest = 1e-30;

    /// <summary>One over the velocity along each axis, in s/m.</summary>
    private readonly Vector3d _inverse = new(Inverse(velocity.X), Inverse(velocity.Y), Inverse(velocity.Z));

    /// <summary>The start, in m.</summary>
    public Vector3d From { get; } = from;

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; } = velocity;

    /// <summary>The start time, in s.</summary>
    public double Time { get; } = time;

    /// <summary>The duration, in s.</summary>
    public double Duration { get; } = duration;

    /// <summary>The margin, in m: the path counts as hitting everything within it.</summary>
    public double Around { get; } = around;

    /// <summary>The midpoint, in m.</summary>
    public Vector3d Middle => From + ((0.5 * Duration) * Velocity);

    /// <summary>A bounding box of the path with its margin.</summary>
    public Bounds3d Box
    {
        get
        {
            Vector3d to = From + (Duration * Velocity);
            return new Bounds3d(
                new Vector3d((From.X < to.X ? From.X : to.X) - Around, (From.Y < to.Y ? From.Y : to.Y) - Around, (From.Z < to.Z ? From.Z : to.Z) - Around),
                new Vector3d((From.X < to.X ? to.X : From.X) + Around, (From.Y < to.Y ? to.Y : From.Y) + Around, (From.Z < to.Z ? to.Z : From.Z) + Around));
        }
    }

    /// <summary>Returns the path relative to an object with constant velocity.</summary>
    /// <param name="velocity">The velocity of the object, in m/s.</param>
    public StraightWay SeenFrom(in Vector3d velocity) => new(From, Velocity - velocity, Time, Duration, Around);

    /// <summary>Returns the time from the start at which the path reaches a box, in s; infinite if never.</summary>
    public double Meets(in Bounds3d box)
    {
        double enter = 0;
        double leave = double.PositiveInfinity;

        // Enlarge the box by the margin, and treat the ball as a point. The ball is inside while it is between all three pairs of planes.
        Slab(box.Min.X - Around - From.X, box.Max.X + Around - From.X, _inverse.X, ref enter, ref leave);
        Slab(box.Min.Y - Around - From.Y, box.Max.Y + Around - From.Y, _inverse.Y, ref enter, ref leave);
        Slab(box.Min.Z - Around - From.Z, box.Max.Z + Around - From.Z, _inverse.Z, ref enter, ref leave);
        return enter <= leave ? enter : double.PositiveInfinity;
    }

    private static void Slab(double low, double high, double inverse, ref double enter, ref double leave)
    {
        // The sign of the velocity determines which plane comes first.
        double first = inverse < 0 ? high * inverse : low * inverse;
        double last = inverse < 0 ? low * inverse : high * inverse;
        enter = first > enter ? first : enter;
        leave = last < leave ? last : leave;
    }

    private static double Inverse(double speed) => 1.0 / (Math.Abs(speed) < Slowest ? Slowest : speed);
}
