namespace FootballPhysics.Prediction;

/// <content>Questions that a path answers: the highest point, crossings, closest approaches, places at equal times.</content>
public sealed partial class Trajectory
{
    /// <summary>Parts that a piece is looked at in, for the closest of several approaches to a segment.</summary>
    private const int Parts = 8;
    private const int MostHalvings = 60;

    /// <summary>The highest point of a path: when and where, and how fast the ball is there.</summary>
    public PathPoint ApexPoint()
    {
        BallState end = Final;
        var best = new PathPoint(end.Time, end.Position, end.Velocity, 0);
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref Piece(i);
            if (i == 0 || piece.Apex > best.Position.Y)
            {
                double time = piece.ApexTime;
                best = new PathPoint(time, piece.PositionAt(time), piece.VelocityAt(time), 0);
            }
        }

        return best;
    }

    /// <summary>One of the crossings of a plane.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="index">Which, from 0, of those in the direction.</param>
    /// <param name="direction">Which way.</param>
    /// <param name="crossing">Where and when.</param>
    /// <returns>False where there are not so many.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="plane"/> was never made, <paramref name="index"/> is negative, or <paramref name="direction"/> none of the enumeration.</exception>
    public bool TryGetCrossing(in Plane3d plane, int index, CrossingDirection direction, out PathPoint crossing)
    {
        plane.Validate(nameof(plane));
        Check.AtLeast(nameof(index), index, 0);
        Check.Defined(nameof(direction), direction, (int)direction, 3);
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref Piece(i);
            if (!piece.Crosses(plane.Point, plane.Normal, out double time))
            {
                continue;
            }

            // The first crossing of a piece goes the way from the side on which it starts, a second one back.
            bool along = Vector3d.Dot(piece.StartPosition - plane.Point, plane.Normal) < 0;
            if (IsWanted(direction, along) && index-- == 0)
            {
                crossing = At(in piece, time);
                return true;
            }

            if (piece.CrossesBack(plane.Point, plane.Normal, time, out double back) && IsWanted(direction, !along) && index-- == 0)
            {
                crossing = At(in piece, back);
                return true;
            }
        }

        crossing = default;
        return false;
    }

    /// <summary>The closest approach to a segment: a bar, a leg, a line on the pitch.</summary>
    /// <param name="from">One end, m.</param>
    /// <param name="to">The other end, m.</param>
    public PathPoint ClosestApproach(Vector3d from, Vector3d to)
    {
        BallState end = Final;
        var best = new PathPoint(end.Time, end.Position, end.Velocity, Distance(end.Position, in from, in to));
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref Piece(i);

            // A curve may come near a segment several times within a piece: each part is searched by itself.
            double part = piece.Length / Parts;
            for (int k = 0; k < Parts; k++)
            {
                double time = Closest(in piece, piece.Time + (k * part), piece.Time + ((k + 1) * part), in from, in to);
                double distance = Distance(piece.PositionAt(time), in from, in to);
                if (distance < best.Distance)
                {
                    best = new PathPoint(time, piece.PositionAt(time), piece.VelocityAt(time), distance);
                }
            }
        }

        return best;
    }

    /// <summary>Writes places of the path at equal intervals: for a line that is drawn.</summary>
    /// <param name="places">Where they go, m.</param>
    /// <param name="interval">Time between two of them, s; above 0.</param>
    /// <returns>How many were written: the first is the start; none is after the end of the path, which is the last where there is room.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="interval"/> is out of range.</exception>
    public int Sample(Span<Vector3d> places, double interval)
    {
        Check.Positive(nameof(interval), interval);
        int count = 0;
        double time = StartTime;
        while (count < places.Length && time < EndTime)
        {
            places[count++] = PositionAt(time);

            // Not summed up, so that rounding does not grow.
            time = StartTime + (count * interval);
        }

        // The end itself, where there is room for it.
        if (count < places.Length)
        {
            places[count++] = Final.Position;
        }

        return count;
    }

    private static bool IsWanted(CrossingDirection direction, bool along) =>
        direction == CrossingDirection.Any || along == (direction == CrossingDirection.AlongNormal);

    private static PathPoint At(in PathSegment piece, double time) => new(time, piece.PositionAt(time), piece.VelocityAt(time), 0);

    /// <summary>Golden section over a part of a piece.</summary>
    private static double Closest(in PathSegment piece, double a, double b, in Vector3d from, in Vector3d to)
    {
        // (3 − √5)/2: each step keeps one of the two inner points, and needs one new distance.
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

    /// <summary>Distance of a point from a segment, m.</summary>
    private static double Distance(in Vector3d point, in Vector3d from, in Vector3d to)
    {
        Vector3d along = to - from;
        double squared = along.LengthSquared;

        // The foot of the perpendicular, kept between the ends.
        double share = squared > 0 ? Vector3d.Dot(point - from, in along) / squared : 0;
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        return Vector3d.Distance(in point, from + (share * along));
    }
}
