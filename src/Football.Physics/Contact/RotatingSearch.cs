namespace FootballPhysics;

/// <summary>A shape and its motion, relative to a start time.</summary>
internal readonly struct MovingShape
{
    private readonly IShape _shape;
    private readonly RigidMotion _motion;

    /// <summary>Describes a moving shape.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="motion">Its motion.</param>
    /// <param name="time">The start time, which becomes time 0.</param>
    public MovingShape(IShape shape, in RigidMotion motion, double time)
    {
        _shape = shape;
        _motion = motion;
        _motion.GoTo(time);
        _motion.Time = 0;
    }

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity => _motion.Velocity;

    /// <summary>The pivot at time 0, m.</summary>
    public Vector3d Pivot => _motion.Pivot;

    /// <summary>|Ω|, rad/s.</summary>
    public double SpinRate => _motion.Spin.Length;

    /// <summary>The greatest speed that the rotation gives to any part of it, m/s.</summary>
    public double Swing => _motion.Swing;

    /// <summary>Returns the distance of a moving point from the shape, and its rate, m/s.</summary>
    public double Distance(in Vector3d position, in Vector3d velocity, double time, out double rate)
    {
        // Along n, this point of the rotating shape moves at the same speed as the shape's nearest point.
        ShapePoint at = _motion.At(_shape, in position, time);
        rate = Vector3d.Dot(velocity - _motion.SurfaceVelocity(in position, time), at.Normal);
        return at.Distance;
    }
}

/// <summary>Finds the first contact with a rotating shape by conservative advancement, as in <see cref="ContactSearch"/>.</summary>
/// <remarks>
/// The rate and the second derivative of the gap are bounded for the path in the rotating frame, where the shape is at rest.
/// </remarks>
internal static class RotatingSearch
{
    /// <summary>Maximum closing speed of a slow gap, m/s.</summary>
    private const double Slow = 0.01;

    /// <summary>Returns the time of the first closing contact; infinite if there is none.</summary>
    /// <param name="shape">The shape, from the start of the path.</param>
    /// <param name="hollow">Its largest concave curvature, 1/m.</param>
    /// <param name="path">The path.</param>
    /// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
    /// <param name="radius">Radius of the ball, m.</param>
    /// <param name="until">End of the search, s from the start of the path.</param>
    public static double FirstContact(in MovingShape shape, double hollow, in PathCubic path, double acceleration, double radius, double until)
    {
        // Upper bounds of |w|, w = v − V, and of ρ, the ball's distance from the pivot.
        PathCubic seen = path.SeenFrom(shape.Pivot, shape.Velocity);
        Bounds3d box = seen.Bounds;
        double farthest = new Vector3d(Math.Max(-box.Min.X, box.Max.X), Math.Max(-box.Min.Y, box.Max.Y), Math.Max(-box.Min.Z, box.Max.Z)).Length;
        double speed = seen.FastestSpeed;
        double spin = shape.SpinRate;

        // The gap closes at most at |w| plus the rotation speed: of the ball about the pivot, or of the shape if that is smaller.
        double around = spin * farthest;
        double closing = speed + Math.Min(around, shape.Swing);

        // q̈ = a − 2 Ω × w + Ω × (Ω × ρ). A convex surface bends away from the path; a concave one bends towards it by |q̇|² κ/(1 − κ d).
        double whole = speed + around;
        double bend = acceleration + (spin * ((2.0 * speed) + around));
        bend += hollow > 0 ? whole * whole * hollow / (1.0 - ((1.0 + ContactSearch.NearHollow) * radius * hollow)) : 0;
        double shortest = ContactSearch.ShortestOf(in path);
        double t = 0;
        while (true)
        {
            double gap = shape.Distance(path.At(t), path.VelocityAt(t), t, out double rate) - radius;
            if (gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching)
            {
                return t;
            }

            // Take the longer of two safe steps. Far from a concave surface only the speed bound is valid; near it, limit the step by the
            // bend.
            double byBend = ContactSearch.Safe(Math.Max(gap, 0) + (rate > -Slow ? ContactTolerances.SlowSink : 0), rate, bend);
            byBend = !(hollow > 0) ? byBend : gap < ContactSearch.NearHollow * radius ? Math.Min(byBend, ((ContactSearch.NearHollow * radius) - gap) / whole) : 0;
            if (!ContactSearch.Advance(ref t, Math.Max(byBend, Math.Max(gap, 0) / closing), shortest, until))
            {
                return double.PositiveInfinity;
            }
        }
    }
}
