using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball that moving objects squeeze: they leave it no room, and it goes as far as it can in parts of a step.</summary>
internal sealed partial class ContactSetParts
{
    /// <summary>Rounds of the solver where the ball may have no room.</summary>
    private const int SqueezedRounds = 20;

    /// <summary>Out of what squeezes it a ball is put by no more than this, m/s.</summary>
    private const double OutOfTheWay = 5.0;

    /// <summary>From here on, m, the path that is shown of a squeezed ball runs along what stands still.</summary>
    private const double AllButTouching = 1e-4;

    /// <summary>A way off all contacts goes off each by at least this share.</summary>
    private const double Room = 0.1;

    /// <summary>
    /// Takes what is left of a step for a ball that is squeezed: what stands still is never entered, what moves pushes the ball as far as it can go at the speed
    /// that it may have, and nothing bounces. When nothing that moves presses it against anything any more, or there is a way off all that does, it is free.
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

            // What the forces alone would make of it: v + h a, ω + h ω̇.
            var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
            MotionRates free = Free(in s, s.Time, in from, h);
            Vector3d v = from.Velocity + (h * free.Acceleration);
            Vector3d w = from.Spin + (h * free.SpinAcceleration);
            run.Log.Evaluations++;

            // As fast as it is, with what the forces give it on its way, or as what presses it: how it came is over.
            double came = from.Velocity.Length;
            s.SqueezeSpeed = came;
            // All that it may come to in this part: by itself, at twice the speed of what hits it, which comes too, and by being put out of that.
            double reach = ContactSearch.Touching + (h * (v.Length + (3.0 * _world.FastestMover) + OutOfTheWay));
            Span<Contact> set = ContactSet.Near(_world, in s, reach, room, _more);

            // Contact impulses as far as a few rounds find them: without room there need be no answer.
            ContactSolver.Try(set, _world.Ball, h, ref v, ref w);
            LeaveOut(ref set, run.Log);

            // Out of the way of what moves whatever friction does, as fast as it may be; and never into what stands still.
            KeepOff(set, h, movers: true, ref v);
            _contact.IsTooFast(ref s, set, in v);
            Vector3d kept = v;
            KeepOff(set, h, movers: false, ref kept);

            // f² = |v|² + 2 h f W·d: what the forces W do on the way d at the speed f that it comes to.
            double worked = h * Vector3d.Dot(Working(in free, in from), in kept) / Math.Max(kept.Length, Still);
            double fastest = Math.Max(s.SqueezeSpeed, worked + Math.Sqrt((worked * worked) + (came * came)));

            // Cut to that speed; what stands still has the last word.
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

            // Depenetration: out of what moves at a bounded speed, out of what stands still at once. Nets and goals are met on that way too.
            Vector3d moved = s.Position;
            PushOut(ref s, set, OutOfTheWay * h, before.Position);
            _displacement.Follow(ref s, in moved, ref run);
            isFree = IsFree(in s, set);
            ShowSqueezed(in before, in s, set, ref run);
        }

        // Free where no mover pressed it against anything in the last part, or where a direction leads off all that it touches.
        if ((isFree || HasRoom(in s)) && !run.Log.Halted)
        {
            _contact.EndSqueeze(ref s, ref run);
        }
    }

    /// <summary>
    /// Shows a piece of a squeezed ball, which goes from place to place: straight on, but along what stands still where the straight way would lead through that, as it does
    /// from one place of a post to the next.
    /// </summary>
    private void ShowSqueezed(in BallState before, in BallState after, scoped Span<Contact> set, ref StepRun run)
    {
        double h = after.Time - before.Time;
        if (run.Log.Observer is null || !(h > 0))
        {
            return;
        }

        Vector3d way = (after.Position - before.Position) / h;
        Vector3d v = way;
        Vector3d w = way;

        // Tangents of a Hermite path: none at its start that leads into what stands still, none at its end that comes out of it.
        foreach (ref readonly Contact contact in set)
        {
            if (!contact.Moves)
            {
                Collider collider = _world.Colliders[contact.Collider];
                v -= Math.Min(0, OffAt(collider, before.Position, before.Time, in v, out Vector3d n)) * n;
                w -= Math.Max(0, OffAt(collider, after.Position, after.Time, in w, out n)) * n;
            }
        }

        Show(in before, in after, in v, in w, ref run);
    }

    /// <summary>How fast a way leads off a thing where the ball all but touches it, m/s; 0 where it does not.</summary>
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

    /// <summary>Takes from a velocity what goes into things that stand still, and into what moves.</summary>
    private static void KeepOff(Span<Contact> set, double h, bool movers, ref Vector3d v)
    {
        bool closes = true;
        for (int round = 0; round < SqueezedRounds && closes; round++)
        {
            closes = false;
            foreach (ref readonly Contact contact in set)
            {
                // (v − V)·n + gap/h < 0 would overlap within the part: projected out, contact by contact, until none does.
                double closing = Vector3d.Dot(v - contact.Velocity, in contact.Normal) + (h > 0 ? Math.Max(0, contact.Gap) / h : 0);
                if ((movers || !contact.Moves) && closing < 0)
                {
                    v -= closing * contact.Normal;
                    closes = true;
                }
            }
        }
    }

    /// <summary>True when nothing that moves presses the ball against anything, or overlaps it.</summary>
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

    /// <summary>True when there is a way off all that the ball touches, and it overlaps nothing: d · n > 0 for all of them.</summary>
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

            // Perceptron: towards the normal of the one that it goes off least.
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

    /// <summary>Puts a squeezed ball out of what moves, by no more than a distance, and then out of what stands still: where there is no such place, back.</summary>
    private void PushOut(ref BallState s, Span<Contact> set, double most, in Vector3d back)
    {
        Vector3d from = s.Position;
        foreach (ref readonly Contact contact in set)
        {
            ShapePoint at = _world.Colliders[contact.Collider].At(s.Position, s.Time);
            double gap = at.Distance - _around.Radius;
            s.Position += contact.Moves && gap < 0 ? Math.Min(most, -gap) * at.Normal : Vector3d.Zero;
        }

        // All of them together put it out no faster than one: the set knows what stands still no farther off.
        Vector3d pushed = s.Position - from;
        double length = pushed.Length;
        s.Position = length > most ? from + (most / length * pushed) : s.Position;

        // No place clear of what stands still: back to where it was, without speed.
        if (!ContactSet.KeepOut(_world, ref s, set) || IsInside(in s))
        {
            s.Position = back;
            s.Velocity = Vector3d.Zero;
        }
    }
}
