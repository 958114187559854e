namespace FootballPhysics.Engines;

/// <summary>A motion of a keeper's body from one pose to another, with bounded speeds: a dive, or the return from it.</summary>
/// <remarks>
/// He starts with the velocity v₀ that he has, changes it to w within τ, keeps w, and stops within τ. At the start his velocity is (1 − t/τ) v₀ + (t/τ) w, so
/// it is never above the larger of both speeds. The motion lasts as long as his speed requires. His turn follows the same law.
/// </remarks>
internal readonly struct KeeperMotion(in KeeperState from, in BallPose to, double start, double end)
{
    /// <summary>The greatest turning rate, in rad/s: from upright to flat within 0.3 s.</summary>
    public const double Turning = 8;

    /// <summary>The time τ in which he changes his velocity, in s.</summary>
    private const double Ramp = 0.1;

    /// <summary>The pose, velocity and spin at the start.</summary>
    public KeeperState From { get; } = from;

    /// <summary>The pose at the end; he is then at rest.</summary>
    public BallPose To { get; } = to;

    /// <summary>The time at which it starts, in s.</summary>
    public double Start { get; } = start;

    /// <summary>The time at which it ends, in s; −∞ for a keeper who stands.</summary>
    public double End { get; } = end;

    /// <summary>True if he stands, and moves nowhere.</summary>
    public bool IsStanding => double.IsNegativeInfinity(End);

    /// <summary>True if the motion is long enough to start and to stop.</summary>
    public bool IsValid => IsStanding || End - Start >= 1.99 * Ramp;

    /// <summary>The displacement that is left for w, in m: v₀ alone moves him by ½ v₀ τ.</summary>
    private Vector3d Way => To.Position - From.Pose.Position - (0.5 * Ramp * From.Velocity);

    /// <summary>The orientation to which his first spin alone turns him.</summary>
    private Quaterniond Carried => Quaterniond.FromRotationVector(0.5 * Ramp * From.Spin) * From.Pose.Orientation;

    /// <summary>Returns the motion of a keeper who stands.</summary>
    public static KeeperMotion Standing(in BallPose pose) => new(new KeeperState(in pose, Vector3d.Zero, Vector3d.Zero), in pose, double.NegativeInfinity, double.NegativeInfinity);

    /// <summary>Returns a motion within his speeds.</summary>
    /// <param name="from">The state at the start.</param>
    /// <param name="to">The pose at the end.</param>
    /// <param name="start">The time at which it starts, in s.</param>
    /// <param name="end">The intended end, in s. The motion ends later if his speeds require it.</param>
    /// <param name="speed">His greatest speed, in m/s.</param>
    public static KeeperMotion Within(in KeeperState from, in BallPose to, double start, double end, double speed)
    {
        var motion = new KeeperMotion(in from, in to, start, end);
        double steady = Math.Max(motion.Way.Length / speed, motion.Carried.SpinTo(to.Orientation, Turning).Length);
        double shortest = Ramp + Math.Max(Ramp, steady);
        return new KeeperMotion(in from, in to, start, Math.Max(end, start + Math.Min(shortest, Limits.Time)));
    }

    /// <summary>Returns the pose, velocity and spin at a time from the start on.</summary>
    public KeeperState At(double time)
    {
        double s = time - Start;
        double left = End - time;
        if (IsStanding || left <= 0)
        {
            BallPose last = To;
            return new KeeperState(in last, Vector3d.Zero, Vector3d.Zero);
        }

        // The weights of v₀ and w, and their integrals.
        double old = Math.Max(0, 1 - (s / Ramp));
        double own = Math.Min(1, Math.Min(s, left) / Ramp);
        double carried = 0.5 * Ramp * (1 - (old * old));
        double moved = s < Ramp ? 0.5 * Ramp * own * own : s - (0.5 * Ramp * (1 + ((1 - own) * (1 - own))));

        double duration = End - Start - Ramp;
        Vector3d velocity = Way / duration;
        Vector3d spin = Carried.SpinTo(To.Orientation, duration);
        var turned = Quaterniond.FromRotationVector(moved * spin);
        Quaterniond orientation = turned * Quaterniond.FromRotationVector(carried * From.Spin) * From.Pose.Orientation;
        var pose = new BallPose(From.Pose.Position + (carried * From.Velocity) + (moved * velocity), orientation.Normalized());
        return new KeeperState(in pose, (old * From.Velocity) + (own * velocity), (old * turned.Rotate(From.Spin)) + (own * spin));
    }
}

/// <summary>The pose of a keeper's body, its velocity in m/s, and its spin in rad/s.</summary>
internal readonly struct KeeperState(in BallPose pose, in Vector3d velocity, in Vector3d spin)
{
    /// <summary>The pose.</summary>
    public BallPose Pose { get; } = pose;

    /// <summary>The velocity of the centre, in m/s.</summary>
    public Vector3d Velocity { get; } = velocity;

    /// <summary>The spin, in rad/s.</summary>
    public Vector3d Spin { get; } = spin;
}
