namespace Football.Physics;

/// <content>Piles of the cluster.</content>
internal sealed partial class BallCluster
{
    /// <summary>Finds where the piles go next that have come to the end of a part.</summary>
    /// <returns>Whether a ball of one bounced, and that ends the step.</returns>
    private bool PlanPiles(BallState[] states, out double time)
    {
        for (int k = 0; k < _pileCount; k++)
        {
            BallPile pile = _piles[k];
            time = pile.Time;
            if (pile.Count == 0 || pile.Until > time || !(time < _end))
            {
                continue;
            }

            if (pile.Plan(states, _end, _current) && _stopAt == StopAt.Impact)
            {
                return true;
            }

            for (int m = 0; m < pile.Count; m++)
            {
                int i = pile[m];
                _trials[i].Go(in states[i], pile.WayOf(m), pile.Until - time);
                Reach(states, i);
            }
        }

        time = 0;
        BeginNew(states);
        return false;
    }

    /// <summary>The pile that comes first to the end of its part; null where all are at the end of the step.</summary>
    private BallPile? FirstPile()
    {
        BallPile? first = null;
        for (int k = 0; k < _pileCount; k++)
        {
            BallPile pile = _piles[k];
            first = pile.Count > 0 && pile.Time < _end && !(first?.Until <= pile.Until) ? pile : first;
        }

        return first;
    }

    private BallPile NewPile(double time)
    {
        if (_pileCount == _piles.Length)
        {
            Array.Resize(ref _piles, _pileCount + 1);
            _piles[_pileCount] = new BallPile(_simulators, in _contact, _friction);
        }

        BallPile pile = _piles[_pileCount++];
        pile.Clear(time, _step);
        return pile;
    }

    /// <summary>Takes all balls into a pile that lie on each other.</summary>
    private void TakeAllOf(int root, BallState[] states, BallPile pile, double time)
    {
        for (int i = root; i < _pileOf.Length; i++)
        {
            if (_rests.RootOf(i) == root)
            {
                Take(i, states, pile, time);
            }
        }

        pile.Sort(states);
    }

    private void Take(int i, BallState[] states, BallPile pile, double time)
    {
        if (!_isIn[i])
        {
            Join(i);
            Begin(states, i);

            // It has begun: in its place is the first that has not.
            (_cluster[_begun], _cluster[_clusterCount - 1]) = (_cluster[_clusterCount - 1], _cluster[_begun]);
            _begun++;
        }

        if (_pileOf[i] < 0)
        {
            Commit(states, i, time);
            pile.Add(i, ref states[i]);
            _trials[i].Go(in states[i], Vector3d.Zero, 0);
            _meets.Change(i);
            _pileOf[i] = Array.IndexOf(_piles, pile);
        }
    }

    /// <summary>Two balls press each other: from now on they are of one pile, with all that lie on them.</summary>
    private void Press(BallState[] states, int i, int j, double time)
    {
        int a = _pileOf[i];
        int b = _pileOf[j];
        BallPile pile = a >= 0 ? _piles[a] : b >= 0 ? _piles[b] : NewPile(time);
        TakeAllOf(_rests.RootOf(i), states, pile, time);
        TakeAllOf(_rests.RootOf(j), states, pile, time);
        if (a >= 0 && b >= 0 && a != b)
        {
            BallPile other = _piles[b];
            for (int m = 0; m < other.Count; m++)
            {
                pile.Add(other[m], ref states[other[m]]);
                _pileOf[other[m]] = a;
            }

            other.Clear(time, _step);
            pile.Sort(states);
        }
    }
}
