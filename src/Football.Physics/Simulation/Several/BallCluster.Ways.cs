namespace Football.Physics;

/// <content>Where the balls go, and what happens first there.</content>
internal sealed partial class BallCluster
{
    /// <inheritdoc cref="BallMeetings.MayMeet"/>
    public bool MayMeet(int i, double reach, int j, double otherReach) => _meets.MayMeet(_before, i, reach, j, otherReach);

    /// <summary>Looks where a ball goes from where it has got to; and who may be in its way that was not before.</summary>
    private void Try(BallState[] states, int i, double end)
    {
        // A try pushes what has a mass as the step would: afterwards that is put back.
        _pushed.Keep();
        _trials[i].Run(_simulators[i], in states[i], Left(in states[i], end), _stopAt);
        _pushed.PutBack();
        Reach(states, i);
    }

    /// <summary>Struck, a ball may get farther than was expected of it, and meet balls that were no neighbours.</summary>
    private void Reach(BallState[] states, int i)
    {
        _meets.Change(i);
        double reach = (states[i].Position - _before[i].Position).Length + _trials[i].Reach;
        if (!(reach > _reaches[i]))
        {
            return;
        }

        // With room, so that the next time it need not be looked who else there is.
        reach *= MoreReach;
        for (int k = 0; k < _isIn.Length; k++)
        {
            if (!_isIn[k] && MayMeet(i, reach, k, _reaches[k]))
            {
                Join(k);
            }
        }

        _reaches[i] = reach;
        _meets.Forget();
    }

    /// <summary>The first event: two balls meet, or one meets what it pushes, or what ends the step.</summary>
    private Happening FindFirst(double end)
    {
        _meets.Find(_cluster, _clusterCount, _before, _reaches);
        Happening first = Happening.None;
        int pair = 0;
        for (int a = 0; a < _clusterCount; a++)
        {
            int i = _cluster[a];
            for (; pair < _meets.Count && _meets.First(pair) == i; pair++)
            {
                int j = _meets.Second(pair);
                if (!_piles.AreOne(i, j))
                {
                    // Not beyond where one of the two halts, or a pile is at the end of its part.
                    double until = Math.Min(Math.Min(KnownUntil(i), KnownUntil(j)), end);
                    first = Happening.Earlier(new Happening(_meets.TimeOf(pair, until, atEnd: until < end), i, j), in first);
                }
            }

            first = Happening.Earlier(new Happening(_trials[i].HaltsAt, i, Happening.NoOther), in first);
        }

        return first;
    }

    /// <summary>Where a ball goes is known until this time, s: to where it halts, or of a pile to the end of its part.</summary>
    private double KnownUntil(int ball) => _piles.Of(ball)?.Until ?? _trials[ball].HaltsAt;

    /// <summary>How long a ball goes to a time within the step, s: a whole step is that to the last bit.</summary>
    private double Left(in BallState s, double time) => s.Time == _start && time == _end ? _step : Math.Max(0, time - s.Time);

    /// <summary>When two balls touch by their own steps: Newton's method from what their dense paths say.</summary>
    private double Locate(BallState[] states, in Happening met)
    {
        double from = Math.Max(states[met.Ball].Time, states[met.Other].Time);
        double time = Math.Max(from, met.Time);
        for (int k = 0; k < MostNewton; k++)
        {
            BallState a = Look(states, met.Ball, time);
            BallState b = Look(states, met.Other, time);

            // Newton on the gap of the two steps, t − f/f', not before both balls are there.
            double gap = BallContact.Gap(in a, _simulators[met.Ball].Scene.Ball.Radius, in b, _simulators[met.Other].Scene.Ball.Radius, out _, out double rate);
            double next = rate < 0 ? Math.Min(Math.Max(from, _end), Math.Max(from, time - (gap / rate))) : time;
            if (Math.Abs(gap) <= Closed || next == time || Math.Abs(next - met.Time) > Nearby)
            {
                break;
            }

            time = next;
        }

        return time;
    }

    private BallState Look(BallState[] states, int i, double time)
    {
        BallState state = states[i];
        if (_piles.Has(i))
        {
            state.Position = _trials[i].At(time, out Vector3d velocity);
            state.Velocity = velocity;
            return state;
        }

        _look.Clear();
        _look.Pushes = false;
        if (time > state.Time)
        {
            _simulators[i].Advance(ref state, Left(in state, time), _look);
        }

        return state;
    }
}
