using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>A ball that moving objects squeeze: they leave it no room, and it goes as far as it can in parts of a step.</summary>
internal sealed partial class ContactSetParts
{
    /// <summary>Rounds of the solver where the ball may have no room.</summary>
    private const int SqueezedRounds = 20;

    /// <summary>A ball that was squeezed more often in a step stays squeezed up to the next one.</summary>
    private const int MostSqueezes = 1;

    /// <summary>The greatest speed at which an overlap with moving objects is resolved, m/s.</summary>
    private const double OutOfTheWay = 5.0;

    /// <summary>Below this gap, m, the displayed path of a squeezed ball follows a stationary surface.</summary>
    private const double AllButTouching = 1e-4;

    /// <summary>A direction that leaves all contacts has at least this component along each normal.</summary>
    private const double Room = 0.1;

    /// <summary>
    /// Takes the rest of a step for a squeezed ball. The ball never enters stationary objects. Moving objects push it as far as its allowed speed permits, and nothing
    /// bounces. The ball is free when no moving object presses it any longer, or when some direction leads off all contacts.
    /// </summary>
    [SkipLocalsInit]
    public void TakeSqueezed(ref BallState s, ref StepRun run)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        double part = LengthOfPart(in run, 2.0 * Part);
        bool isFree = false;
        while (run.Left > 0 && !run.Log.Halted)
        {
            double h = run.Left / Math.Max(1.0, Math.Round(run.Left / part));
            run.Parts++;

            // The velocity and spin under the forces alone: v + h a, ω + h ω̇.
            var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
            MotionRates free = Free(in s, s.Time, in from, h);
            Vector3d v = from.Velocity + (h * free.Acceleration);
            Vector3d w = from.Spin + (h * free.SpinAcceleration);
            run.Log.Evaluations++;

            // Its speed is bounded by its own speed plus the work of the forces, or by the speed of the objects that press it.
            double came = from.Velocity.Length;
            s.SqueezeSpeed = came;

            // The reach of this part: the ball's own path, the path of a mover and of a ball that it hits at twice its speed, and the resolved overlap.
            double reach = ContactSearch.Touching + (h * (v.Length + (3.0 * _world.FastestMover) + OutOfTheWay));
            Span<Contact> set = ContactSet.Near(_world, in s, reach, room, _more);

            // Contact impulses as far as a few rounds find them: without room there need be no answer.
            ContactSolver.Try(set, _world.Ball, h, ref v, ref w);
            LeaveOut(ref set, run.Log);

            // Friction must not hold the ball in the path of a moving object; and the ball must not enter a stationary one.
            KeepOff(set, h, movers: true, ref v);
            _contact.IsTooFast(ref s, set, in v);
            Vector3d kept = v;
            KeepOff(set, h, movers: false, ref kept);

            // f² = |v|² + 2 h f W·d: the work of the forces W along the direction d gives the speed f.
            double worked = h * Vector3d.Dot(Working(in free, in from), in kept) / Math.Max(kept.Length, Still);
            double fastest = Math.Max(s.SqueezeSpeed, worked + Math.Sqrt((worked * worked) + (came * came)));

            // The speed is cut to that. Stationary objects come last, so that the ball does not enter them.
            double speed = v.Length;
            v = speed > fastest ? fastest / speed * v : v;
            KeepOff(set, h, movers: false, ref v);

            var path = PathCubic.Line(s.Position, in v, h);
            bool passes = new ContactSearch(_world, in path, s.Time).FirstPassage(in s, out Separation passed) is var at && at <= h;
            BallState before = s;
            Move(ref s, passes ? at : h, in v, in v, in w, in free, ref run);
            if (passes)
            {
                _guard.Meet(ref s, in passed, ref run);
            }

            // Overlaps with moving objects end at a bounded speed, those with stationary objects at once. The ball meets nets and goals on that path too.
            Vector3d moved = s.Position;
            PushOut(ref s, set, OutOfTheWay * h, before.Position);
            _displacement.Follow(ref s, in moved, ref run);
            Halt(ref s, set, before.Position, h * free.Acceleration.Length);
            isFree = IsFree(in s, set);
            ShowSqueezed(in before, in s, set, ref run);
        }

