using FootballPhysics.Simulation;

namespace FootballPhysics;

/// <content>The independent steps of all balls, and the choice of the balls that must be stepped together.</content>
public sealed partial class BallGroup
{
    /// <summary>Finds the piles, which are stepped as one: independent steps would move their balls through each other.</summary>
    private void FindPiles(double dt)
    {
        bool covers = true;
        for (int i = 0; i < Count && covers; i++)
        {
            covers = _neighbours.Covers(i, in _before[i]);
        }

        if (!covers)
        {
            Array.Clear(_reaches, 0, Count);
            _neighbours.Renew(_before, _reaches, dt);
        }

        _cluster.Rests.Look(_before, _neighbours);
    }

    /// <summary>Takes the step of every ball as if it were alone.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="stopAt">The event that ends it.</param>
    /// <param name="holds">False if a ball moved farther than the search for neighbours assumed.</param>
    /// <param name="again">True if all balls must be stepped again: an event ended a step, events were dropped, or the reach of a ball that
    /// pushed an object is unknown.</param>
    /// <returns>True if a ball has pushed an object.</returns>
    private bool Fly(BallState[] states, double dt, StopAt stopAt, out bool holds, out bool again)
    {
        holds = true;
        double time = states[0].Time;
        StepLog log = _flown;
        log.Clear();
        log.StopAt = stopAt;
        log.Pushes = true;
        log.HaltsAtPush = false;
        again = false;
        bool pushes = false;
        for (int i = 0; i < states.Length; i++)
        {
            ref BallState s = ref states[i];
            if (s.Time != time || !s.IsLaunched)
            {
                CheckState(in s, i, time);
            }

            ref readonly BallState before = ref _before[i];
            int first = log.Events.Count;
            _firstEvent[i] = first;
            _pushes[i] = false;
            BallTrial trial = _cluster.TrialOf(i);
            trial.IsWhole = false;
            log.Events.Ball = i;
            if (_cluster.Rests.IsInPile(i))
            {
                // The path of a pile is computed later, so estimate its reach here.
                _reaches[i] = dt * (before.Velocity.Length + (BallNeighbours.Fall * dt));
                _cluster.Shares.Begin(i, in before, 0);
                holds &= _neighbours.Holds(i, in before, _reaches[i], dt);
                continue;
            }

            if (_cluster.Rests.IsHeld(i) && !_simulators[i].World.Moves)
            {
                s.Time += dt;
                _reaches[i] = 0;
                _cluster.Shares.Begin(i, in before, 0);
                continue;
            }

            log.Pushed = false;
            log.HasFollowed = false;

            // A ball whose path the last step needed may need it again: record it.
            if ((trial.IsNeeded || _cluster.Has(i)) && stopAt == StopAt.Time)
            {
                trial.TakeStep(_simulators[i], ref s, dt, log);
            }
            else
            {
                _simulators[i].Advance(ref s, dt, log);
            }

            again |= log.Halted;
            log.Halted = false;
            _pushes[i] = log.Pushed;
            if (_simulators[i].World.MayGiveWay)
            {
                _cluster.Shares.Begin(i, in s, Fastest(first));
            }

            pushes |= log.Pushed;

            // If the ball leaves the bounds of its sphere, at an end of its step or at an event, its reach is that of its path.
            bool keeps = !log.HasFollowed && _neighbours.Holds(i, in before, in s, dt) && (first == log.Events.Count || KeepsPace(i, first));
            _reaches[i] = keeps ? _neighbours.ReachOf(i) : trial.IsWhole ? trial.Reach : double.PositiveInfinity;
            trial.IsNeeded = !keeps;
            holds &= keeps;
            again |= log.Pushed && !keeps && !trial.IsWhole;
        }

        _firstEvent[states.Length] = log.Events.Count;
        again |= log.Events.Dropped > 0;
        return pushes;
    }

