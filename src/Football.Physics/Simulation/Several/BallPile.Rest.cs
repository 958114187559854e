using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <content>The rest state of the pile.</content>
internal sealed partial class BallPile
{
    /// <summary>Projects a ball onto stationary surfaces with a load: a gap left by the part would cause another impact.</summary>
    private void HoldOnto(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _system.Members[index];
        World world = _simulators[member.Ball].World;
        foreach (ref readonly Contact contact in _system.OwnContactsOf(index))
        {
            if (contact.Load > 0 && !contact.Moves)
            {
                world.Hold(ref states[member.Ball], world.ByIndex[contact.Collider]);
            }
        }
    }

    /// <summary>Stores in a resting ball a key of the balls that it touches, and of stationary objects that may move later.</summary>
    private void SetKey(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _system.Members[index];
        ref BallState s = ref states[member.Ball];
        ulong key = BallRests.FirstKey + BallRests.KeyOfMovers(_simulators[member.Ball].World, in s);
        for (int j = 0; j < Count; j++)
        {
            ref readonly BallState its = ref states[_system.Members[j].Ball];
            key += j != index && BallRests.Touches(in s, _system.Balls[index].Radius, in its, _system.Balls[j].Radius) ? BallRests.KeyOf(its.Position) : 0;
        }

        s.ClearIn = key;
    }

    /// <summary>True if the contacts hold the balls at zero velocity, and no ball rests on an object that moves in this step.</summary>
    private bool Holds(BallState[] states)
    {
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
            member.Free = _simulators[member.Ball].Pile.FreeAtRest(in states[member.Ball], RestPart);
            _system.Balls[i].V = RestPart * member.Free.Acceleration;
            _system.Balls[i].W = RestPart * member.Free.SpinAcceleration;
        }

        double pull = _system.Fastest();

        // Warm start: the loads are close to those of the previous part.
        double last = _length > 0 ? RestPart / _length : 0;
        Find(states, ContactTolerances.Leaning, 0);
        Continue(last);
        for (int i = 0; i < _system.ContactCount; i++)
        {
            _system.Contacts[i].Gap = 0;
            if (_system.Contacts[i].MovesNow)
            {
                return false;
            }
        }

        _system.Solve(RestPart, RestRounds, 1e-3 * ContactTolerances.PileHeld * pull, ContactTolerances.PileHeld * pull);
        return _system.Fastest() <= ContactTolerances.PileHeld * pull;
    }

    /// <summary>True if every ball is slow enough, the contacts hold all of them, and at least one stationary object has a load.</summary>
    private bool Rests(BallState[] states, StepLog[] logs)
    {
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _system.Members[i];
            ref readonly PressedBall ball = ref _system.Balls[i];
            ref readonly BallState s = ref states[member.Ball];
            double energy = 0.5 * ((s.Velocity.LengthSquared / ball.PerMass) + (s.Spin.LengthSquared / ball.PerInertia));
            if (!(energy <= _simulators[member.Ball].World.RestEnergy))
            {
                return false;
            }
        }

        bool borne = false;
        for (int i = 0; i < _system.ContactCount; i++)
        {
            borne |= _system.Contacts[i].Second < 0 && !_system.Contacts[i].MovesNow && _system.Contacts[i].Load > 0;
        }

        if (!borne)
        {
            return false;
        }

        for (int i = 0; i < Count; i++)
        {
            logs[_system.Members[i].Ball].Evaluations++;
        }

        return Holds(states);
    }
}
