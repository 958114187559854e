using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Balls that may collide in a step, stepped again together from its start: event by event, bit-identical to their own
/// steps.</summary>
internal sealed partial class BallCluster
{
    /// <summary>Maximum number of impacts at one instant, plus one per pair. The rest of the instant is without restitution.</summary>
    private const int MostAtOnce = 8;

    /// <summary>Maximum number of separate impacts of a ball with others per step. After that it joins a pile.</summary>
    private const int MostMeetings = 16;

    /// <summary>Maximum number of pushes and ball contacts per ball and step.</summary>
    /// <remarks>After that the balls ignore each other for the rest of the step.</remarks>
    private const int MostImpacts = 256;

    /// <summary>Margin factor for the reach of a ball that moves farther than expected.</summary>
    private const double MoreReach = 1.25;

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
    /// <param name="contact">The material of impacts between balls.</param>
    /// <param name="friction">The friction coefficient of sustained contact between balls.</param>
    /// <param name="before">The balls before the step.</param>
    /// <param name="reaches">Upper bound of each ball's displacement in the step, m.</param>
    /// <param name="logs">Receive the events and counts of each ball.</param>
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

    /// <summary>Number of balls in the cluster.</summary>
    public int Count => _clusterCount;

    /// <summary>Index of a ball of the cluster.</summary>
    public int this[int index] => _cluster[index];

    /// <summary>True if a ball is in the cluster.</summary>
    public bool Has(int ball) => _isIn[ball];

    /// <summary>True if a ball of the cluster has pushed an object.</summary>
    public bool HasPushed(int ball) => _current[ball].Pushed;

    /// <summary>Removes all balls.</summary>
    public void Clear()
    {
        for (int k = 0; k < _clusterCount; k++)
        {
            _isIn[_cluster[k]] = false;
        }

        _clusterCount = 0;
    }

    /// <summary>Adds a ball.</summary>
    public void Join(int ball)
    {
        if (!_isIn[ball])
        {
            _isIn[ball] = true;
            _meets.Forget();
            _cluster[_clusterCount++] = ball;
        }
    }

    /// <summary>Ends a step after an exception.</summary>
    public void Abandon() => Array.ForEach(_current, log => log.Abandon());

    /// <summary>The balls in sustained contact before the step.</summary>
    public BallRests Rests => _rests;

    /// <summary>Steps the balls of the cluster from the start of the step: repeatedly finds the first event, and recomputes the paths that it
    /// changes.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="stopAt">The event that ends it.</param>
    /// <param name="watched">Logs whose observers receive the paths; null for the cluster's own logs.</param>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <returns>True if an event ended the step.</returns>
    public bool Play(BallState[] states, double dt, StopAt stopAt, StepLog[]? watched, MotionSnapshot motions)
    {
        // First find the balls that share a pushed object, because an observer must see only one pass.
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

    private bool PlayOnce(BallState[] states, double dt, StopAt stopAt, StepLog[]? watched, MotionSnapshot motions)
    {
        _current = watched ?? _logs;
        _clears = watched is null;
        _span = new StepSpan(_before[0].Time, dt);
        _stopAt = stopAt;
        double end = _span.End;

        // Sort by index, because the first of several simultaneous events is used.
        Array.Sort(_cluster, 0, _clusterCount);
        _begun = 0;
        _piles.Clear();
        _meets.Forget();

        // Also undo the pushes of the first trial.
        motions.Read();
        motions.PutBack();
        int impacts = 0;
        int atOnce = 0;
        double last = double.NegativeInfinity;
        bool ended = false;
        while (!ended)
        {
            // A ball that joins later starts from its state at the beginning of the step.
            BeginNew(states);
            if (PlanPiles(states, out double planned))
            {
                last = planned;
                ended = true;
                break;
            }

            // Until the first event, move every ball as if it were alone, and every pile to the end of its part.
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

            atOnce = first.Time - last <= ContactTolerances.BallsTouch ? atOnce + 1 : 0;
            last = first.Time;
            impacts++;
            if (first.IsMeeting)
            {
                // There were too many impacts at one instant: resolve the rest of the instant without restitution, as in a pile.
                bool presses = atOnce > MostAtOnce + (_clusterCount * (_clusterCount - 1) / 2);
                ended = Collide(states, in first, presses);
            }
            else
            {
                ended = Push(states, in first, end);
            }
        }

        // There is no further event.
        EndAll(states, ended, ended ? last : end);
        return ended;
    }

    /// <summary>Moves all balls to the end of the step, or to the event that ended it.</summary>
    private void EndAll(BallState[] states, bool ended, double time)
    {
        foreach (int i in _cluster.AsSpan(0, _clusterCount))
        {
            if (!_piles.Has(i) && (!ended || states[i].Time < time))
            {
                Commit(states, i, time);
            }
        }

        for (int k = 0; k < _piles.Count; k++)
        {
            _piles[k].MoveTo(states, time, _current);
            _piles[k].End(states, _current);
        }

        foreach (int i in _cluster.AsSpan(0, _clusterCount))
        {
            _current[i].End(in states[i]);
        }
    }

    /// <summary>Resets new balls of the cluster to the start of the step, puts touching ones into piles, and computes the paths of the
    /// others.</summary>
    private void BeginNew(BallState[] states)
    {
        // The ball's path may add more balls to the cluster.
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
            else if (!_piles.Has(i) && _trials[i].IsWhole && !_shares[i] && _stopAt == StopAt.Time)
            {
                Reach(states, i);
            }
            else if (!_piles.Has(i))
            {
                Try(states, i, _span.End);
            }
        }
    }

