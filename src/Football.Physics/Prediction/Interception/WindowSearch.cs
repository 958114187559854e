namespace FootballPhysics.Prediction;

/// <summary>
/// Finds all times at which one runner can meet the ball. Far from him and close to him a path goes on unasked for as long as the bounds of both speeds
/// prove that nothing changes. In between, a span is halved until each of the conditions is decided: over a time h a function with |f̈| ≤ M lies within
/// M h²/8 of the chord between its ends, and falls or rises throughout where |ḟ| &gt; M h at its start. So no window and no gap of a microsecond or more is lost.
/// </summary>
internal struct WindowSearch
{
    /// <summary>Shortest interval, s: one that is undecided at this length is decided by its ends.</summary>
    private const double Shortest = 1e-7;

    /// <summary>Windows closer than this, s, are one.</summary>
    private const double Adjoining = 1e-9;

    private readonly PathSpans _path;
    private readonly RunnerMotion _runner;
    private readonly int _index;
    private readonly bool _firstOnly;
    private readonly WindowList _found;
    private double _from;
    private bool _inside;
    private bool _done;

    public WindowSearch(PathSpans path, in RunnerMotion runner, int index, bool firstOnly, WindowList found)
    {
        _path = path;
        _runner = runner;
        _index = index;
        _firstOnly = firstOnly;
        _found = found;
        _from = 0;
        _inside = false;
        _done = false;
    }

    /// <summary>Adds the windows between two times.</summary>
    /// <param name="from">Where to begin, s.</param>
    /// <param name="until">Where to end, s.</param>
    public void Run(double from, double until) => Run(from, until, double.PositiveInfinity);

    /// <summary>Adds the windows between two times as far as any begins by a third: how the search divides the way, and so each bit of an answer, does not depend on that.</summary>
    /// <param name="from">Where to begin, s.</param>
    /// <param name="until">Where to end, s.</param>
    /// <param name="latest">What begins after this does not matter, s.</param>
    public void Run(double from, double until, double latest)
    {
        double t = from;
        double nearUntil = double.NegativeInfinity;
        for (int i = _path.Count > 0 ? _path.Find(from) : 0; i < _path.Count && t < until && t <= latest && !_done; i++)
        {
            // A part may lead far beyond its span: then spans are passed over.
            ref readonly PathSpan span = ref _path.Items[i];
            while (t < span.End && t < until && t <= latest && !_done)
            {
                t = Part(in span, t, Math.Min(span.End, until), ref nearUntil);
            }
        }

        if (!_done)
        {
            Leave(Math.Min(t, until));
        }
    }

    /// <summary>The next part of a span: up to its end, or to the runner's reaction, where his motion has a kink.</summary>
    /// <returns>When to go on.</returns>
    private double Part(in PathSpan span, double t, double end, ref double nearUntil)
    {
        bool reacts = t >= _runner.Start;
        end = !reacts && end > _runner.Start ? _runner.Start : end;

        // Out of his height throughout.
        if (span.Highest < _runner.Lowest || span.Lowest > _runner.Highest)
        {
            Leave(t);
            return end;
        }

        // Within his height throughout: only the distance is left to decide.
        bool level = span.Lowest >= _runner.Lowest && span.Highest <= _runner.Highest;
        bool near = end <= nearUntil;
        if (!near)
        {
            span.PlaceAt(t, out double x, out double z);
            _runner.MiddleAt(t, out double cx, out double cz);

            // How far apart they are, and by how much the end of the part can change that.
            double distance = Math.Sqrt(((x - cx) * (x - cx)) + ((z - cz) * (z - cz)));
            double drift = (span.Speed + _runner.CarriedAt(t)) * (end - t);
            double gap = distance - _runner.RadiusAt(t);

            // Too far even so. No sooner can they meet than at both their greatest speeds: up to then nothing is asked.
            if (distance - drift > _runner.RadiusAt(end))
            {
                Leave(t);
                return Math.Max(end, t + (gap / (span.SpeedFromHere + _runner.Fastest)));
            }

            // Well within his circle; how long at least is remembered for the parts to come.
            near = gap <= -drift;
            nearUntil = near ? t - (gap / (span.SpeedFromHere + _runner.CarriedAt(t))) : nearUntil;
        }

        if (near && level)
        {
            Enter(t, in span);
        }
        else
        {
            Halve(in span, t, end, reacts);
        }

        return end;
    }

