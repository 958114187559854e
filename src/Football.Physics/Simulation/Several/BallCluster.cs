namespace FootballPhysics;

/// <summary>Balls that may meet in a step, played again from before it: always the first that happens among them, to the last bit by the balls' own steps.</summary>
internal sealed partial class BallCluster
{
    /// <summary>More impacts than this, and one for each pair, at one instant: the rest of it is without restitution.</summary>
    private const int MostAtOnce = 8;

    /// <summary>So many impacts with others a ball may have in a step one by one; after them it is one of a pile.</summary>
    private const int MostMeetings = 16;

    /// <summary>So often balls push something, or meet another, in a step, for each of them; the rest of it is played as if there were no other ball.</summary>
    private const int MostImpacts = 256;

    /// <summary>A ball that gets farther than was expected may get by so much farther still.</summary>
    private const double MoreReach = 1.25;

    /// <summary>Two balls touch where the gap is less than this, m; and of two times closer than this, s, one is the other.</summary>
    private const double Closed = 1e-13;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly BallState[] _before;
    private readonly double[] _reaches;
    private readonly StepLog[] _logs;
    private readonly BallTrial[] _trials;
    private readonly int[] _cluster;
    private readonly bool[] _isIn;
    private readonly bool[] _again;
    private readonly PushShares _shares;
    private readonly BallTouch _touch;
    private readonly PushedMotions _pushed;
    private readonly BallRests _rests;
    private readonly BallMeetings _meets;
    private readonly int[] _meetings;
    private readonly BallPiles _piles;
    private int _clusterCount;
    private int _begun;
    private StepLog[] _current;
    private StepSpan _span;
    private StopAt _stopAt;
    private bool _clears;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">What two balls are to each other.</param>
    /// <param name="friction">The friction of that, where two balls press each other.</param>
    /// <param name="before">The balls before the step.</param>
    /// <param name="reaches">Not less than how far each gets in it, m.</param>
    /// <param name="logs">Where events and counts of each go.</param>
    public BallCluster(Simulator[] simulators, in ContactMaterial contact, double friction, BallState[] before, double[] reaches, StepLog[] logs)
    {
        int count = simulators.Length;
        _simulators = simulators;
        _contact = contact;
        _piles = new BallPiles(simulators, in contact, friction);
        _before = before;
        _reaches = reaches;
        _logs = logs;
        _current = logs;
        _meetings = new int[count];
        _trials = new BallTrial[count];
        for (int i = 0; i < count; i++)
        {
            _trials[i] = new BallTrial();
        }

        double[] radii = [.. simulators.Select(simulator => simulator.Scene.Ball.Radius)];
        _rests = new BallRests(simulators, radii);
        _meets = new BallMeetings(_trials, radii);

        _cluster = new int[count];
        _isIn = new bool[count];
        _again = new bool[count];
        _pushed = new PushedMotions(simulators[0].World);
        _shares = new PushShares(_pushed, simulators, before);
        _touch = new BallTouch(simulators, _trials, _piles, _pushed);
    }

    /// <summary>How many balls are in it.</summary>
    public int Count => _clusterCount;

    /// <summary>A ball of it.</summary>
    public int this[int index] => _cluster[index];

    /// <summary>True when a ball is in it.</summary>
    public bool Has(int ball) => _isIn[ball];

    /// <summary>True when a ball of it has pushed something.</summary>
    public bool HasPushed(int ball) => _current[ball].Pushed;

    /// <summary>Takes all balls out.</summary>
    public void Clear()
    {
        for (int k = 0; k < _clusterCount; k++)
        {
            _isIn[_cluster[k]] = false;
        }

        _clusterCount = 0;
    }

    /// <summary>Takes a ball in.</summary>
    public void Join(int ball)
    {
        if (!_isIn[ball])
        {
            _isIn[ball] = true;
            _meets.Forget();
            _cluster[_clusterCount++] = ball;
        }
    }

    /// <summary>Ends a step that failed.</summary>
    public void Abandon() => Array.ForEach(_current, log => log.Abandon());

    /// <summary>Which balls lie on each other before the step.</summary>
    public BallRests Rests => _rests;

