namespace FootballPhysics.Batch;

/// <summary>Counts kicks and accumulates their crossing points.</summary>
internal sealed class GoalChanceSum
{
    /// <summary>The smallest number of kicks whose copies are compared.</summary>
    private const int FewestForCopies = 200;

    private readonly int[] _scored = new int[KickDraws.Copies];
    private int _added;
    private int _crosses;
    private int _in;
    private int _covered;
    private int _post;
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
    /// <param name="hitsFrame">True if it hits a post or the bar.</param>
    public void Add(in GoalPlane plane, in PlaneCrossingPoint at, bool goesIn, bool hitsFrame)
    {
        int copy = _added++ % KickDraws.Copies;
        if (!(at.Time >= 0))
        {
            return;
        }

        plane.Place(at.Position, out double x, out double y);
        _crosses++;
        _post += hitsFrame && !goesIn ? 1 : 0;
        _time += at.Time;
        _x += x;
        _y += y;
        _xx += x * x;
        _yy += y * y;
        _xy += x * y;
        if (goesIn)
        {
            _in++;
            bool isCovered = plane.IsCovered(x, y, at.Time);
            _covered += isCovered ? 1 : 0;
            _scored[copy] += isCovered ? 0 : 1;
        }
    }

    /// <summary>Returns the result for a number of kicks.</summary>
    public GoalChanceResult Result(int count)
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
            Post = (double)_post / count,
            StandardError = StandardError(count),
        };
    }

    /// <summary>Estimates the standard error of the share that scores from the differences between the copies of the lattice.</summary>
    private double StandardError(int count)
    {
        double mean = (double)(_in - _covered) / count;
        double sum = 0;
        for (int i = 0; i < _scored.Length; i++)
        {
            // The first copies have one kick more if the number is not a multiple.
            int kicks = (count / _scored.Length) + (i < count % _scored.Length ? 1 : 0);
            double off = kicks > 0 ? ((double)_scored[i] / kicks) - mean : 0;
            sum += off * off;
        }

        // With few kicks per copy, or none that scores, use the error of independent kicks, but at least half a kick.
        double independent = Math.Sqrt(mean * (1.0 - mean) / count);
        double copies = Math.Sqrt(sum / (_scored.Length * (_scored.Length - 1)));
        return Math.Max(0.5 / count, count < FewestForCopies ? independent : copies);
    }
}
