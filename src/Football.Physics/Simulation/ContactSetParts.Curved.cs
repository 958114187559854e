using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>A ball on curved surfaces, in parts of a step: the parts are short where a normal turns, and the path that observers see stays outside what stands still.</summary>
internal sealed partial class ContactSetParts
{
    /// <summary>A normal turns by no more than this in a part, rad ...</summary>
    private const double LargestTurn = 0.1;

    /// <summary>... as long as a step has had fewer parts that were shortened for that.</summary>
    private const int MostTurns = 64;

    /// <summary>A shown path is no deeper in what stands still than this, m.</summary>
    private const double Entered = 1e-7;

    /// <summary>A piece of the path is halved so often at most.</summary>
    private const int MostHalved = 8;

    /// <summary>Where in a piece its depth is measured: at so many equal parts of it.</summary>
    private const int Samples = 4;

    /// <summary>Shortens a part in which a normal would turn too far: the straight way of a part leads off a curved surface.</summary>
    /// <returns>True if it has shortened the part.</returns>
    [SkipLocalsInit]
    private bool ShortenForTurning(in BallState s, scoped Span<Contact> set, ref StepRun run, ref double h)
    {
        if (run.Turns >= MostTurns)
        {
            return false;
        }

        double turning = 0;
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        foreach (ref readonly Contact contact in set)
        {
            if (!contact.IsFlat)
            {
                Collider collider = _world.Colliders[contact.Collider];
                ShapePoint at = collider.At(s.Position, s.Time);
                Unsafe.SkipInit(out SurfaceForces on);
                SurfaceSystem.Describe(collider, _around.Radius, in at, s.Time, in from, ref on);
                turning = Math.Max(turning, on.Turning.Length);
            }
        }

        // If the parts that remain cannot cover the rest of the step with turns so small, they are longer.
        double longest = Math.Max(LargestTurn, turning * (run.Left / (MostTurns - run.Turns)));
        bool shortens = turning * h > longest;
        h = shortens ? longest / turning : h;
        return shortens;
    }

    /// <summary>
    /// Shows a piece to the observer, if there is one: from place to place with the velocities at its ends. Between two places on a curved surface that path may enter
    /// it. Then the observer gets the piece in parts, between which the ball is on the surface.
    /// </summary>
    private void Show(in BallState before, in BallState after, in Vector3d v, in Vector3d w, scoped Span<Contact> set, ref StepRun run)
    {
        if (!run.Log.IsWatched || !(after.Time > before.Time))
        {
            return;
        }

        BallState start = before;
        BallState end = after;
        start.Velocity = v;
        end.Velocity = w;
        bool halted = run.Log.Halted;
        run.Log.Halted = false;
        ShowOutside(in start, in end, set, run.Log, MostHalved);
        run.Log.Halted |= halted;
    }

    private void ShowOutside(in BallState start, in BallState end, scoped Span<Contact> set, StepLog log, int halves)
    {
        double h = end.Time - start.Time;
        double half = 0.5 * h;
        var path = PathCubic.Between(start.Position, start.Velocity, end.Position, end.Velocity, h);
        if (halves == 0 || !(half > 0) || !Enters(in path, set, start.Time))
        {
            Vector3d acceleration = (end.Velocity - start.Velocity) / h;
            log.Show(in start, in end, in acceleration, in acceleration, 4);
            return;
        }

        BallState middle = start;
        middle.Time = start.Time + half;
        middle.Position = path.At(half);
        middle.Velocity = path.VelocityAt(half);
        middle.SpinAxis = 0.5 * (start.Spin + end.Spin);
        middle.BaseOrientation = start.BaseOrientation.Turned((0.5 * half) * (start.Spin + middle.SpinAxis));
        middle.AirDistance = 0.5 * (start.AirDistance + end.AirDistance);
        ContactSet.KeepOut(_world, ref middle, set);
        foreach (ref readonly Contact contact in set)
        {
            // Where the ball is on a surface the path is along it.
            ShapePoint at = _world.Colliders[contact.Collider].At(middle.Position, middle.Time);
            bool touches = !contact.Moves && at.Distance - _around.Radius <= ContactSearch.Touching;
            middle.Velocity -= touches ? Vector3d.Dot(middle.Velocity, at.Normal) * at.Normal : Vector3d.Zero;
        }

        // Put out of a surface, it goes round that: so far, in the same time.
        double speed = middle.Velocity.Length;
        double round = ((middle.Position - start.Position).Length + (end.Position - middle.Position).Length) / h;
        middle.Velocity = speed > 0 ? round / speed * middle.Velocity : middle.Velocity;

        ShowOutside(in start, in middle, set, log, halves - 1);
        if (!log.Halted)
        {
            ShowOutside(in middle, in end, set, log, halves - 1);
        }
    }

    /// <summary>True if a path enters what stands still.</summary>
    private bool Enters(in PathCubic path, scoped Span<Contact> set, double time)
    {
        foreach (ref readonly Contact contact in set)
        {
            for (int i = 1; i < Samples && !contact.Moves; i++)
            {
                double t = path.Length * i / Samples;
                if (_world.Colliders[contact.Collider].At(path.At(t), time + t).Distance - _around.Radius < -Entered)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
