using FootballPhysics.Numerics;

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

    private PathPolynomial _path;
    private double _perLength;

    /// <summary>Creates a segment in which the ball is at rest, or moves straight at constant speed.</summary>
    public static PathSpan Straight(double start, double end, in Vector3d from, in Vector3d to) => new(PathPolynomial.Line(in from, in to), start, end, end - start);

    /// <summary>Converts a path segment; its duration is above 0.</summary>
    public static PathSpan Of(in PathSegment piece, double end) => new(piece.Curve, piece.Time, end, piece.Length);

    private PathSpan(in PathPolynomial path, double start, double end, double length)
    {
        this = default;
        _path = path;
        _perLength = 1.0 / length;
        Start = start;
        End = end;
        Bound();
    }

    /// <summary>Returns the position at a time, in m.</summary>
    public readonly Vector3d PositionAt(double time) => _path.At((time - Start) * _perLength);

    /// <summary>Returns the velocity at a time, in m/s.</summary>
    public readonly Vector3d VelocityAt(double time) => _perLength * _path.RateAt((time - Start) * _perLength);

    /// <summary>Computes the bounds from the control points of the position and of its derivatives.</summary>
    private void Bound()
    {
        Span<Vector3d> points = stackalloc Vector3d[6];
        Span<Vector3d> derivatives = points.Slice(0, 4);
        _path.Accelerations(derivatives);
        double squared = _perLength * _perLength;
        Acceleration = squared * Fastest(derivatives);
        foreach (ref readonly Vector3d acceleration in derivatives)
        {
            VerticalAcceleration = Math.Max(VerticalAcceleration, squared * Math.Abs(acceleration.Y));
        }

        derivatives = points.Slice(0, 5);
        _path.Velocities(derivatives);
        Speed = _perLength * Fastest(derivatives);

        _path.Points(points);
        Lowest = double.PositiveInfinity;
        Highest = double.NegativeInfinity;
        foreach (ref readonly Vector3d point in points)
        {
            Lowest = Math.Min(Lowest, point.Y);
            Highest = Math.Max(Highest, point.Y);
        }
    }

    /// <summary>Returns the greatest horizontal length.</summary>
    private static double Fastest(Span<Vector3d> points)
    {
        double squared = 0;
        foreach (ref readonly Vector3d point in points)
        {
            squared = Math.Max(squared, (point.X * point.X) + (point.Z * point.Z));
        }

        return Math.Sqrt(squared);
    }
}
