namespace Football.Physics;

/// <summary>A straight way of a ball, with all that lies near it: what the broad phase looks along.</summary>
internal readonly struct StraightWay
{
    /// <summary>A velocity along an axis smaller than this, m/s, is taken for this: so that nothing is divided by zero.</summary>
    private const double Slowest = 1e-30;

    /// <summary>A way.</summary>
    /// <param name="from">Where it starts, m.</param>
    /// <param name="velocity">Velocity on it, m/s.</param>
    /// <param name="time">When it starts, s.</param>
    /// <param name="duration">How long it lasts, s.</param>
    /// <param name="around">All that is so near, m, counts as met.</param>
    public StraightWay(in Vector3d from, in Vector3d velocity, double time, double duration, double around)
    {
        From = from;
        Velocity = velocity;
        Time = time;
        Duration = duration;
        Around = around;
    }

    /// <summary>Where it starts, m.</summary>
    public Vector3d From { get; }

    /// <summary>Velocity on it, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>When it starts, s.</summary>
    public double Time { get; }

    /// <summary>How long it lasts, s.</summary>
    public double Duration { get; }

    /// <summary>All that is so near, m, counts as met.</summary>
    public double Around { get; }

    /// <summary>Its middle, m.</summary>
    public Vector3d Middle => From + ((0.5 * Duration) * Velocity);

    /// <summary>A box around it and all that lies near it.</summary>
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

    /// <summary>The way as something sees it that moves steadily.</summary>
    /// <param name="velocity">Its velocity, m/s.</param>
    public StraightWay SeenFrom(in Vector3d velocity) => new(From, Velocity - velocity, Time, Duration, Around);

    /// <summary>When it comes near a box, s from its start: the slab test. Infinite where it never does.</summary>
    public double Meets(in Bounds3d box)
    {
        double enter = 0;
        double leave = double.PositiveInfinity;

        // The ball is a point, and the box larger by what lies near; it is inside where it is between all three pairs of planes.
        Slab(box.Min.X - Around - From.X, box.Max.X + Around - From.X, Inverse(Velocity.X), ref enter, ref leave);
        Slab(box.Min.Y - Around - From.Y, box.Max.Y + Around - From.Y, Inverse(Velocity.Y), ref enter, ref leave);
        Slab(box.Min.Z - Around - From.Z, box.Max.Z + Around - From.Z, Inverse(Velocity.Z), ref enter, ref leave);
        return enter <= leave ? enter : double.PositiveInfinity;
    }

    private static void Slab(double low, double high, double inverse, ref double enter, ref double leave)
    {
        // Which plane comes first depends on the direction.
        double first = inverse < 0 ? high * inverse : low * inverse;
        double last = inverse < 0 ? low * inverse : high * inverse;
        enter = first > enter ? first : enter;
        leave = last < leave ? last : leave;
    }

    private static double Inverse(double speed) => 1.0 / (Math.Abs(speed) < Slowest ? Slowest : speed);
}
