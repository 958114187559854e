using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <content>The rest state of the pile.</content>
internal sealed partial class BallPile
{
    /// <summary>Projects a ball onto stationary surfaces with a load: a gap left by the part would cause another impact.</summary>
    private void HoldOnto(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _solver.Members[index];
        World world = _simulators[member.Ball].World;
        for (int i = member.FirstContact; i < member.FirstContact + member.OwnContacts; i++)
        {
            ref readonly PileContact contact = ref _solver.Contacts[i];
            if (contact.Load > 0 && !contact.Moves)
            {
                world.Hold(ref states[member.Ball], world.ByIndex[contact.Collider]);
            }
        }
    }

    /// <summary>Stores in a resting ball a key of the balls that it touches, and of stationary objects that may move later.</summary>
    private void SetKey(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _solver.Members[index];
        ref BallState s = ref states[member.Ball];
        ulong key = BallRests.FirstKey + BallRests.KeyOfMovers(_simulators[member.Ball].World, in s);
        for (int j = 0; j < Count; j++)
        {
            ref readonly PileMember other = ref _solver.Members[j];
            ref readonly BallState its = ref states[other.Ball];
            key += j != index && BallRests.Touches(in s, member.Radius, in its, other.Radius) ? BallRests.KeyOf(its.Position) : 0;
        }

        s.ClearIn = key;
    }

    /// <summary>True if the contacts hold the balls at zero velocity, and no ball rests on an object that moves in this step.</summary>
    private bool Holds(BallState[] states)
    {
        double pull = 0;
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            member.Free = _simulators[member.Ball].Pile.FreeAtRest(in states[member.Ball], RestPart);
            member.V = RestPart * member.Free.Acceleration;
            member.W = RestPart * member.Free.SpinAcceleration;
            pull = Math.Max(pull, member.V.Length + (member.Radius * member.W.Length));
        }

        // Warm start: the loads are close to those of the previous part.
        double last = _length > 0 ? RestPart / _length : 0;
        Find(states, ContactTolerances.Leaning, 0);
        Continue(last);
        for (int i = 0; i < _solver.ContactCount; i++)
        {
            _solver.Contacts[i].Gap = 0;
            if (_solver.Contacts[i].MovesNow)
            {
                return false;
            }
        }

        _solver.Solve(RestPart, RestRounds, 1e-3 * ContactTolerances.PileHeld * pull, ContactTolerances.PileHeld * pull);
        return _solver.Fastest() <= ContactTolerances.PileHeld * pull;
    }

    /// <summary>True if every ball is slow enough, the contacts hold all of them, and at least one stationary object has a load.</summary>
    private bool Rests(BallState[] states, StepLog[] logs)
    {
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            double energy = 0.5 * ((s.Velocity.LengthSquared / member.PerMass) + (s.Spin.LengthSquared / member.PerInertia));
            if (!(energy <= _simulators[member.Ball].World.RestEnergy))
            {
                return false;
            }
        }

        bool borne = false;
        for (int i = 0; i < _solver.ContactCount; i++)
        {
            borne |= _solver.Contacts[i].Second < 0 && !_solver.Contacts[i].MovesNow && _solver.Contacts[i].Load > 0;
        }

        if (!borne)
        {
            return false;
        }

        for (int i = 0; i < Count; i++)
        {
            logs[_solver.Members[i].Ball].Evaluations++;
        }

        return Holds(states);
    }
}