    /// <summary>Plays the balls of a cluster again from before the step: always the first event, then the balls whose paths it changes.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="stopAt">The event that ends it.</param>
    /// <param name="watched">Logs whose observers see the paths; null for the cluster's own logs.</param>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <returns>Whether an event ended the step.</returns>
    public bool Play(BallState[] states, double dt, StopAt stopAt, StepLog[]? watched, MotionsBefore motions)
    {
        // First find the balls that share a pushed object: an observer must see only one pass.
        bool mayPush = _simulators[0].World.MayGiveWay;
        bool ended = false;
        for (int k = 0; watched is null || mayPush; k++)
        {
            ended = PlayOnce(states, dt, stopAt, null, motions);
            if (!mayPush || k > MostPlays || !FindShares(motions, dt))
            {
                break;
            }

            if (k == MostPlays)
            {
                _shares.Fill();
            }
        }

        return watched is null ? ended : PlayOnce(states, dt, stopAt, watched, motions);
    }

    private bool PlayOnce(BallState[] states, double dt, StopAt stopAt, StepLog[]? watched, MotionsBefore motions)
    {
        _current = watched ?? _logs;
        _clears = watched is null;
        _span = new StepSpan(_before[0].Time, dt);
        _stopAt = stopAt;
        double end = _span.End;

        // Sort by index: of simultaneous events, the first one found counts.
        Array.Sort(_cluster, 0, _clusterCount);
        _begun = 0;
        _piles.Clear();
        _meets.Forget();

        // Undo the pushes of the first trial as well.
        motions.Read();
        motions.PutBack();
        int impacts = 0;
        int atOnce = 0;
        double last = double.NegativeInfinity;
        bool ended = false;
        while (!ended)
        {
            // A ball that joins later starts from its state at the start of the step.
            BeginNew(states);
            if (PlanPiles(states, out double planned))
            {
                last = planned;
                ended = true;
                break;
            }

            // Up to the first event, every ball moves as if alone, and every pile moves to the end of its part.
            Happening first = FindFirst(end);
            BallPile? pile = _piles.First(end);
            bool spent = impacts >= MostImpacts * _clusterCount;
            if (pile is not null && (spent || !(first.Time <= pile.Until)))
            {
                pile.MoveTo(states, pile.Until, _current);
                continue;
            }

            if (spent || !(first.Time <= end))
            {
                break;
            }

            atOnce = first.Time - last <= Closed ? atOnce + 1 : 0;
            last = first.Time;
            impacts++;
            if (first.IsMeeting)
            {
                // After too many impacts at one instant, resolve the rest of the instant without restitution, as in a pile.
                bool presses = atOnce > MostAtOnce + (_clusterCount * (_clusterCount - 1) / 2);
                ended = Collide(states, in first, presses);
            }
            else
            {
                ended = Push(states, in first, end);
            }
        }

        // No further event: move all balls to the end of the step, or to the event that ended it.
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (!_piles.Has(i) && (!ended || states[i].Time < last))
            {
                Commit(states, i, ended ? last : end);
            }
        }

