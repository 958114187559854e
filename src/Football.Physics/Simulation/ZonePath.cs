namespace FootballPhysics.Simulation;

/// <summary>The path of a piece as a polynomial of degree five in s, the elapsed share of the piece, 0 … 1.</summary>
internal readonly struct ZonePath
{
    private readonly Vector3d _c0;
    private readonly Vector3d _c1;
    private readonly Vector3d _c2;
    private readonly Vector3d _c3;
    private readonly Vector3d _c4;
    private readonly Vector3d _c5;

    /// <param name="p">Position at its start, m.</param>
    /// <param name="v">Velocity at its start, times its length, m.</param>
    /// <param name="a">Acceleration at its start, times the square of its length, m.</param>
    /// <param name="way">Displacement from its start to its end, m.</param>
    /// <param name="w">Velocity at its end, times its length, m.</param>
    /// <param name="b">Acceleration at its end, times the square of its length, m.</param>
    private ZonePath(in Vector3d p, in Vector3d v, in Vector3d a, in Vector3d way, in Vector3d w, in Vector3d b)
    {
        // The quintic Hermite interpolant of both ends.
        _c0 = p;
        _c1 = v;
        _c2 = 0.5 * a;
        _c3 = (10.0 * way) - (6.0 * v) - (4.0 * w) - (1.5 * a) + (0.5 * b);
        _c4 = (-15.0 * way) + (8.0 * v) + (7.0 * w) + (1.5 * a) - b;
        _c5 = (6.0 * way) - (3.0 * v) - (3.0 * w) - (0.5 * a) + (0.5 * b);

        // The control points of the Bézier form: their convex hull contains the curve. The same is true of the derivatives.
        Vector3d end = p + way;
        Vector3d p1 = p + (0.2 * v);
        Vector3d p2 = p + (0.4 * v) + (0.05 * a);
        Vector3d p3 = end - (0.4 * w) + (0.05 * b);
        Vector3d p4 = end - (0.2 * w);
        Bounds = BoundsOf(in p, in p1, in p2).Union(BoundsOf(in p3, in p4, in end));
        FastestSpeed = 5.0 * Math.Sqrt(Math.Max(
            Math.Max((p1 - p).LengthSquared, (p2 - p1).LengthSquared), Math.Max((p3 - p2).LengthSquared, Math.Max((p4 - p3).LengthSquared, (end - p4).LengthSquared))));
        GreatestAcceleration = 20.0 * Math.Sqrt(Math.Max(
            Math.Max(Second(in p, in p1, in p2), Second(in p1, in p2, in p3)), Math.Max(Second(in p2, in p3, in p4), Second(in p3, in p4, in end))));
    }

    /// <summary>A bounding box of the path.</summary>
    public Bounds3d Bounds { get; }

    /// <summary>Upper bound of |dp/ds|, m.</summary>
    public double FastestSpeed { get; }

    /// <summary>Upper bound of |d²p/ds²|, m.</summary>
    public double GreatestAcceleration { get; }

    /// <summary>Creates a straight path.</summary>
    public static ZonePath Line(in Vector3d from, in Vector3d to)
    {
        Vector3d way = to - from;
        return new ZonePath(in from, in way, Vector3d.Zero, in way, in way, Vector3d.Zero);
    }

    /// <summary>Creates the path of a piece, equal to that of <see cref="PathSegment"/>.</summary>
    /// <param name="before">The ball at the start of the piece.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="startAcceleration">Acceleration at the start, m/s².</param>
    /// <param name="endAcceleration">Acceleration at the end, m/s².</param>
    /// <param name="degree">2: the quadratic of a low-order integrator; 3: the cubic; 5: the quintic.</param>
    public static ZonePath Of(in BallState before, in BallState after, in Vector3d startAcceleration, in Vector3d endAcceleration, int degree)
    {
        double h = after.Time - before.Time;
        Vector3d p = before.Position;
        Vector3d way = after.Position - p;
        Vector3d v = h * before.Velocity;
        Vector3d w = h * after.Velocity;
        if (degree == 5)
        {
            return new ZonePath(in p, in v, h * h * startAcceleration, in way, in w, h * h * endAcceleration);
        }

        // The accelerations at both ends of a quadratic or a cubic.
        Vector3d bend = 2.0 * (way - v);
        return degree == 2
            ? new ZonePath(in p, in v, in bend, in way, v + bend, in bend)
            : new ZonePath(in p, in v, (6.0 * way) - (4.0 * v) - (2.0 * w), in way, in w, (-6.0 * way) + (2.0 * v) + (4.0 * w));
    }

    /// <summary>Returns the position, m.</summary>
    public Vector3d At(double s) => _c0 + (s * (_c1 + (s * (_c2 + (s * (_c3 + (s * (_c4 + (s * _c5)))))))));

    /// <summary>Returns dp/ds, m.</summary>
    public Vector3d RateAt(double s) => _c1 + (s * ((2.0 * _c2) + (s * ((3.0 * _c3) + (s * ((4.0 * _c4) + (s * (5.0 * _c5))))))));

    private static double Second(in Vector3d a, in Vector3d b, in Vector3d c) => (a - (2.0 * b) + c).LengthSquared;

    private static Bounds3d BoundsOf(in Vector3d a, in Vector3d b, in Vector3d c) => new(
        new Vector3d(Math.Min(a.X, Math.Min(b.X, c.X)), Math.Min(a.Y, Math.Min(b.Y, c.Y)), Math.Min(a.Z, Math.Min(b.Z, c.Z))),
        new Vector3d(Math.Max(a.X, Math.Max(b.X, c.X)), Math.Max(a.Y, Math.Max(b.Y, c.Y)), Math.Max(a.Z, Math.Max(b.Z, c.Z))));
}
