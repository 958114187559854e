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
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        var before = new Motion(s.Position, in v, in w);
        bool solved = ContactSolver.Solve(set, _world.Ball, 0, ref v, ref w, closing: ContactTolerances.Approaching) && run.MergedImpacts++ < MostMerged;

        // If no impulses stop all contacts from closing, or if this happens repeatedly, the ball is squeezed. Only moving objects can squeeze it.
        if (ContactSet.HasMover(set) && (!solved || IsTooFast(ref s, set, in v)))
        {
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        SolvedSet.Correct(set, _world.Ball, 0, solved, in before, ref v, ref w);
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
        run.Squeezes++;
        s.Carrier = collider + _world.FirstCollider;
        run.Report(BallEventKind.Pinned, _world.Reported(s.Carrier), _world.ByIndex[collider].At(s.Position, s.Time).Normal, in s, s.Velocity, s.Spin);
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

    /// <summary>True if moving objects would make the ball too fast.</summary>
    /// <remarks>The limit is the greater of its speed on arrival and 1 + e times the speed of the fastest mover that pushes it.</remarks>
    /// <param name="s">The ball.</param>
    /// <param name="set">The contacts and their impulses.</param>
    /// <param name="velocity">The resulting velocity, m/s.</param>
    public bool IsTooFast(ref BallState s, Span<Contact> set, in Vector3d velocity)
    {
        // (1 + e) |V| of the fastest mover that pushes the ball, or −1 if there is no such mover.
        double fastest = -1.0;
        foreach (ref readonly Contact contact in set)
        {
            double speed = contact.Velocity.Length;
            fastest = contact.Moves && contact.Load > 0 ? Math.Max(fastest, ((1.0 + contact.Material.LargestRestitutionAt(speed)) * speed) + contact.Material.MinimumExitSpeed) : fastest;
        }

        if (fastest < 0)
        {
            return false;
        }

        Touches(ref s, fastest);
        return velocity.Length > s.SqueezeSpeed;
    }

    /// <summary>Records a contact with a moving object that may accelerate the ball to a given speed, m/s.</summary>
    /// <returns>True if another contact with a mover was recorded recently.</returns>
    public static bool Touches(ref BallState s, double fastest)
    {
        bool again = s.Time < s.SqueezeUntil;
        s.SqueezeSpeed = Math.Max(again ? s.SqueezeSpeed : s.Velocity.Length, fastest);
        s.SqueezeUntil = StateCheck.SqueezedUntil(s.Time);
        return again;
    }
}
