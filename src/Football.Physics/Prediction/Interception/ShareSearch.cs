using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>Divides the ball's path among the players who can reach the ball; each point belongs to the player who could be there first.</summary>
internal sealed class ShareSearch(PathSpans path, WindowList windows)
{
    /// <summary>The number of bisections of an interval with a change of owner; they reduce 80 ms to a nanosecond.</summary>
    private const int Halvings = 27;

    /// <summary>Times closer together than this, in s, count as equal.</summary>
    private const double Shortest = 1e-9;

    private readonly PathSpans _path = path;
    private readonly WindowList _windows = windows;
    private RunnerMotion[] _motions = [];
    private int[] _starts = [];
    private int _runners;

    /// <summary>The intervals.</summary>
    public PossessionInterval[] Items = new PossessionInterval[64];

    /// <summary>The number of intervals.</summary>
    public int Count { get; private set; }

    /// <summary>Finds the intervals.</summary>
    public void Run(RunnerMotion[] motions, int[] starts, int runners)
    {
        Count = 0;
        _motions = motions;
        _starts = starts;
        _runners = runners;

        // Step from one window edge or segment end to the next: in between, the same players can reach the ball.
        double t = NextEdge(double.NegativeInfinity);
        while (t < _path.End)
        {
            double next = Math.Min(NextEdge(t), _path.End);
            ref readonly PathSpan span = ref _path.Items[_path.Find(t)];
            next = span.End > t && span.End < next ? span.End : next;
            Split(in span, t, next);
            t = next;
        }
    }

    /// <summary>Returns the next time at which a window begins or ends.</summary>
    private double NextEdge(double after)
    {
        double next = double.PositiveInfinity;
        for (int i = 0; i < _windows.Count; i++)
        {
            double from = _windows.Items[i].From;
            double to = _windows.Items[i].To;
            next = from > after + Shortest && from < next ? from : next;
            next = to > after + Shortest && to < next ? to : next;
        }

        return next;
    }

    /// <summary>Finds the owners within an interval in which the same players can reach the ball.</summary>
    private void Split(in PathSpan span, double a, double b)
    {
        // Look up the windows at the midpoint, away from their ends.
        double middle = 0.5 * (a + b);
        int owner = Owner(in span, a, middle, out double lead);
        if (owner < 0)
        {
            return;
        }

        // Limit the number of changes to the number of players, because two players who are equal within rounding could alternate for ever.
        int last = Owner(in span, b, middle, out _);
        for (int changes = 0; owner != last && changes < _runners; changes++)
        {
            // Bisect for the first change of owner, then continue from there until the owner at the end is reached.
            double low = a;
            double high = b;
            var changed = new OwnerChanged(this, span, middle, owner);
            Roots.Bisect(ref changed, ref low, ref high, Halvings);
            Add(owner, a, high, lead);
            a = high;
            int next = Owner(in span, a, middle, out lead);

            // The players are equal within rounding: stop, because the search would not advance.
            last = next == owner ? owner : last;
            owner = next;
        }

        Add(owner, a, b, lead);
    }

    /// <summary>Returns the first player who could be at the ball's position at a time, among those with a window at another time.</summary>
    private int Owner(in PathSpan span, double time, double window, out double lead)
    {
        int owner = -1;
        double first = double.PositiveInfinity;
        double second = double.PositiveInfinity;
        Vector3d at = span.PositionAt(time);
        for (int i = 0; i < _runners; i++)
        {
            if (!HasWindow(i, window))
            {
                continue;
            }

            // Compute his earliest arrival time at this point. It is never later than the ball's arrival, because he can reach the ball.
            ref readonly RunnerMotion runner = ref _motions[i];
            runner.MiddleAt(time, out double cx, out double cz);
            double arrival = Math.Min(time, runner.ArrivalAt(Math.Sqrt(((at.X - cx) * (at.X - cx)) + ((at.Z - cz) * (at.Z - cz)))));
            if (arrival < first)
            {
                second = first;
                first = arrival;
                owner = i;
            }
            else
            {
                second = Math.Min(second, arrival);
            }
        }

        lead = second - first;
        return owner;
    }

    private bool HasWindow(int runner, double time)
    {
        for (int i = _starts[runner]; i < _starts[runner + 1]; i++)
        {
            if (_windows.Items[i].From <= time && time < _windows.Items[i].To)
            {
                return true;
            }
        }

        return false;
    }

    private void Add(int runner, double from, double to, double lead)
    {
        // The same owner continues: extend his interval, and keep the lead at its start.
        if (Count > 0 && Items[Count - 1].Player == runner && from - Items[Count - 1].To <= Shortest)
        {
            PossessionInterval before = Items[Count - 1];
            Items[Count - 1] = new PossessionInterval(runner, before.From, to, before.TimeMargin);
            return;
        }

        if (Count == Items.Length)
        {
            Array.Resize(ref Items, 2 * Count);
        }

        Items[Count++] = new PossessionInterval(runner, from, to, lead);
    }

    /// <summary>True if the ball belongs to another player.</summary>
    private readonly struct OwnerChanged(ShareSearch search, PathSpan span, double window, int owner) : ICondition
    {
        public bool Evaluate(double x, out bool holds)
        {
            holds = search.Owner(in span, x, window, out _) != owner;
            return false;
        }
    }
}
