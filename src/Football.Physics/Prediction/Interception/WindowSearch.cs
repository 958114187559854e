using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>Finds all windows in which one player can reach the ball.</summary>
/// <remarks>
/// Far from the player, and close to him, speed bounds prove that nothing changes for some time, and the search skips that time. In between, it
/// halves a segment until each condition is decided: over a time h, a function with |f̈| ≤ M lies within M h²/8 of the chord between its ends, and is
/// monotone if |ḟ| &gt; M h at its start. So no window or gap of a microsecond or more is lost.
/// </remarks>
internal struct WindowSearch(PathSpans path, in RunnerMotion runner, int index, bool firstOnly, WindowList found)
{
    /// <summary>The shortest interval, in s; an interval of this length is decided from its ends.</summary>
    private const double Shortest = 1e-7;

    /// <summary>Windows closer together than this, in s, are merged.</summary>
    private const double Adjoining = 1e-9;

    private readonly PathSpans _path = path;
    private readonly RunnerMotion _runner = runner;
    private readonly int _index = index;
    private readonly bool _firstOnly = firstOnly;
    private readonly WindowList _found = found;
    private double _from;
    private bool _inside;
    private bool _done;

    /// <summary>Adds the windows between two times.</summary>
    /// <param name="from">The start of the search, in s.</param>
    /// <param name="until">The end of the search, in s.</param>
    public void Run(double from, double until) => Run(from, until, double.PositiveInfinity);

    /// <summary>Adds the windows between two times that begin by a third time.</summary>
    /// <remarks>The third time does not affect the subdivision, so the results are bit-identical with any value.</remarks>
    /// <param name="from">The start of the search, in s.</param>
    /// <param name="until">The end of the search, in s.</param>
    /// <param name="latest">The latest start of a window, in s; later ones may be skipped.</param>
    public void Run(double from, double until, double latest)
    {
        double t = from;
        double nearUntil = double.NegativeInfinity;
        for (int i = _path.Count > 0 ? _path.Find(from) : 0; i < _path.Count && t < until && t <= latest && !_done; i++)
        {
            // A part may end far beyond its segment; skip the segments in between.
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

    /// <summary>Handles the next part of a segment: up to its end, or to the player's reaction, where his velocity jumps.</summary>
    /// <returns>The time at which to continue.</returns>
    private double Part(in PathSpan span, double t, double end, ref double nearUntil)
    {
        bool reacts = t >= _runner.Start;
        end = !reacts && end > _runner.Start ? _runner.Start : end;

        // The ball is outside his height range throughout.
        if (span.Highest < _runner.Lowest || span.Lowest > _runner.Highest)
        {
            Leave(t);
            return end;
        }

        // The ball is within his height range throughout, so only the distance matters.
        bool level = span.Lowest >= _runner.Lowest && span.Highest <= _runner.Highest;
        bool near = end <= nearUntil;
        if (!near)
        {
            Vector3d at = span.PositionAt(t);
            _runner.MiddleAt(t, out double cx, out double cz);

            // Compute the distance between player and ball, and by how much it can change over this part.
            double distance = Math.Sqrt(((at.X - cx) * (at.X - cx)) + ((at.Z - cz) * (at.Z - cz)));
            double drift = (span.Speed + _runner.CarriedAt(t)) * (end - t);
            double gap = distance - _runner.RadiusAt(t);

            // They are too far apart throughout this part. Skip to the earliest possible meeting, at the maximum speeds of both.
            if (distance - drift > _runner.RadiusAt(end))
            {
                Leave(t);
                return Math.Max(end, t + (gap / (span.SpeedFromHere + _runner.Fastest)));
            }

            // The ball stays inside his circle: remember the minimum time for which this is true.
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

    /// <summary>Halves a part of a segment until every condition is decided; visits the halves in order.</summary>
    private void Halve(in PathSpan span, double start, double end, bool reacts)
    {
        int level = 0;
        long number = 0;
        double length = end - start;
        MeetingPoint.At(in span, in _runner, start, reacts, out MeetingPoint low);
        while (level >= 0 && !_done)
        {
            // This is interval `number` of the 2^level intervals of equal size; the last one ends exactly at the end of the part.
            double h = length / (1L << level);
            double a = start + (number * h);
            double b = number + 1 == 1L << level ? end : start + ((number + 1) * h);
            MeetingPoint.At(in span, in _runner, b, reacts, out MeetingPoint high);
            _found.Intervals++;
            if (!Decide(in span, a, b, reacts, in low, in high))
            {
                level++;
                number *= 2;
                continue;
            }

            // For the next interval, go up to the nearest ancestor that is a first half, and take its second half.
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

    /// <summary>Decides an interval if possible: the ball is inside, outside, or makes a single crossing, which is solved for.</summary>
    private bool Decide(in PathSpan span, double a, double b, bool reacts, in MeetingPoint low, in MeetingPoint high)
    {
        double h = b - a;
        int open = -1;
        bool hopeless = false;
        for (var what = MeetingCondition.Near; what <= MeetingCondition.NotTooHigh; what++)
        {
            // The values at both ends and a bound on the second derivative show whether a condition always holds, never holds, or changes.
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

            // A single condition that changes once can be solved. Otherwise, halve the interval.
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

        // The interval is negligibly short: decide from its ends.
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

    /// <summary>Returns a bound of |q̈| over an interval, where q = R² − |w|²: 2 (Ṙ² + R R̈ + |ẇ|² + |w| |ẅ|).</summary>
    private readonly double NearBend(in PathSpan span, double a, double b, in MeetingPoint low)
    {
        // Use the maximum of each factor: growth and radius at the end, and the distance after the farthest motion of both.
        double growth = _runner.GrowthAt(b);
        double speed = span.Speed + _runner.CarriedAt(a);
        double farthest = low.Distance + (speed * (b - a));
        return 2.0 * ((growth * growth) + (_runner.RadiusAt(b) * _runner.GrowthRateFrom(a)) + (speed * speed) + (farthest * span.Acceleration));
    }

    /// <summary>Solves for the time at which the single undecided condition changes.</summary>
    private void Cross(in PathSpan span, double a, double b, bool reacts, MeetingCondition what, double start)
    {
        // Start Newton's method at the end where the condition fails, and choose the sign so that the function falls.
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
            // A window must not have zero length: accept the first window only after time has advanced.
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
