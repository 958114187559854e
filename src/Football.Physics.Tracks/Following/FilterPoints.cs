namespace FootballPhysics.Tracks;

/// <summary>The points of the window, in order of time.</summary>
internal sealed class FilterPoints(int room)
{
    /// <summary>The number of points from which it pays to move the others.</summary>
    private const int LeastForgotten = 32;

    private readonly FilterPoint[] _points = new FilterPoint[room];

    public int Count { get; private set; }

    public ref FilterPoint this[int index] => ref _points[index];

    /// <summary>The time of the last point.</summary>
    public double LastTime => _points[Count - 1].Time;

    /// <summary>True if there is no room for another point.</summary>
    public bool IsFull => Count == _points.Length;

    public void Clear() => Count = 0;

    /// <summary>Inserts a point behind those of the same time.</summary>
    /// <returns>The index; −1 if an equal point is there already.</returns>
    public int Insert(in FilterPoint point)
    {
        int at = After(point.Time);
        for (int i = at - 1; i >= 0 && _points[i].Time == point.Time; i--)
        {
            if (_points[i].Kind == point.Kind && _points[i].Value == point.Value && SameCamera(in _points[i], in point))
            {
                return -1;
            }
        }

        Array.Copy(_points, at, _points, at + 1, Count - at);
        _points[at] = point;
        Count++;
        return at;
    }

    /// <summary>Returns the index of the first point after a time.</summary>
    public int After(double time)
    {
        int at = Count;
        while (at > 0 && _points[at - 1].Time > time)
        {
            at--;
        }

        return at;
    }

    /// <summary>Returns the index of the first point at a time or later.</summary>
    public int From(double time)
    {
        int at = After(time);
        while (at > 0 && _points[at - 1].Time >= time)
        {
            at--;
        }

        return at;
    }

    /// <summary>Removes the points before a time, many at once.</summary>
    public void Forget(double time)
    {
        int first = From(time);
        if (first < LeastForgotten && !IsFull)
        {
            return;
        }

        Array.Copy(_points, first, _points, 0, Count - first);
        Count -= first;
    }

    public void Transfer(ref FilterStream stream)
    {
        Count = stream.Whole(Count);
        stream.Plain(_points.AsSpan(0, Count));
    }

    private static bool SameCamera(in FilterPoint a, in FilterPoint b) => a.Kind != FilterPointKind.Pixel ||
        (a.Camera.U.Normal == b.Camera.U.Normal && a.Camera.U.Offset.Equals(b.Camera.U.Offset)
        && a.Camera.V.Normal == b.Camera.V.Normal && a.Camera.V.Offset.Equals(b.Camera.V.Offset)
        && a.Camera.W.Normal == b.Camera.W.Normal && a.Camera.W.Offset.Equals(b.Camera.W.Offset));
}
