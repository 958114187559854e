using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Builds the path reported to observers for a ball on several surfaces, so that it never enters stationary objects.</summary>
internal sealed class ShownPath(World world)
{
    /// <summary>Maximum number of times a piece of the path is halved.</summary>
    private const int MostHalved = 8;

    /// <summary>Number of equal parts at whose ends the depth of a piece is measured.</summary>
    private const int Samples = 16;

    /// <summary>Reports a piece to the observer, if there is one, with the positions and velocities at its ends.</summary>
    /// <remarks>
    /// Between two positions on a curved surface, a path may enter the surface. It is then reported in parts, with the ball on the
    /// surface between them.
    /// </remarks>
    public void Show(in BallState before, in BallState after, in Vector3d v, in Vector3d w, scoped Span<Contact> set, ref StepRun run)
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

    /// <summary>Reports a piece of a squeezed ball to the observer: a straight path, bent next to stationary surfaces so that it does not enter them.</summary>
    public void ShowStraight(in BallState before, in BallState after, scoped Span<Contact> set, ref StepRun run)
    {
        double h = after.Time - before.Time;
        if (!run.Log.IsWatched || !(h > 0))
        {
            return;
        }

        Vector3d v = (after.Position - before.Position) / h;
        Vector3d w = v;

        // Tangents of a Hermite path: the first must not lead into a stationary surface, and the last must not come out of one.
        foreach (ref readonly Contact contact in set)
        {
            if (!contact.Moves)
            {
                Collider collider = world.ByIndex[contact.Collider];
                v -= Math.Min(0, OffAt(collider, before.Position, before.Time, in v, out Vector3d n)) * n;
                w -= Math.Max(0, OffAt(collider, after.Position, after.Time, in w, out n)) * n;
            }
        }

        Show(in before, in after, in v, in w, set, ref run);
    }

    /// <summary>Returns the speed at which a path leaves a collider that the ball almost touches, m/s; 0 if it does not touch it.</summary>
    private double OffAt(Collider collider, in Vector3d position, double time, in Vector3d velocity, out Vector3d normal)
    {
        ShapePoint at = collider.At(in position, time);
        normal = at.Normal;
        return at.Distance - world.Ball.Radius <= ContactTolerances.ShownContact ? Vector3d.Dot(in velocity, in normal) : 0;
    }

    private void ShowOutside(in BallState start, in BallState end, scoped Span<Contact> set, StepLog log, int halves)
    {
        double h = end.Time - start.Time;
        double half = 0.5 * h;
        var path = PathCubic.Between(start.Position, start.Velocity, end.Position, end.Velocity, h);
        if (halves == 0 || !(half > 0) || !Enters(in path, set, start.Time))
        {
            // With the accelerations of the cubic, the observer's interpolant equals the cubic that was checked.
            log.Show(in start, in end, path.AccelerationAt(0), path.AccelerationAt(h), 4);
            return;
        }

        BallState middle = start;
        middle.Time = start.Time + half;
        middle.Position = path.At(half);
        middle.Velocity = path.VelocityAt(half);
        middle.SpinAxis = 0.5 * (start.Spin + end.Spin);
        middle.BaseOrientation = start.BaseOrientation.Turned((0.5 * half) * (start.Spin + middle.SpinAxis));
        middle.AirDistance = 0.5 * (start.AirDistance + end.AirDistance);
        ContactSet.KeepOut(world, ref middle, set);
        foreach (ref readonly Contact contact in set)
        {
            // On a surface, keep only the tangential velocity.
            ShapePoint at = world.ByIndex[contact.Collider].At(middle.Position, middle.Time);
            bool touches = !contact.Moves && at.Distance - world.Ball.Radius <= ContactTolerances.Touching;
            middle.Velocity -= touches ? Vector3d.Dot(middle.Velocity, at.Normal) * at.Normal : Vector3d.Zero;
        }

        // The path around the surface is longer, so scale the speed to cover it in the same time.
        double speed = middle.Velocity.Length;
        double round = ((middle.Position - start.Position).Length + (end.Position - middle.Position).Length) / h;
        middle.Velocity = speed > 0 ? round / speed * middle.Velocity : middle.Velocity;

        ShowOutside(in start, in middle, set, log, halves - 1);
        if (!log.Halted)
        {
            ShowOutside(in middle, in end, set, log, halves - 1);
        }
    }

    /// <summary>True if a path enters a stationary object.</summary>
    private bool Enters(in PathCubic path, scoped Span<Contact> set, double time)
    {
        foreach (ref readonly Contact contact in set)
        {
            for (int i = 1; i < Samples && !contact.Moves; i++)
            {
                double t = path.Length * i / Samples;
                if (world.ByIndex[contact.Collider].At(path.At(t), time + t).Distance - world.Ball.Radius < -ContactTolerances.ShownDepth)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
