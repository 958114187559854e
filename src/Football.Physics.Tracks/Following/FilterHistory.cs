namespace FootballPhysics.Tracks;

/// <summary>The estimate of a hypothesis just after a point, and the derivatives of that point.</summary>
internal sealed class FilterMoment
{
    public double Time;
    public double Deviation;
    public double Evidence;

    /// <summary>True if the ball rolls or rests, on all rays.</summary>
    public bool Rolls;

    /// <summary>True if the derivatives are those of one smooth motion, without an impact between the rays.</summary>
    public bool IsSmooth;

    /// <summary>The number of coordinates that were used; 0 for an outlier.</summary>
    public int Coordinates;

    /// <summary>The estimated parameters.</summary>
    public readonly double[] Values = new double[FilterHypothesis.Most];

    /// <summary>True if <see cref="Motion"/> is computed; see <see cref="FilterHypothesis.MotionAt"/>.</summary>
    public bool HasMotion;

    /// <summary>Position, velocity and spin.</summary>
    public readonly double[] Motion = new double[FilterHypothesis.Motion];

    /// <summary>The derivatives of <see cref="Motion"/> with respect to the parameters.</summary>
    public readonly double[] Jacobian = new double[FilterHypothesis.Motion * FilterHypothesis.Most];

    /// <summary>The covariance of the parameters.</summary>
    public readonly double[] Spread = new double[FilterHypothesis.Most * FilterHypothesis.Most];

    /// <summary>The residuals at the base of the rays, and their derivatives with respect to the parameters and to the position.</summary>
    public readonly double[] Residual = new double[3];
    public readonly double[] Rows = new double[3 * FilterHypothesis.Most];
    public readonly double[] ByPosition = new double[9];

    /// <summary>Takes over a point and the estimate after it.</summary>
    public void Take(in FilterPoint point, bool isOutlier, FilterHypothesis estimate)
    {
        Time = point.Time;
        Deviation = point.Deviation;
        Coordinates = isOutlier ? 0 : point.Rows;
        Evidence = estimate.Evidence;
        Array.Copy(estimate.Values, Values, Values.Length);
        Array.Copy(estimate.Spread, Spread, Spread.Length);
    }

    public void Transfer(ref FilterStream stream)
    {
        stream.Number(ref Time);
        stream.Number(ref Deviation);
        stream.Number(ref Evidence);
        stream.Flag(ref Rolls);
        stream.Flag(ref IsSmooth);
        stream.Whole(ref Coordinates);
        stream.Numbers(Values);
        stream.Flag(ref HasMotion);
        stream.Numbers(Motion);
        stream.Numbers(Jacobian);
        stream.Numbers(Spread);
        stream.Numbers(Residual);
        stream.Numbers(Rows);
        stream.Numbers(ByPosition);
    }
}

/// <summary>The last moments of a hypothesis.</summary>
internal sealed class FilterHistory
{
    /// <summary>The number of moments that are kept.</summary>
    public const int Room = 24;

    private readonly FilterMoment[] _moments = new FilterMoment[Room];
    private int _next;

    public FilterHistory()
    {
        for (int i = 0; i < Room; i++)
        {
            _moments[i] = new FilterMoment();
        }
    }

    public int Count { get; private set; }

    /// <summary>Returns a moment; 0 is the oldest.</summary>
    public FilterMoment this[int index] => _moments[(_next - Count + index + (2 * Room)) % Room];

    public FilterMoment Last => this[Count - 1];

    public void Clear()
    {
        Count = 0;
        _next = 0;
    }

    public void Transfer(ref FilterStream stream)
    {
        int count = stream.Whole(Count);
        if (stream.Reads)
        {
            (Count, _next) = (count, count % Room);
        }

        for (int i = 0; i < count; i++)
        {
            this[i].Transfer(ref stream);
        }
    }

    public ref FilterMoment Push()
    {
        ref FilterMoment moment = ref _moments[_next];
        _next = (_next + 1) % Room;
        Count = Math.Min(Room, Count + 1);
        return ref moment;
    }
}