    /// <summary>Resets a ball to its state before the step.</summary>
    private void Begin(BallState[] states, int i)
    {
        states[i] = _before[i];
        _current[i].Begin(i, _clears, _simulators[i].Zones, in _before[i]);
        _meetings[i] = 0;
        _piles.Leave(i);
    }

    /// <summary>Moves a ball to a time on its path, exactly as its own step would; if it is in a pile, all balls of the pile.</summary>
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

        // Reuse a path if one has been computed: the trial to the end of the step, or the path to the contact with another ball.
        if (_touch.TryTake(i, ref s, time, own) || (time == _span.End && _trials[i].TryTake(ref s, time, own)))
        {
            return;
        }

        if (left > 0)
        {
            _simulators[i].Advance(ref s, left, own);
        }

        // If its path buffer is full, Advance ends early: continue until this time is reached.
        while (own.Halted && s.Time < time)
        {
            own.Halted = false;
            _simulators[i].Advance(ref s, _span.Left(in s, time), own);
        }

        s.Time = time;
    }

    /// <summary>Resolves a contact of two balls: both move there exactly by their own steps, then get the impulse or form a pile.</summary>
    /// <returns>True if that ends the step.</returns>
    private bool Collide(BallState[] states, in Happening met, bool presses)
    {
        int i = met.Ball;
        int j = met.Other;
        double time = _touch.Locate(states, in met, in _span, _current);
        Commit(states, i, time);
        Commit(states, j, time);
        _touch.Forget();
        BallContact.Gap(in states[i], _simulators[i].Scene.Ball.Radius, in states[j], _simulators[j].Scene.Ball.Radius, out Vector3d n, out double rate);

        // Slow contacts, and balls that hit each other repeatedly, are in sustained contact: solve them as a pile without restitution.
        if (presses || rate > -BallContact.Gentle || HasHitEnough(i) || HasHitEnough(j))
        {
            _current[i].UnreportedImpacts++;
            Press(states, i, j, time);
            return false;
        }

        _meetings[i]++;
        _meetings[j]++;
        BallContact.Impact(_simulators, in _contact, i, j, in n, states, _current, out Motion first, out Motion second);
        GoOn(states, i, in first, in n);
        GoOn(states, j, in second, -n);
        return _stopAt == StopAt.Impact;
    }

    /// <summary>True if a ball has used its separate impacts in this step, by itself or with its pile.</summary>
    private bool HasHitEnough(int i) => _meetings[i] >= MostMeetings || _piles.Of(i) is { IsSpent: true };

    /// <summary>Sets the state of a ball after a hit by another ball.</summary>
    /// <remarks>A supported ball keeps its carrier unless the impulse lifts it. A ball that touches other balls forms a pile with
    /// them.</remarks>
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