    /// <summary>Resets the clear times of other balls after a push, so that the result does not depend on which balls were stepped
    /// together.</summary>
    private void ForgetSpaceAhead(BallState[] states)
    {
        int pushing = 0;
        for (int i = 0; i < Count; i++)
        {
            _pushes[i] = _cluster.Has(i) ? _cluster.HasPushed(i) : _pushes[i];
            pushing += _pushes[i] ? 1 : 0;
        }

        for (int i = 0; pushing > 0 && i < Count; i++)
        {
            states[i].ClearUntil = _pushes[i] && pushing == 1 ? states[i].ClearUntil : 0;
        }
    }

    /// <summary>Returns the greatest speed at the events of the last ball, m/s.</summary>
    private double Fastest(int first)
    {
        double squared = 0;
        for (int k = first; k < _flown.Events.Count; k++)
        {
            ref readonly BallEvent happened = ref _flown.Events[k];
            squared = Math.Max(squared, Math.Max(happened.VelocityBefore.LengthSquared, happened.Velocity.LengthSquared));
        }

        return Math.Sqrt(squared);
    }

    /// <summary>Throws if a state was never launched, or has another time than the first ball.</summary>
    /// <param name="state">The state.</param>
    /// <param name="ball">The index of the ball.</param>
    /// <param name="time">The time of the first ball, s.</param>
    internal static void CheckState(in BallState state, int ball, double time)
    {
        BallState.Launched(in state);
        if (state.Time != time)
        {
            throw new ArgumentException(
                FormattableString.Invariant($"states[{ball}].time is {state.Time:R}; allowed: {time:R}, the time of the first ball."), nameof(state));
        }
    }

    /// <summary>Measures the reach of balls that exceed the bounds of their spheres, and finds the neighbours again if a ball left its
    /// sphere.</summary>
    private void RenewNeighbours(double dt, bool again)
    {
        // If all balls are stepped again, measure their paths with the objects not yet pushed.
        bool holds = true;
        for (int i = 0; i < Count; i++)
        {
            if (_reaches[i] < double.PositiveInfinity)
            {
                holds &= _neighbours.Holds(i, in _before[i], _reaches[i], dt);
                continue;
            }

            // Repeat the step and record its path.
            _motions.Read();
            if (again)
            {
                _motions.PutBack();
            }

            BallTrial trial = _cluster.TrialOf(i);
            trial.RunStep(_simulators[i], in _before[i], dt, _motions);
            _reaches[i] = trial.Reach;
            holds &= _neighbours.Holds(i, in _before[i], _reaches[i], dt);
        }

        if (!holds)
        {
            _neighbours.Renew(_before, _reaches, dt);
        }
    }

    /// <summary>True if a ball never exceeded the speed that its sphere was built for, before and after each event.</summary>
    private bool KeepsPace(int ball, int first)
    {
        for (int k = first; k < _flown.Events.Count; k++)
        {
            ref readonly BallEvent happened = ref _flown.Events[k];
            if (happened.Kind == BallEventKind.Pinned
                || !_neighbours.Allows(ball, happened.VelocityBefore.LengthSquared) || !_neighbours.Allows(ball, happened.Velocity.LengthSquared))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Finds the balls that may reach another ball in this step.</summary>
    private void FindCluster(bool all, bool pushes)
    {
        if (!all)
        {
            for (int k = 0; k < _neighbours.Count; k++)
            {
                (int i, int j) = _neighbours[k];
                if (_cluster.MayMeet(i, _reaches[i], j, _reaches[j]))
                {
                    _cluster.Join(i);
                    _cluster.Join(j);
                }
            }
        }

        for (int i = 0; i < Count; i++)
        {
            if (all || _cluster.Rests.IsInPile(i))
            {
                _cluster.Join(i);
            }
        }

        for (int i = 0; i < Count && pushes && _cluster.Count > 0; i++)
        {
            // The cluster's step starts before all pushes, so it includes every ball that pushes an object.
            if (_pushes[i])
            {
                _cluster.Join(i);
            }
        }
    }
}
