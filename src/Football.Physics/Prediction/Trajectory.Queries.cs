using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <content>Queries on a path: apex, plane crossings, closest approaches and samples.</content>
public sealed partial class Trajectory
{
    /// <summary>The number of parts into which a segment is divided in the search for the closest approach.</summary>
    private const int Parts = 8;
    private const int MostHalvings = 60;

    /// <summary>Returns the highest point of the path, with its time and velocity.</summary>
    public PathPoint ApexPoint()
    {
        BallState end = Final;
        var best = new PathPoint(end.Time, end.Position, end.Velocity, 0);
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref Piece(i);
            if (i == 0 || piece.Apex > best.Position.Y)
            {
                best = At(in piece, piece.ApexTime);
            }
        }

        return best;
    }

    /// <summary>Returns the closest approach to a line segment, such as a bar, a leg or a line on the pitch.</summary>
    /// <param name="from">The first end, in m.</param>
    /// <param name="to">The second end, in m.</param>
    public PathPoint ClosestApproach(Vector3d from, Vector3d to)
    {
        BallState end = Final;
        var best = new PathPoint(end.Time, end.Position, end.Velocity, Distance(end.Position, in from, in to));
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref Piece(i);

            // A curve may approach the segment several times, so search each part separately.
            double part = piece.Length / Parts;
            for (int k = 0; k < Parts; k++)
            {
                double time = Closest(in piece, piece.Time + (k * part), piece.Time + ((k + 1) * part), in from, in to);
                double distance = Distance(piece.PositionAt(time), in from, in to);
                if (distance < best.Distance)
                {
                    best = At(in piece, time, distance);
                }
            }
        }

        return best;
    }

    /// <summary>Samples the positions of the path at equal intervals, for instance to draw a line.</summary>
    /// <param name="places">Receives the positions, in m.</param>
    /// <param name="interval">The time between two samples, in s; above 0.</param>
    /// <returns>The number of positions written. The first is the start; the last is the end of the path if there is room.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="interval"/> is out of range.</exception>
    public int Sample(Span<Vector3d> places, double interval)
    {
        Check.Positive(nameof(interval), interval);
        int count = 0;
        double time = StartTime;
        while (count < places.Length && time < EndTime)
        {
            places[count++] = PositionAt(time);

            // Multiply instead of adding, so that rounding errors do not accumulate.
            time = StartTime + (count * interval);
        }

        // Add the end itself if the buffer has room.
        if (count < places.Length)
        {
            places[count++] = Final.Position;
        }

        return count;
    }

    private static PathPoint At(in PathSegment piece, double time, double distance = 0) => new(time, piece.PositionAt(time), piece.VelocityAt(time), distance);

    /// <summary>Golden-section search for the closest approach over a part of a segment.</summary>
    private static double Closest(in PathSegment piece, double a, double b, in Vector3d from, in Vector3d to)
    {
        // (3 − √5)/2: each iteration reuses one of the two inner points, and needs only one new distance.
        const double Golden = 0.38196601125010515;
        double x = a + (Golden * (b - a));
        double y = b - (Golden * (b - a));
        double fx = Distance(piece.PositionAt(x), in from, in to);
        double fy = Distance(piece.PositionAt(y), in from, in to);
        for (int i = 0; i < MostHalvings && b - a > 1e-9; i++)
        {
            if (fx <= fy)
            {
                b = y;
                y = x;
                fy = fx;
                x = a + (Golden * (b - a));
                fx = Distance(piece.PositionAt(x), in from, in to);
            }
            else
            {
                a = x;
                x = y;
                fx = fy;
                y = b - (Golden * (b - a));
                fy = Distance(piece.PositionAt(y), in from, in to);
            }
        }

        return fx <= fy ? x : y;
    }

    /// <summary>Returns the distance of a point from a line segment, in m.</summary>
    private static double Distance(in Vector3d point, in Vector3d from, in Vector3d to)
    {
        Vector3d along = to - from;
        double squared = along.LengthSquared;

        // Use the foot of the perpendicular, clamped to the segment.
        double share = squared > 0 ? Vector3d.Dot(point - from, in along) / squared : 0;
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        return Vector3d.Distance(in point, from + (share * along));
    }
}