        // It is free if no mover pressed it in the last part, or if some direction leads off all contacts. In a group, a step takes this several times.
        if (run.Squeezes <= MostSqueezes && (isFree || HasRoom(in s)) && !run.Log.Halted)
        {
            _contact.EndSqueeze(ref s, ref run);
        }
    }

    /// <summary>Stops a ball that stationary contacts hold in place: it keeps no speed that the forces of one part explain.</summary>
    private void Halt(ref BallState s, scoped Span<Contact> set, Vector3d from, double gained)
    {
        if ((s.Position - from).Length > Still || s.Velocity.Length + (_around.Radius * s.SpinAxis.Length) > gained)
        {
            return;
        }

        foreach (ref readonly Contact contact in set)
        {
            if (contact.Velocity != Vector3d.Zero)
            {
                return;
            }
        }

        s.Velocity = Vector3d.Zero;
        s.SetGroundSpin(Vector3d.Zero);
    }

    /// <summary>Shows a piece of a squeezed ball to the observer: a straight path, except next to stationary surfaces such as a post, which the path must not enter.</summary>
    private void ShowSqueezed(in BallState before, in BallState after, scoped Span<Contact> set, ref StepRun run)
    {
        double h = after.Time - before.Time;
        if (!run.Log.IsWatched || !(h > 0))
        {
            return;
        }

        Vector3d way = (after.Position - before.Position) / h;
        Vector3d v = way;
        Vector3d w = way;

        // Tangents of a Hermite path: the first must not lead into a stationary surface, the last must not come out of one.
        foreach (ref readonly Contact contact in set)
        {
            if (!contact.Moves)
            {
                Collider collider = _world.Colliders[contact.Collider];
                v -= Math.Min(0, OffAt(collider, before.Position, before.Time, in v, out Vector3d n)) * n;
                w -= Math.Max(0, OffAt(collider, after.Position, after.Time, in w, out n)) * n;
            }
        }

        _shown.Show(in before, in after, in v, in w, set, ref run);
    }

    /// <summary>The speed at which a path leaves a collider that the ball almost touches, m/s; 0 if it does not touch it.</summary>
    private double OffAt(Collider collider, in Vector3d place, double time, in Vector3d velocity, out Vector3d normal)
    {
        ShapePoint at = collider.At(place, time);
        normal = at.Normal;
        return at.Distance - _around.Radius <= AllButTouching ? Vector3d.Dot(in velocity, in normal) : 0;
    }

    /// <summary>A velocity for which no impulses were found: along all contacts, and no faster than before them.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="h">The time, s.</param>
    /// <param name="most">The speed without contacts, m/s.</param>
    /// <param name="v">The velocity, m/s.</param>
    public static void Settle(Span<Contact> set, double h, double most, ref Vector3d v)
    {
        double speed = v.Length;
        v = speed > most ? most / speed * v : v;
        KeepOff(set, h, movers: true, ref v);
    }

    /// <summary>Removes the closing components of a velocity at stationary contacts, and on request at moving ones.</summary>
    private static void KeepOff(Span<Contact> set, double h, bool movers, ref Vector3d v)
    {
        bool closes = true;
        for (int round = 0; round < SqueezedRounds && closes; round++)
        {
            closes = false;
            foreach (ref readonly Contact contact in set)
            {
                // With (v − V)·n + gap/h < 0 the ball would overlap the collider within the part. The excess is projected out, contact by contact.
                double closing = Vector3d.Dot(v - contact.Velocity, in contact.Normal) + (h > 0 ? Math.Max(0, contact.Gap) / h : 0);
                if ((movers || !contact.Moves) && closing < 0)
                {
                    v -= closing * contact.Normal;
                    closes = true;
                }
            }
        }
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
            overlaps |= contact.Moves && _world.Colliders[contact.Collider].At(s.Position, s.Time).Distance < _around.Radius - ContactSearch.Touching;
        }

        return !overlaps && (!pushed || pressing < 2);
    }

    /// <summary>True if the ball overlaps nothing and some direction d leads off all contacts: d·n > 0 for each.</summary>
    [SkipLocalsInit]
    private bool HasRoom(in BallState s)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Near(_world, in s, ContactSearch.Touching, room, _world.Room);
        Vector3d way = Vector3d.Zero;
        for (int round = 0; round < SqueezedRounds; round++)
        {
            int nearest = -1;
            double least = Room;
            for (int i = 0; i < set.Length; i++)
            {
                double off = Vector3d.Dot(in way, in set[i].Normal);
                if (set[i].Gap < -ContactSearch.Touching)
                {
                    return false;
                }

                nearest = off < least ? i : nearest;
                least = Math.Min(least, off);
            }

            if (nearest < 0)
            {
                return true;
            }

            // Perceptron: turn the direction towards the normal along which it leads off least.
            way += set[nearest].Normal;
            way = 1.0 / Math.Max(1.0, way.Length) * way;
        }

        return false;
    }

    /// <summary>True if the ball overlaps any object that stands still.</summary>
    private bool IsInside(in BallState s)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        foreach (ref readonly Contact contact in ContactSet.Near(_world, in s, 0, room, _world.Room))
        {
            if (!contact.Moves && contact.Gap < -ContactSearch.Touching)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Resolves overlaps of a squeezed ball: with moving objects up to a distance, then with stationary ones completely. If that is impossible, the ball goes back.</summary>
    private void PushOut(ref BallState s, Span<Contact> set, double most, in Vector3d back)
    {
        Vector3d from = s.Position;
        foreach (ref readonly Contact contact in set)
        {
            ShapePoint at = _world.Colliders[contact.Collider].At(s.Position, s.Time);
            double gap = at.Distance - _around.Radius;
            s.Position += contact.Moves && gap < 0 ? Math.Min(most, -gap) * at.Normal : Vector3d.Zero;
        }

        // All movers together displace the ball no farther than one may: beyond that distance the set does not contain the stationary surfaces.
        Vector3d pushed = s.Position - from;
        double length = pushed.Length;
        s.Position = length > most ? from + (most / length * pushed) : s.Position;

        // Every position near overlaps a stationary object: the ball returns to its old position, without speed.
        if (!ContactSet.KeepOut(_world, ref s, set) || IsInside(in s))
        {
            s.Position = back;
            s.Velocity = Vector3d.Zero;
        }
    }
}
