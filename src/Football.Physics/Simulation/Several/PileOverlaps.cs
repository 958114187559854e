using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Resolves the overlaps of a pile after a part. No ball enters a stationary object.</summary>
/// <param name="simulators">The scenes of all balls of the group.</param>
/// <param name="system">The pile's balls and contacts.</param>
internal sealed class PileOverlaps(Simulator[] simulators, PileSystem system)
{
    /// <summary>Maximum number of iterations for overlaps of balls and objects.</summary>
    private const int MostRounds = 128;

    /// <summary>Separates overlapping balls by their masses, then pushes them out of moving objects up to a distance, and out of stationary
    /// ones.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="duration">Duration of the part, s.</param>
    public void PutApart(BallState[] states, double duration)
    {
        bool moved = true;
        for (int round = 0; round < MostRounds && moved; round++)
        {
            moved = false;
            for (int i = 0; i < system.ContactCount; i++)
            {
                ref readonly Contact contact = ref system.Contacts[i];
                if (contact.Second >= 0)
                {
                    ref readonly PressedBall a = ref system.Balls[contact.First];
                    ref readonly PressedBall b = ref system.Balls[contact.Second];
                    ref BallState s = ref states[system.Members[contact.First].Ball];
                    ref BallState its = ref states[system.Members[contact.Second].Ball];
                    Vector3d apart = s.Position - its.Position;
                    double most = a.Radius + b.Radius;
                    double square = apart.LengthSquared;
                    if (square < most * most)
                    {
                        double distance = Math.Sqrt(square);
                        double over = most - distance;
                        Vector3d shift = distance > 0 ? over * contact.NormalMass / distance * apart : over * contact.NormalMass * BallContact.Normal(in apart, 0);
                        s.Position += a.PerMass * shift;
                        its.Position -= b.PerMass * shift;
                        moved |= over > ContactTolerances.PileOverlap;
                    }
                }
            }

            for (int i = 0; i < system.Count; i++)
            {
                moved |= KeepOut(i, states, round == 0 ? ContactSet.OutOfTheWay * duration : 0);
            }
        }

        for (int i = 0; i < system.Count; i++)
        {
            StayOut(i, states);
        }
    }

    /// <summary>Returns the maximum overlap of two balls, m; 0 if none overlap.</summary>
    public double Deepest(BallState[] states)
    {
        double deepest = 0;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly Contact contact = ref system.Contacts[i];
            if (contact.Second >= 0)
            {
                Vector3d apart = states[system.Members[contact.First].Ball].Position - states[system.Members[contact.Second].Ball].Position;
                deepest = Math.Max(deepest, system.Balls[contact.First].Radius + system.Balls[contact.Second].Radius - apart.Length);
            }
        }

        return deepest;
    }

    /// <summary>Pushes a ball out of stationary objects.</summary>
    public void KeepOut(int member, BallState[] states)
    {
        KeepOut(member, states, 0);
        StayOut(member, states);
    }

    /// <summary>Pushes a ball out of objects that it overlaps.</summary>
    /// <returns>True if that moved it.</returns>
    private bool KeepOut(int member, BallState[] states, double most)
    {
        int ball = system.Members[member].Ball;
        Vector3d from = states[ball].Position;
        ContactSet.PushOut(simulators[ball].World, ref states[ball], system.OwnContactsOf(member), most);
        return (states[ball].Position - from).Length > ContactTolerances.PileOverlap;
    }

    /// <summary>Keeps a ball out of all stationary objects: many balls may push it past the known contacts.</summary>
    private void StayOut(int member, BallState[] states)
    {
        int ball = system.Members[member].Ball;
        ContactSet.StayOut(simulators[ball].World, ref states[ball], system.Members[member].From.Position);
    }
}
