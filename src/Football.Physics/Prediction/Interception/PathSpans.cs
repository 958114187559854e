namespace FootballPhysics.Prediction;

/// <summary>A path as contiguous segments up to a time; a ball that came to rest stays there. The buffer is reused.</summary>
internal sealed class PathSpans
{
    /// <summary>The gap between two segments, in s, up to which they count as contiguous; in a larger gap, the ball is at rest.</summary>
    private const double Meeting = 1e-9;

    /// <summary>The segments.</summary>
    public PathSpan[] Items = [];

    /// <summary>The number of segments.</summary>
    public int Count { get; private set; }

    /// <summary>The start time, in s.</summary>
    public double Start { get; private set; }

    /// <summary>The end time, in s.</summary>
    public double End { get; private set; }

    /// <summary>Loads a path.</summary>
    /// <param name="path">The path.</param>
    /// <param name="until">The end time, in s; a path that ends in motion may end earlier.</param>
    public void Take(Trajectory path, double until)
    {
        Count = 0;
        Start = path.StartTime;

        // A ball at rest at the end of the path stays there. If it still moves, its later position is unknown.
        End = path.Final.Motion == MotionState.Rest ? Math.Max(until, path.StartTime) : Math.Min(until, path.EndTime);
        int pieces = path.Count;

        // At most one rest follows each segment, and one follows the end.
        if (Items.Length < (2 * pieces) + 1)
        {
            Items = new PathSpan[(2 * pieces) + 1];
        }

        for (int i = 0; i < pieces; i++)
        {
            ref readonly PathSegment piece = ref path.Piece(i);

            // Extend each segment to the start of the next one, so that rounding leaves no gap.
            double end = i + 1 < pieces ? path.Piece(i + 1).Time : piece.EndTime;
            bool waits = end - piece.EndTime > Meeting;
            end = waits ? piece.EndTime : end;
            if (piece.Length > 0 && end > piece.Time && piece.Time < End)
            {
                Items[Count++] = PathSpan.Of(in piece, end);
            }

            if (waits)
            {
                Items[Count++] = PathSpan.Straight(end, path.Piece(i + 1).Time, piece.EndPosition, path.Piece(i + 1).StartPosition);
            }
        }

        double last = Count > 0 ? Items[Count - 1].End : Start;
        if (End > last)
        {
            Items[Count++] = PathSpan.Straight(last, End, path.Final.Position, path.Final.Position);
        }

        // Go backwards to compute the maximum speed from each segment to the end of the path.
        double fastest = 0;
        for (int i = Count - 1; i >= 0; i--)
        {
            fastest = Math.Max(fastest, Items[i].Speed);
            Items[i].SpeedFromHere = fastest;
        }
    }

    /// <summary>Returns the index of the segment that contains a time; the later one at a boundary.</summary>
    public int Find(double time)
    {
        int low = 0;
        int high = Count - 1;
        while (low < high)
        {
            int middle = (low + high + 1) / 2;
            if (Items[middle].Start <= time)
            {
                low = middle;
            }
            else
            {
                high = middle - 1;
            }
        }

        return low;
    }
}
