namespace FootballPhysics.Prediction;

/// <summary>The conditions of a meeting at one instant, and their rates.</summary>
internal struct MeetingPoint
{
    private double _near;
    private double _nearRate;
    private double _low;
    private double _high;
    private double _climb;

    /// <summary>Distance from the runner's middle, m.</summary>
    public double Distance;

    /// <summary>The conditions.</summary>
    /// <param name="span">The path.</param>
    /// <param name="runner">The runner.</param>
    /// <param name="time">When, s.</param>
    /// <param name="reacts">Whether the rates are those after his reaction.</param>
    /// <param name="at">The conditions there.</param>
    public static void At(in PathSpan span, in RunnerMotion runner, double time, bool reacts, out MeetingPoint at)
    {
        Vector3d p = span.PositionAt(time);
        Vector3d v = span.VelocityAt(time);
        runner.MiddleAt(time, out double x, out double z);
        runner.MiddleVelocity(reacts, out double vx, out double vz);

        // w = ball − middle of his circle, over the ground; R the radius of that.
        double dx = p.X - x;
        double dz = p.Z - z;
        double radius = runner.RadiusAt(time);
        double squared = (dx * dx) + (dz * dz);

        // q = R² − |w|²,  q̇ = 2 (R Ṙ − w·ẇ)
        at.Distance = Math.Sqrt(squared);
        at._near = (radius * radius) - squared;
        at._nearRate = 2.0 * ((radius * runner.GrowthAt(time)) - (dx * (v.X - vx)) - (dz * (v.Z - vz)));

        // h − h₀ and h₁ − h: their rates are ±ẏ.
        at._low = p.Y - runner.Lowest;
        at._high = runner.Highest - p.Y;
        at._climb = v.Y;
    }

    /// <summary>A condition: it holds where this is not negative.</summary>
    public readonly double Value(MeetingCondition what) =>
        what == MeetingCondition.Near ? _near : what == MeetingCondition.NotTooLow ? _low : _high;

    /// <summary>Its rate, 1/s of its unit.</summary>
    public readonly double Slope(MeetingCondition what) =>
        what == MeetingCondition.Near ? _nearRate : what == MeetingCondition.NotTooLow ? _climb : -_climb;
}
