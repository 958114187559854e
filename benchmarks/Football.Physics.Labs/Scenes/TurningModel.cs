namespace FootballPhysics.Labs.Scenes;

/// <summary>A shape that turns about its pivot and moves, exactly, and its distance from a point. It shares no code with the library's contacts.</summary>
/// <param name="A">One end of a capsule, the centre of a sphere or box, in the frame of the pivot, m.</param>
/// <param name="B">The other end of a capsule, or the half sizes of a box, m.</param>
/// <param name="Thickness">The radius of a capsule or sphere, m; 0 for a box.</param>
/// <param name="IsBox">True for a box.</param>
/// <param name="Start">The position of the pivot at time 0, m.</param>
/// <param name="Velocity">Velocity of the pivot, m/s.</param>
/// <param name="Axis">The axis, of length 1.</param>
/// <param name="Angle">The angle about the axis at time 0, rad.</param>
/// <param name="Rate">The rate about the axis, rad/s.</param>
internal sealed record TurningModel(Vector3d A, Vector3d B, double Thickness, bool IsBox, Vector3d Start, Vector3d Velocity, Vector3d Axis, double Angle, double Rate)
{
    /// <summary>A gap below this, m, is a hit.</summary>
    private const double Touches = 1e-10;

    /// <summary>The farthest point of the shape from the pivot, m.</summary>
    public double Reach => IsBox ? A.Length + B.Length : Math.Max(A.Length, B.Length) + Thickness;

    public Vector3d PivotAt(double time) => Start + (time * Velocity);

    /// <summary>Returns the point of the shape at a position in its own frame, at a time.</summary>
    public Vector3d WorldOf(in Vector3d own, double time) => PivotAt(time) + Turn(own, Angle + (Rate * time));

    /// <summary>Returns the velocity of the shape's material at a point, m/s.</summary>
    public Vector3d SurfaceVelocity(in Vector3d at, double time) => Velocity + Vector3d.Cross(Rate * Axis, at - PivotAt(time));

    /// <summary>Returns the distance from the surface, m; negative inside a capsule, 0 inside a box.</summary>
    /// <param name="point">The point, m.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="normal">The direction away from the shape; zero inside a box.</param>
    public double Distance(in Vector3d point, double time, out Vector3d normal)
    {
        Vector3d own = Turn(point - PivotAt(time), -(Angle + (Rate * time)));
        Vector3d nearest;
        if (IsBox)
        {
            Vector3d from = own - A;
            nearest = A + new Vector3d(Math.Clamp(from.X, -B.X, B.X), Math.Clamp(from.Y, -B.Y, B.Y), Math.Clamp(from.Z, -B.Z, B.Z));
        }
        else
        {
            Vector3d line = B - A;
            double length = line.LengthSquared;
            double share = length > 0 ? Math.Clamp(Vector3d.Dot(own - A, line) / length, 0, 1) : 0;
            nearest = A + (share * line);
        }

        Vector3d away = own - nearest;
        double distance = away.Length;
        normal = distance > 0 ? Turn(away / distance, Angle + (Rate * time)) : default;
        return distance - Thickness;
    }

    /// <summary>Returns the time at which a ball on a parabola first touches the shape; NaN if it does not.</summary>
    /// <param name="place">Returns the position of the ball's centre at a time.</param>
    /// <param name="speed">A speed, m/s, that the ball does not exceed.</param>
    /// <param name="radius">Its radius, m.</param>
    /// <param name="duration">The duration of the search, s.</param>
    /// <param name="least">The smallest gap, m; 0 after a hit.</param>
    public double FirstTouch(Func<double, Vector3d> place, double speed, double radius, double duration, out double least)
    {
        // No gap closes faster than this, so no step can miss a touch.
        double fastest = speed + Velocity.Length + (Math.Abs(Rate) * (Reach + radius)) + 1e-9;
        least = double.PositiveInfinity;
        double time = 0;
        while (time < duration)
        {
            double gap = Distance(place(time), time, out _) - radius;
            if (gap < Touches)
            {
                least = 0;
                return time;
            }

            least = Math.Min(least, gap);
            time += gap / fastest;
        }

        return double.NaN;
    }

    /// <summary>Rotates a vector by Rodrigues' formula.</summary>
    private Vector3d Turn(in Vector3d v, double angle)
    {
        double cosine = Math.Cos(angle);
        return (cosine * v) + (Math.Sin(angle) * Vector3d.Cross(Axis, v)) + ((1 - cosine) * Vector3d.Dot(Axis, v) * Axis);
    }
}
