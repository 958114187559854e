namespace FootballPhysics.Prediction;

/// <summary>The conditions for a meeting at one time, and their rates of change.</summary>
internal struct MeetingPoint
{
    private double _near;
    private double _nearRate;
    private double _low;
    private double _high;
    private double _climb;

    /// <summary>The horizontal distance of the ball from the centre of the player's circle, in m.</summary>
    public double Distance;

    /// <summary>Evaluates the conditions.</summary>
    /// <param name="span">The path segment.</param>
    /// <param name="runner">The player.</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="reacts">True for the rates after his reaction.</param>
    /// <param name="at">The result.</param>
    public static void At(in PathSpan span, in RunnerMotion runner, double time, bool reacts, out MeetingPoint at)
    {
        Vector3d p = span.PositionAt(time);
        Vector3d v = span.VelocityAt(time);
        runner.MiddleAt(time, out double x, out double z);
        runner.MiddleVelocity(reacts, out double vx, out double vz);

        // w is the horizontal vector from the centre of the player's circle to the ball; R is the circle's radius.
        double dx = p.X - x;
        double dz = p.Z - z;
        double radius = runner.RadiusAt(time);
        double squared = (dx * dx) + (dz * dz);

        // Distance condition and its rate: q = R² − |w|²,  q̇ = 2 (R Ṙ − w·ẇ).
        at.Distance = Math.Sqrt(squared);
        at._near = (radius * radius) - squared;
        at._nearRate = 2.0 * ((radius * runner.GrowthAt(time)) - (dx * (v.X - vx)) - (dz * (v.Z - vz)));

        // The height conditions y − h₀ and h₁ − y have the rates ±ẏ.
        at._low = p.Y - runner.Lowest;
        at._high = runner.Highest - p.Y;
        at._climb = v.Y;
    }

    /// <summary>Returns the value of a condition, which holds if the value is not negative.</summary>
    public readonly double Value(MeetingCondition what) =>
        what == MeetingCondition.Near ? _near : what == MeetingCondition.NotTooLow ? _low : _high;

    /// <summary>Returns the rate of a condition, in its unit per s.</summary>
    public readonly double Slope(MeetingCondition what) =>
        what == MeetingCondition.Near ? _nearRate : what == MeetingCondition.NotTooLow ? _climb : -_climb;
}
