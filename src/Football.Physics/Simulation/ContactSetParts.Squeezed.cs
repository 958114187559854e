using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Steps a ball that moving objects squeeze: they leave the ball no room, so each part of a step moves it as far as possible.</summary>
internal sealed partial class ContactSetParts
{
    /// <summary>A ball that is squeezed more often than this in one step stays squeezed until the next step.</summary>
    private const int MostSqueezes = 1;

    /// <summary>A direction leads off all contacts if its component along every normal is at least this.</summary>
    private const double Room = 0.1;

    /// <summary>Takes the rest of a step for a squeezed ball.</summary>
    /// <remarks>The ball never enters stationary objects. Moving objects push it as far as its allowed speed permits, without restitution.
    /// The squeeze ends when no moving object pushes the ball any longer, or when some direction leads off all contacts.</remarks>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void TakeSqueezed(ref BallState s, ref StepRun run)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        double part = LengthOfPart(in run, 2.0 * Part);
        bool isFree = false;
        while (run.TakesParts(_world))
        {
            double h = run.Left / Math.Max(1.0, Math.Round(run.Left / part));
            run.Spent.Parts++;

            // Velocity and spin after a part h from the forces alone: v + h a, ω + h ω̇.
            var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
            MotionRates free = _forces.Free(in s, s.Time, in from, isCarried: true, h);
            Vector3d v = from.Velocity + (h * free.Acceleration);
            Vector3d w = from.Spin + (h * free.SpinAcceleration);
            run.Log.Evaluations++;

            // The maximum speed is the ball's own speed plus the work of the forces, or the speed of the objects that push it.
            double came = from.Velocity.Length;

            // The search radius covers the ball's own path, the path of a mover (or of a struck ball at twice its speed), and the resolved overlap.
            double reach = ContactTolerances.Touching + (h * (v.Length + (3.0 * _world.FastestMover) + ContactSet.OutOfTheWay));
            Span<Contact> set = ContactSet.Near(_world, in s, reach, room, _more);

            // Approximate the contact impulses in a few iterations, because without room there may be no exact solution.
            ImpulseSolver.Solve(set, _world.Ball, h, ref v, ref w, rounds: ImpulseSolver.RoundsInVain);
            LeaveOut(ref set, run.Log);

            // Friction must not hold the ball in the path of a moving object, and the ball must not enter a stationary one.
            SolvedSet.KeepOff(set, _world, h, movers: true, ref v);
            double given = Math.Max(came, WorldContact.FastestBy(set));
            Vector3d kept = v;
            SolvedSet.KeepOff(set, _world, h, movers: false, ref kept);

            // f² = |v|² + 2 h f W·d: in a part h, the work of the forces W along the direction d changes the speed from |v| to f.
            double worked = h * Vector3d.Dot(Working(in free, in from), in kept) / Math.Max(kept.Length, ContactTolerances.Standstill);
            double fastest = Math.Max(given, worked + Math.Sqrt((worked * worked) + (came * came)));

            // Limit the speed to this value. Process stationary objects last, so that the ball does not enter them.
            double speed = v.Length;
            v = speed > fastest ? fastest / speed * v : v;
            SolvedSet.KeepOff(set, _world, h, movers: false, ref v);

            var path = PathCubic.Line(s.Position, in v, h);
            bool passes = new ContactSearch(_world, in path, s.Time).FirstPassage(in s, out Separation passed) is var at && at <= h;
            BallState before = s;
            Advance(ref s, passes ? at : h, in v, in v, in w, in free, ref run);
            if (passes)
            {
                _guard.Meet(ref s, in passed, ref run);
            }

            // Resolve overlaps with moving objects at a limited speed, and with stationary ones at once. This displacement may enter nets and goals.
            // At a passage, moving objects wait for the next part: the ball must not be pushed back across the line that it has just crossed.
            Vector3d moved = s.Position;
            ContactSet.PushOut(_world, ref s, set, passes ? 0 : ContactSet.OutOfTheWay * h);
            ContactSet.StayOut(_world, ref s, before.Position);
            _guard.Follow(ref s, in moved, ref run);
            Halt(ref s, set, before.Position, h * free.Acceleration.Length);
            isFree = IsFree(in s, set);
            _shown.ShowStraight(in before, in s, set, ref run);
        }

        // End the squeeze if no mover pushed the ball in the last part, or if the ball has room. In a group, a step calls this method several times.
        if (run.Spent.Squeezes <= MostSqueezes && (isFree || HasRoom(in s)) && !run.Log.Halted)
        {
            _contact.EndSqueeze(ref s, ref run);
        }
    }

    /// <summary>Stops a ball that stationary contacts hold in place: removes any speed that the forces of a single part can cause, and the error of a
    /// set without a solution, at which the ball would creep.</summary>
    private void Halt(ref BallState s, scoped Span<Contact> set, Vector3d from, double gained)
    {
        double speed = s.Velocity.Length + (_around.Radius * s.SpinAxis.Length);
        if (speed > gained || (speed > ContactTolerances.PileHeld * gained && (s.Position - from).Length > ContactTolerances.Standstill) || SolvedSet.Drives(set))
        {
            return;
        }

        s.Velocity = Vector3d.Zero;
        s.SetGroundSpin(Vector3d.Zero);
    }

    /// <summary>True if no moving object overlaps the ball or presses it against another contact.</summary>
    private bool IsFree(in BallState s, Span<Contact> set)
    {
        bool pushed = false;
        bool overlaps = false;
        int pressing = 0;
        foreach (ref readonly Contact contact in set)
        {
            pressing += contact.Load > 0 ? 1 : 0;
            pushed |= contact.Load > 0 && contact.Moves;
            overlaps |= contact.Moves && _world.ByIndex[contact.Collider].At(s.Position, s.Time).Distance < _around.Radius - ContactTolerances.Touching;
        }

        return !overlaps && (!pushed || pressing < 2);
    }

    /// <summary>True if the ball overlaps no object and some direction leads off all contacts.</summary>
    [SkipLocalsInit]
    private bool HasRoom(in BallState s)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Near(_world, in s, ContactTolerances.Touching, room, _world.Room);
        foreach (ref Contact contact in set)
        {
            if (contact.Gap < -ContactTolerances.Touching)
            {
                return false;
            }

            contact.Velocity = Room * contact.Normal;
        }

        // The least velocity v with v·n ≥ Room at each contact, of normal n.
        Vector3d v = Vector3d.Zero;
        return SolvedSet.KeepOff(set, _world, 0, movers: true, ref v) && v.Length <= 1;
    }
}
