namespace FootballPhysics.Prediction;

/// <summary>A path as spans without a gap, up to a time: a ball that came to rest stays there. Its memory is used again.</summary>
internal sealed class PathSpans
{
    /// <summary>Two pieces this close, s, meet: more is a wait that no piece tells of.</summary>
    private const double Meeting = 1e-9;

    /// <summary>The spans.</summary>
    public PathSpan[] Items = [];

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>When they begin, s.</summary>
    public double Start { get; private set; }

    /// <summary>When they end, s.</summary>
    public double End { get; private set; }

    /// <summary>Takes a path.</summary>
    /// <param name="path">The path.</param>
    /// <param name="until">Up to when, s; a path that ends in motion ends sooner.</param>
    public void Take(Trajectory path, double until)
    {
        Count = 0;
        Start = path.StartTime;

        // A ball at rest can be waited for; one that still moves is unknown from the end of the path on.
        End = path.Final.Motion == MotionState.Rest ? Math.Max(until, path.StartTime) : Math.Min(until, path.EndTime);
        int pieces = path.Count;

        // A wait after each piece at most, and the rest at the end.
        if (Items.Length < (2 * pieces) + 1)
        {
            Items = new PathSpan[(2 * pieces) + 1];
        }

        for (int i = 0; i < pieces; i++)
        {
            ref readonly PathSegment piece = ref path.Piece(i);

            // Up to where the next begins, so that rounding leaves no gap between them.
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

        // From the end backwards: the greatest speed from each span on.
        double fastest = 0;
        for (int i = Count - 1; i >= 0; i--)
        {
            fastest = Math.Max(fastest, Items[i].Speed);
            Items[i].SpeedFromHere = fastest;
        }
    }

    /// <summary>The span that a time falls into; the later one where two meet.</summary>
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
