namespace FootballPhysics.Batch;

/// <summary>Counts kicks and accumulates their crossing points.</summary>
internal struct GoalChanceSum
{
    private int _crosses;
    private int _in;
    private int _covered;
    private double _time;
    private double _x;
    private double _y;
    private double _xx;
    private double _yy;
    private double _xy;

    /// <summary>Adds a kick.</summary>
    /// <param name="plane">The plane of the goal.</param>
    /// <param name="at">The crossing point.</param>
    /// <param name="goesIn">True if it goes in, directly or off the frame.</param>
    public void Add(in GoalPlane plane, in PlaneCrossingPoint at, bool goesIn)
    {
        if (!(at.Time >= 0))
        {
            return;
        }

        plane.Place(at.Position, out double x, out double y);
        _crosses++;
        _time += at.Time;
        _x += x;
        _y += y;
        _xx += x * x;
        _yy += y * y;
        _xy += x * y;
        if (goesIn)
        {
            _in++;
            _covered += plane.IsCovered(x, y, at.Time) ? 1 : 0;
        }
    }

    /// <summary>Returns the result for a number of kicks.</summary>
    public readonly GoalChanceResult Result(int count)
    {
        double per = _crosses > 0 ? 1.0 / _crosses : 0;
        double x = per * _x;
        double y = per * _y;
        double a = Math.Max(0, (per * _xx) - (x * x));
        double b = Math.Max(0, (per * _yy) - (y * y));
        double product = Math.Sqrt(a * b);
        return new GoalChanceResult
        {
            Method = GoalChanceMethod.Flights,
            Kicks = count,
            Crosses = (double)_crosses / count,
            Aside = x,
            Height = y,
            Time = per * _time,
            AsideDeviation = Math.Sqrt(a),
            HeightDeviation = Math.Sqrt(b),
            Correlation = product > 0 ? Math.Min(1, Math.Max(-1, ((per * _xy) - (x * y)) / product)) : 0,
            OnTarget = (double)_in / count,
            Covered = (double)_covered / count,
        };
    }
}
