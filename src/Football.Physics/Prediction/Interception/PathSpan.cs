namespace FootballPhysics.Prediction;

/// <summary>A path segment as a polynomial of degree five in the fraction of its duration, with bounds on speed, acceleration and height.</summary>
internal struct PathSpan
{
    /// <summary>The start time, in s.</summary>
    public double Start;

    /// <summary>The end time, in s.</summary>
    public double End;

    /// <summary>The upper bound of the horizontal speed, in m/s.</summary>
    public double Speed;

    /// <summary>The upper bound of the horizontal speed from here to the end of the path, in m/s.</summary>
    public double SpeedFromHere;

    /// <summary>The upper bound of the horizontal acceleration, in m/s².</summary>
    public double Acceleration;

    /// <summary>The upper bound of the vertical acceleration, in m/s².</summary>
    public double VerticalAcceleration;

    /// <summary>The lower bound of the height, in m.</summary>
    public double Lowest;

    /// <summary>The upper bound of the height, in m.</summary>
    public double Highest;

    private Vector3d _c0;
    private Vector3d _c1;
    private Vector3d _c2;
    private Vector3d _c3;
    private Vector3d _c4;
    private Vector3d _c5;
    private double _perLength;

    /// <summary>Creates a segment in which the ball is at rest, or moves straight at constant speed.</summary>
    public static PathSpan Straight(double start, double end, in Vector3d from, in Vector3d to)
    {
        PathSpan span = default;
        span.Start = start;
        span.End = end;
        span._perLength = 1.0 / (end - start);
        span._c0 = from;
        span._c1 = to - from;
        span.Bound();
        return span;
    }

    /// <summary>Converts a path segment; its duration is above 0.</summary>
    public static PathSpan Of(in PathSegment piece, double end)
    {
        // c₀ + c₁ s + … + c₅ s⁵ with s = (t − start)/length; the degree is that of the integrator's segment.
        double h = piece.Length;
        PathSpan span = default;
        span.Start = piece.Time;
        span.End = end;
        span._perLength = 1.0 / h;
        span._c0 = piece.StartPosition;
        span._c1 = h * piece.StartVelocity;
        Vector3d rise = piece.EndPosition - piece.StartPosition - span._c1;
        switch (piece.Degree)
        {
            // The quadratic term is the deviation of the end position from steady motion.
            case 2:
                span._c2 = rise;
                break;

            // The cubic Hermite interpolant of both positions and velocities.
            case 3:
                Vector3d turn = h * (piece.EndVelocity - piece.StartVelocity);
                span._c2 = (3.0 * rise) - turn;
                span._c3 = turn - (2.0 * rise);
                break;
            default:
                // As in QuinticHermite3d, use the end position, velocity and acceleration that remain after the quadratic part.
                span._c2 = 0.5 * h * h * piece.StartAcceleration;
                Vector3d p = rise - span._c2;
                Vector3d v = (h * (piece.EndVelocity - piece.StartVelocity)) - (2.0 * span._c2);
                Vector3d a = h * h * (piece.EndAcceleration - piece.StartAcceleration);
                span._c3 = (10.0 * p) - (4.0 * v) + (0.5 * a);
                span._c4 = (-15.0 * p) + (7.0 * v) - a;
                span._c5 = (6.0 * p) - (3.0 * v) + (0.5 * a);
                break;
        }

        span.Bound();
        return span;
    }

    /// <summary>Returns the position at a time, in m.</summary>
    public readonly Vector3d PositionAt(double time)
    {
        double s = (time - Start) * _perLength;
        return _c0 + (s * (_c1 + (s * (_c2 + (s * (_c3 + (s * (_c4 + (s * _c5)))))))));
    }

    /// <summary>Returns the velocity at a time, in m/s.</summary>
    public readonly Vector3d VelocityAt(double time)
    {
        double s = (time - Start) * _perLength;
        return _perLength * (_c1 + (s * ((2.0 * _c2) + (s * ((3.0 * _c3) + (s * ((4.0 * _c4) + (5.0 * s * _c5))))))));
    }

    /// <summary>Returns the horizontal position at a time, in m.</summary>
    public readonly void PlaceAt(double time, out double x, out double z)
    {
        double s = (time - Start) * _perLength;
        x = _c0.X + (s * (_c1.X + (s * (_c2.X + (s * (_c3.X + (s * (_c4.X + (s * _c5.X)))))))));
        z = _c0.Z + (s * (_c1.Z + (s * (_c2.Z + (s * (_c3.Z + (s * (_c4.Z + (s * _c5.Z)))))))));
    }

    /// <summary>Computes the bounds from Bernstein coefficients, b_i = Σ_j (i over j)/(n over j) c_j: a polynomial over 0 … 1 stays within their
    /// hull.</summary>
    private void Bound()
    {
        // Second derivative, of degree 3: 2 c₂ + 6 c₃ s + 12 c₄ s² + 20 c₅ s³.
        Vector3d a0 = 2.0 * _c2;
        Vector3d a1 = a0 + (2.0 * _c3);
        Vector3d a2 = a0 + (4.0 * _c3) + (4.0 * _c4);
        Vector3d a3 = a0 + (6.0 * _c3) + (12.0 * _c4) + (20.0 * _c5);
        double squared = _perLength * _perLength;
        Acceleration = squared * Math.Sqrt(Math.Max(Math.Max(Flat(in a0), Flat(in a1)), Math.Max(Flat(in a2), Flat(in a3))));
        VerticalAcceleration = squared * Math.Max(Math.Max(Math.Abs(a0.Y), Math.Abs(a1.Y)), Math.Max(Math.Abs(a2.Y), Math.Abs(a3.Y)));

        // First derivative, of degree 4: c₁ + 2 c₂ s + 3 c₃ s² + 4 c₄ s³ + 5 c₅ s⁴.
        Vector3d v1 = _c1 + (0.5 * _c2);
        Vector3d v2 = _c1 + _c2 + (0.5 * _c3);
        Vector3d v3 = _c1 + (1.5 * _c2) + (1.5 * _c3) + _c4;
        Vector3d v4 = _c1 + (2.0 * _c2) + (3.0 * _c3) + (4.0 * _c4) + (5.0 * _c5);
        Speed = _perLength * Math.Sqrt(Math.Max(Math.Max(Math.Max(Flat(in _c1), Flat(in v1)), Flat(in v2)), Math.Max(Flat(in v3), Flat(in v4))));

        // The height itself, of degree 5.
        double y1 = _c0.Y + (0.2 * _c1.Y);
        double y2 = _c0.Y + (0.4 * _c1.Y) + (0.1 * _c2.Y);
        double y3 = _c0.Y + (0.6 * _c1.Y) + (0.3 * _c2.Y) + (0.1 * _c3.Y);
        double y4 = _c0.Y + (0.8 * _c1.Y) + (0.6 * _c2.Y) + (0.4 * _c3.Y) + (0.2 * _c4.Y);
        double y5 = _c0.Y + _c1.Y + _c2.Y + _c3.Y + _c4.Y + _c5.Y;
        Lowest = Math.Min(Math.Min(Math.Min(_c0.Y, y1), Math.Min(y2, y3)), Math.Min(y4, y5));
        Highest = Math.Max(Math.Max(Math.Max(_c0.Y, y1), Math.Max(y2, y3)), Math.Max(y4, y5));
    }

    private static double Flat(in Vector3d v) => (v.X * v.X) + (v.Z * v.Z);
}
