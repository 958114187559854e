namespace FootballPhysics.Prediction;

/// <summary>Who owns which part of the ball's way, by when each of those who can meet the ball could have been there.</summary>
internal sealed class ShareSearch
{
    /// <summary>Halvings of an interval in which the owner changes: 80 ms become a nanosecond.</summary>
    private const int Halvings = 27;

    /// <summary>Instants nearer to each other than this, s, are one.</summary>
    private const double Shortest = 1e-9;

    private readonly PathSpans _path;
    private readonly WindowList _windows;
    private RunnerMotion[] _motions = [];
    private int[] _starts = [];
    private int _runners;

    public ShareSearch(PathSpans path, WindowList windows)
    {
        _path = path;
        _windows = windows;
    }

    /// <summary>The parts.</summary>
    public PossessionInterval[] Items = new PossessionInterval[64];

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>Finds the parts.</summary>
    public void Run(RunnerMotion[] motions, int[] starts, int runners)
    {
        Count = 0;
        _motions = motions;
        _starts = starts;
        _runners = runners;

        // From edge to edge of windows, between which the same runners can meet the ball, and no farther than a span of path.
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

    /// <summary>The next time after one at which a window begins or ends.</summary>
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

    /// <summary>The owners of an interval over which the same runners can meet the ball.</summary>
    private void Split(in PathSpan span, double a, double b)
    {
        // Windows are looked up in the middle, away from their ends.
        double middle = 0.5 * (a + b);
        int owner = Owner(in span, a, middle, out double lead);
        if (owner < 0)
        {
            return;
        }

        // As often as there are runners: who are level with each other to rounding would change for ever.
        int last = Owner(in span, b, middle, out _);
        for (int changes = 0; owner != last && changes < _runners; changes++)
        {
            // The first change of owner, by bisection; then on from there, until the owner at the end is reached.
            double low = a;
            double high = b;
            var changed = new OwnerChanged(this, in span, middle, owner);
            Roots.Bisect(ref changed, ref low, ref high, Halvings);
            Add(owner, a, high, lead);
            a = high;
            int next = Owner(in span, a, middle, out lead);

            // Level to rounding: it would not get on.
            last = next == owner ? owner : last;
            owner = next;
        }

        Add(owner, a, b, lead);
    }

    /// <summary>Who could be where the ball is at a time first, of those who have a window at another.</summary>
    private int Owner(in PathSpan span, double time, double window, out double lead)
    {
        int owner = -1;
        double first = double.PositiveInfinity;
        double second = double.PositiveInfinity;
        span.PlaceAt(time, out double x, out double z);
        for (int i = 0; i < _runners; i++)
        {
            if (!HasWindow(i, window))
            {
                continue;
            }

            // When he could be where the ball is at that time: at the latest then, for he can meet it.
            ref readonly RunnerMotion runner = ref _motions[i];
            runner.MiddleAt(time, out double cx, out double cz);
            double arrival = Math.Min(time, runner.ArrivalAt(Math.Sqrt(((x - cx) * (x - cx)) + ((z - cz) * (z - cz)))));
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
        // The same owner goes on: one share, with the lead that he had at its start.
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

    /// <summary>The ball belongs to another runner.</summary>
    private readonly struct OwnerChanged : ICondition
    {
        private readonly ShareSearch _search;
        private readonly PathSpan _span;
        private readonly double _window;
        private readonly int _owner;

        public OwnerChanged(ShareSearch search, in PathSpan span, double window, int owner)
        {
            _search = search;
            _span = span;
            _window = window;
            _owner = owner;
        }

        public bool Evaluate(double x, out bool holds)
        {
            holds = _search.Owner(in _span, x, _window, out _) != _owner;
            return false;
        }
    }
}
