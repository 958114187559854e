using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <content>Many impacts at one instant, and a ball that moving objects squeeze.</content>
internal sealed partial class WorldContact
{
    /// <summary>If a step resolves all contacts together more often than this, the ball has no room.</summary>
    private const int MostMerged = 3;

    /// <summary>Resolves all contacts at once without restitution.</summary>
    /// <remarks>The ball then closes on no stationary object. Moving objects may squeeze it.</remarks>
    [SkipLocalsInit]
    private void ImpactAtOnce(ref BallState s, int collider, ref StepRun run)
    {
        run.Log.UnreportedImpacts++;

        // Solve all contacts as one set, over zero time and without restitution.
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Near(_world, in s, ContactTolerances.Touching, room, _world.Room);
        run.Stay(s.Time);
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        var before = new Motion(s.Position, in v, in w);
        bool solved = ImpulseSolver.Solve(set, _world.Ball, 0, ref v, ref w, closing: ContactTolerances.Approaching) && run.Spent.MergedImpacts++ < MostMerged;

        // If no impulses stop all contacts from closing, or if this happens repeatedly, the ball is squeezed. Only moving objects can squeeze it.
        if (ContactSet.HasMover(set) && (!solved || IsTooFast(in s, set, in before.Velocity, in v)))
        {
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        SolvedSet.Correct(set, _world, 0, solved, in before, ref v, ref w);
        s.Velocity = v;
        s.SetGroundSpin(in w);

        // The contact with the greatest load becomes the carrier if the forces press the ball onto it. Otherwise, the ball flies.
        int bearer = ContactSet.Heaviest(set);
        if (bearer >= 0 && _load.IsPressed(in s, set[bearer].Collider))
        {
            Stay(ref s, set[bearer].Collider + _world.FirstCollider, in v, in w, ref run);
        }
        else if (s.Motion == MotionState.Airborne)
        {
            Fly(ref s, in v, in w);
        }
        else
        {
            Leave(ref s, in v, in w, ref run);
        }
    }

    /// <summary>Starts a squeeze: moving objects leave the ball no room.</summary>
    public void BeginSqueeze(ref BallState s, int collider, ref StepRun run)
    {
        run.Spent.Squeezes++;
        s.Carrier = collider + _world.FirstCollider;

        // A squeeze adds no energy: the ball keeps at most the speed of its arrival, or the speed that the fastest mover gives it.
        double most = Math.Max(run.Spent.Arrival, run.Spent.Fastest);
        double speed = s.Velocity.Length;
        Vector3d kept = speed > most ? most / speed * s.Velocity : s.Velocity;
        run.Report(BallEventKind.Pinned, _world.Reported(s.Carrier), _world.ByIndex[collider].At(s.Position, s.Time).Normal, in s, in kept, s.Spin);
        s.Velocity = kept;
        s.SetGroundSpin(s.Spin);
        s.Motion = MotionState.Pinned;
        s.Branch = DragBranch.Unknown;
    }

    /// <summary>Ends a squeeze: the ball has room again.</summary>
    public void EndSqueeze(ref BallState s, ref StepRun run)
    {
        run.Report(BallEventKind.Pinned, -1, Vector3d.Zero, in s, s.Velocity, s.Spin);
        Fly(ref s, s.Velocity, s.Spin);
    }

    /// <summary>True if objects that press the ball all the time would make it faster than the forces, their own speeds and an impact
    /// do.</summary>
    /// <remarks>To get out of their path, the ball would have to move farther than they do: they squeeze it.</remarks>
    /// <param name="s">The ball.</param>
    /// <param name="set">The contacts and their impulses.</param>
    /// <param name="free">The velocity without contacts, m/s.</param>
    /// <param name="velocity">The velocity with contacts, m/s.</param>
    public static bool IsTooFast(in BallState s, Span<Contact> set, in Vector3d free, in Vector3d velocity)
    {
        double fastest = FastestBy(set);
        return fastest >= 0 && velocity.Length > Math.Max(fastest, Math.Max(s.Velocity.Length, free.Length));
    }

    /// <summary>Returns the speed that the fastest mover with a load gives a ball, (1 + e) |V|, m/s; −1 if there is no such mover.</summary>
    public static double FastestBy(Span<Contact> set)
    {
        double fastest = -1.0;
        foreach (ref readonly Contact contact in set)
        {
            fastest = contact.Moves && contact.Load > 0 ? Math.Max(fastest, contact.Material.FastestBy(contact.Velocity.Length)) : fastest;
        }

        return fastest;
    }
}
