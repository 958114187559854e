namespace FootballPhysics.Numerics;

/// <summary>The path of a segment as a cubic in time: close to the integrated path, and cheap to search.</summary>
/// <param name="c0">The position at the start, in m.</param>
/// <param name="c1">The coefficient of t, in m/s.</param>
/// <param name="c2">The coefficient of t².</param>
/// <param name="c3">The coefficient of t³.</param>
/// <param name="length">The duration, in s.</param>
internal readonly struct PathCubic(in Vector3d c0, in Vector3d c1, in Vector3d c2, in Vector3d c3, double length)
{
    /// <summary>The position at the start, in m.</summary>
    public readonly Vector3d Start = c0;

    /// <summary>The coefficients of t, t² and t³.</summary>
    public readonly Vector3d C1 = c1;
    public readonly Vector3d C2 = c2;
    public readonly Vector3d C3 = c3;

    /// <summary>The duration, in s.</summary>
    public double Length { get; } = length;

    /// <summary>A bound on the speed, in m/s: the maximum over the control points of the velocity.</summary>
    public double FastestSpeed
    {
        get
        {
            // A velocity that is quadratic in time stays in the convex hull of its three control points.
            Vector3d middle = C1 + (Length * C2);
            return Math.Sqrt(Math.Max(C1.LengthSquared, Math.Max(middle.LengthSquared, VelocityAt(Length).LengthSquared)));
        }
    }

    /// <summary>The greatest acceleration, in m/s². It is linear in time, so it is greatest at an end.</summary>
    public double GreatestAcceleration
    {
        get
        {
            Vector3d end = (2.0 * C2) + ((6.0 * Length) * C3);
            return Math.Sqrt(Math.Max(4.0 * C2.LengthSquared, end.LengthSquared));
        }
    }

    /// <summary>A bounding box: that of the control points.</summary>
    public Bounds3d Bounds
    {
        get
        {
            // A Bézier curve stays in the convex hull of its control points.
            Vector3d first = Start + (Length / 3.0 * C1);
            Vector3d second = Start + (Length * ((2.0 / 3.0 * C1) + (Length / 3.0 * C2)));
            Vector3d end = At(Length);
            return new Bounds3d(
                new Vector3d(Least(Start.X, first.X, second.X, end.X), Least(Start.Y, first.Y, second.Y, end.Y), Least(Start.Z, first.Z, second.Z, end.Z)),
                new Vector3d(Most(Start.X, first.X, second.X, end.X), Most(Start.Y, first.Y, second.Y, end.Y), Most(Start.Z, first.Z, second.Z, end.Z)));
        }
    }

    /// <summary>A bound on the distance from the straight line between the ends, in m.</summary>
    public double Deviation
    {
        get
        {
            // The path stays in the convex hull of its control points: compare each with its counterpart on the line.
            double scale = Length * Length / 3.0;
            double first = (C2 + (Length * C3)).LengthSquared;
            double second = (C2 + ((2.0 * Length) * C3)).LengthSquared;
            return scale * Math.Sqrt(Math.Max(first, second));
        }
    }

    /// <summary>Returns a straight path.</summary>
    public static PathCubic Line(in Vector3d from, in Vector3d velocity, double length) => new(in from, in velocity, default, default, length);

    /// <summary>Returns the Hermite interpolant between two positions with velocities.</summary>
    /// <param name="position">The position at the start, in m.</param>
    /// <param name="velocity">The velocity at the start, in m/s.</param>
    /// <param name="end">The position at the end, in m.</param>
    /// <param name="endVelocity">The velocity at the end, in m/s.</param>
    /// <param name="h">The length, in s.</param>
    /// <param name="isQuadratic">Whether to ignore the velocity at the end: the own path of a method of low order is a quadratic.</param>
    public static PathCubic Between(in Vector3d position, in Vector3d velocity, in Vector3d end, in Vector3d endVelocity, double h, bool isQuadratic = false)
    {
        if (!(h > 0))
        {
            return Line(in position, in velocity, 0);
        }

        // The deviation from uniform motion at the end.
        Vector3d bend = end - position - (h * velocity);
        double perLength = 1.0 / h;
        double perSquared = perLength * perLength;

        // p₀ and v₀ are position and velocity at the start, p₁ and v₁ those at the end, after the time h.
        // p₀ + v₀ t + (p₁ − p₀ − v₀ h) t²/h²
        if (isQuadratic)
        {
            return new PathCubic(in position, in velocity, perSquared * bend, default, h);
        }

        // p₀ + v₀ t + c₂ t² + c₃ t³ with p(h) = p₁ and p'(h) = v₁
        Vector3d change = h * (endVelocity - velocity);
        return new PathCubic(in position, in velocity, perSquared * ((3.0 * bend) - change), perSquared * perLength * (change - (2.0 * bend)), h);
    }

    /// <summary>Returns the position at a time, in m.</summary>
    public Vector3d At(double t) => Start + (t * (C1 + (t * (C2 + (t * C3)))));

    /// <summary>Returns the velocity at a time, in m/s.</summary>
    public Vector3d VelocityAt(double t) => C1 + (t * ((2.0 * C2) + ((3.0 * t) * C3)));

    /// <summary>Returns the acceleration at a time, in m/s².</summary>
    public Vector3d AccelerationAt(double t) => (2.0 * C2) + ((6.0 * t) * C3);

    /// <summary>Returns the path relative to an object with constant velocity.</summary>
    /// <param name="origin">The object's origin at the start of the path, in m.</param>
    /// <param name="velocity">The object's velocity, in m/s.</param>
    public PathCubic SeenFrom(in Vector3d origin, in Vector3d velocity) => new(Start - origin, C1 - velocity, in C2, in C3, Length);

    /// <summary>Returns the rotated path.</summary>
    public PathCubic Rotated(in Quaterniond by) => new(by.Rotate(in Start), by.Rotate(in C1), by.Rotate(in C2), by.Rotate(in C3), Length);

    private static double Least(double a, double b, double c, double d) => Math.Min(Math.Min(a, b), Math.Min(c, d));

    private static double Most(double a, double b, double c, double d) => Math.Max(Math.Max(a, b), Math.Max(c, d));
}