        for (int k = 0; k < _piles.Count; k++)
        {
            _piles[k].MoveTo(states, ended ? last : end, _current);
            _piles[k].End(states, _current);
        }

        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            _current[i].End(in states[i]);
        }

        return ended;
    }

    /// <summary>Puts balls that are new in the cluster back to where they were before the step, those that lie on each other into piles, and looks where the others go.</summary>
    private void BeginNew(BallState[] states)
    {
        // The path of a ball may add further balls to the cluster.
        for (int k = _begun; _begun < _clusterCount || k < _begun; k++)
        {
            for (; _begun < _clusterCount; _begun++)
            {
                Begin(states, _cluster[_begun]);
            }

            int i = _cluster[k];
            if (!_piles.Has(i) && _rests.IsInPile(i))
            {
                BallPile pile = _piles.Begin(_span.Start, _span.Length);
                TakeAllOf(_rests.RootOf(i), states, pile, _span.Start);
            }
            else if (!_piles.Has(i) && _trials[i].IsWhole && _stopAt == StopAt.Time)
            {
                Reach(states, i);
            }
            else if (!_piles.Has(i))
            {
                Try(states, i, _span.End);
            }
        }
    }

    /// <summary>Puts a ball back to where it was before the step.</summary>
    private void Begin(BallState[] states, int i)
    {
        states[i] = _before[i];
        _current[i].Begin(i, _clears, _simulators[i].Zones, in _before[i]);
        _meetings[i] = 0;
        _piles.Leave(i);
    }

    /// <summary>Moves a ball on to a time within its way, as its step would have gone; of a pile all balls.</summary>
    private void Commit(BallState[] states, int i, double time)
    {
        if (_piles.Of(i) is { } pile)
        {
            pile.MoveTo(states, time, _current);
            pile.Forget();
            return;
        }

        ref BallState s = ref states[i];
        double left = _span.Left(in s, time);
        StepLog own = _current[i];

        // Reuse a computed path if one exists: the trial to the end of the step, or the path to the contact with another ball.
        if (_touch.TryTake(i, ref s, time, own) || (time == _span.End && _trials[i].TryTake(ref s, time, own)))
        {
            return;
        }

        if (left > 0)
        {
            _simulators[i].Advance(ref s, left, own);
        }

        // A path with a full buffer ends a step early, but the ball must go on.
        while (own.Halted && s.Time < time)
        {
            own.Halted = false;
            _simulators[i].Advance(ref s, _span.Left(in s, time), own);
        }

        s.Time = time;
    }

    /// <summary>Two balls meet: both go there, to the last bit by their own steps, and both get the impulse; or they press each other from then on.</summary>
    /// <returns>Whether that ends the step.</returns>
    private bool Collide(BallState[] states, in Happening met, bool presses)
    {
        int i = met.Ball;
        int j = met.Other;
        double time = _touch.Locate(states, in met, in _span, _current);
        Commit(states, i, time);
        Commit(states, j, time);
        _touch.Forget();
        BallProperties ball = _simulators[i].Scene.Ball;
        BallProperties other = _simulators[j].Scene.Ball;
        BallContact.Gap(in states[i], ball.Radius, in states[j], other.Radius, out Vector3d n, out double rate);

        // Slow contacts, and balls that hit each other repeatedly, are in sustained contact: solve them as a pile without restitution.
        if (presses || rate > -BallContact.Gentle || HasHitEnough(i) || HasHitEnough(j))
        {
            _current[i].UnreportedImpacts++;
            Press(states, i, j, time);
            return false;
        }

        _meetings[i]++;
        _meetings[j]++;
        BallContact.Impact(ball, other, in _contact, in n, in states[i], in states[j], out Motion first, out Motion second);
        _current[i].Report(new BallEvent(j, in n, time, in states[i], in first.Velocity, in first.Spin));
        _current[j].Report(new BallEvent(i, -n, time, in states[j], in second.Velocity, in second.Spin));
        GoOn(states, i, in first, in n);
        GoOn(states, j, in second, -n);
        return _stopAt == StopAt.Impact;
    }

    /// <summary>True when a ball has had all impacts that it may have in a step one by one, by itself or with its pile.</summary>
    private bool HasHitEnough(int i) => _meetings[i] >= MostMeetings || _piles.Of(i) is { IsSpent: true };

    /// <summary>What becomes of a ball that was hit: on the ground it keeps its carrier, unless the impulse lifts it; what leans on others is a pile with them.</summary>
    private void GoOn(BallState[] states, int i, in Motion after, in Vector3d n)
    {
        if (!_piles.Has(i) && _rests.IsHeld(i))
        {
            BallPile pile = _piles.Begin(states[i].Time, _span.Length);
            TakeAllOf(_rests.RootOf(i), states, pile, pile.Time);
        }

        if (_piles.Has(i))
        {
            states[i].Velocity = after.Velocity;
            states[i].SpinAxis = after.Spin;
            return;
        }

        _simulators[i].Struck(ref states[i], in after.Velocity, in after.Spin, in n, _current[i]);
        Try(states, i, _span.End);
    }
}