    /// <summary>Halves a part of a span until all is decided. The halves are visited in order by their number at their level.</summary>
    private void Halve(in PathSpan span, double start, double end, bool reacts)
    {
        int level = 0;
        long number = 0;
        double length = end - start;
        MeetingPoint.At(in span, in _runner, start, reacts, out MeetingPoint low);
        while (level >= 0 && !_done)
        {
            // Interval number of the 2^level of this size; the last ends where the part does, whatever rounding says.
            double h = length / (1L << level);
            double a = start + (number * h);
            double b = number + 1 == 1L << level ? end : start + ((number + 1) * h);
            MeetingPoint.At(in span, in _runner, b, reacts, out MeetingPoint high);
            if (!Decide(in span, a, b, reacts, in low, in high))
            {
                level++;
                number *= 2;
                continue;
            }

            // The next half: that of the nearest ancestor which is a first half.
            low = high;
            while (level > 0 && (number & 1) != 0)
            {
                level--;
                number >>= 1;
            }

            number++;
            level = level == 0 ? -1 : level;
        }
    }

    /// <summary>Decides an interval, if that can be done: within, without, or one change of which the instant is found.</summary>
    private bool Decide(in PathSpan span, double a, double b, bool reacts, in MeetingPoint low, in MeetingPoint high)
    {
        double h = b - a;
        int open = -1;
        bool hopeless = false;
        for (var what = MeetingCondition.Near; what <= MeetingCondition.NotTooHigh; what++)
        {
            // Each condition by its values at the ends and a bound of its second derivative: holds throughout, never, or changes.
            double start = low.Value(what);
            double end = high.Value(what);
            double bend = what == MeetingCondition.Near ? NearBend(in span, a, b, in low) : span.VerticalAcceleration;
            double sag = 0.125 * bend * h * h;
            bool monotone = Math.Abs(low.Slope(what)) > bend * h;
            if (Math.Min(start, end) >= (monotone ? 0 : sag))
            {
                continue;
            }

            if (Math.Max(start, end) < (monotone ? 0 : -sag))
            {
                Leave(a);
                return true;
            }

            // One condition that changes once can be solved for; more, or one that may change twice, is halved.
            hopeless |= open >= 0 || !monotone;
            open = (int)what;
        }

        if (open < 0)
        {
            Enter(a, in span);
            return true;
        }

        if (!hopeless)
        {
            Cross(in span, a, b, reacts, (MeetingCondition)open, low.Value((MeetingCondition)open));
            return true;
        }

        if (h > Shortest)
        {
            return false;
        }

        // So short that it does not matter: decided by the ends.
        bool holds = true;
        for (var what = MeetingCondition.Near; what <= MeetingCondition.NotTooHigh; what++)
        {
            holds &= low.Value(what) >= 0 && high.Value(what) >= 0;
        }

        if (holds)
        {
            Enter(a, in span);
        }
        else
        {
            Leave(a);
        }

        return true;
    }

    /// <summary>A bound of |q̈| over an interval, q = R² − |w|²: 2 (Ṙ² + R R̈ + |ẇ|² + |w| |ẅ|).</summary>
    private readonly double NearBend(in PathSpan span, double a, double b, in MeetingPoint low)
    {
        // Each factor by its largest over the interval: growth and radius at its end, the distance by how far both can go.
        double growth = _runner.GrowthAt(b);
        double speed = span.Speed + _runner.CarriedAt(a);
        double farthest = low.Distance + (speed * (b - a));
        return 2.0 * ((growth * growth) + (_runner.RadiusAt(b) * _runner.GrowthRateFrom(a)) + (speed * speed) + (farthest * span.Acceleration));
    }

    /// <summary>The instant at which the one condition that changes does so.</summary>
    private void Cross(in PathSpan span, double a, double b, bool reacts, MeetingCondition what, double start)
    {
        // Newton from the end at which the condition does not hold, with the sign so that it falls.
        bool falls = start >= 0;
        var margin = new MeetingMargin(in span, in _runner, what, reacts, falls);
        double at = Roots.Newton(ref margin, a, b, falls ? b : a);
        if (falls)
        {
            Enter(a, in span);
            Leave(at);
        }
        else
        {
            Leave(a);
            Enter(at, in span);
        }
    }

    private void Enter(double time, in PathSpan span)
    {
        if (_inside)
        {
            // A window without length is none, so one is found when it goes on.
            _done = _firstOnly && time > _from;
            return;
        }

        _inside = true;
        _from = time;
        if (!_found.Continues(_index, time, Adjoining))
        {
            _found.Begin(_index, time, span.PositionAt(time), span.VelocityAt(time));
        }
    }

    private void Leave(double time)
    {
        if (_inside)
        {
            _inside = false;
            _found.End(_from, time);
        }
    }
}
