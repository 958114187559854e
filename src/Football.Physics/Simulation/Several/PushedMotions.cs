using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>The motions of all objects that balls push: before and after a push, and saved during a look-ahead.</summary>
/// <param name="world">The world.</param>
internal sealed class PushedMotions(World world)
{
    private readonly MotionSnapshot _before = MotionSnapshot.OfPushed(world);
    private readonly MotionSnapshot _after = MotionSnapshot.OfPushed(world);
    private readonly MotionSnapshot _kept = MotionSnapshot.OfPushed(world);
    private readonly Bounds3d[] _boxes = new Bounds3d[world.GivesWay ? world.Movers : 0];
    private RigidMotion[] _first = [];
    private int _next;

    /// <summary>Saves all motions before a push.</summary>
    public void ReadBefore() => _before.Save();

    /// <summary>Saves all motions after a push, and restores those before it.</summary>
    public void ReadAfter()
    {
        _after.Save();
        _before.PutBack();
    }

    /// <summary>Restores all motions after the push.</summary>
    public void PutAfter() => _after.PutBack();

    /// <summary>Saves all motions before a trial.</summary>
    public void Keep() => _kept.Save();

    /// <summary>Restores the motions before the trial.</summary>
    public void PutBack() => _kept.PutBack();

    /// <summary>True if a ball may reach an object whose motion the push changes.</summary>
    /// <param name="position">Position of the ball, m.</param>
    /// <param name="reach">Maximum distance that the ball and its surface reach, m.</param>
    /// <param name="time">Time of the push, s.</param>
    /// <param name="end">End of the time considered, s.</param>
    public bool MayBeMet(in Vector3d position, double reach, double time, double end)
    {
        bool meets = world.Engine is not null;
        for (int m = 0; m < _boxes.Length && !meets; m++)
        {
            Vector3d before = _before.All[m].Velocity;
            Vector3d after = _after.All[m].Velocity;
            if (before != after)
            {
                // The volume that the object sweeps until the end, both with and without the push.
                Bounds3d box = world.BoundsOfMover(m, time, end - time);
                box = box.Union(box.Translated((end - time) * before)).Union(box.Translated((end - time) * after));
                meets = box.Expanded(reach).Intersects(new Bounds3d(position, position));
            }
        }

        return meets;
    }

    /// <summary>Starts the enumeration of the objects pushed in a finished step.</summary>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <param name="time">Start time of the step, s.</param>
    /// <param name="dt">Length of the step, s.</param>
    public void BeginPushes(MotionSnapshot motions, double time, double dt)
    {
        _first = motions.All;
        _next = 0;
        _after.Save();

        // The box of an object that rotates since an earlier time is larger before the push than after it.
        motions.PutBack();
        for (int m = 0; m < _boxes.Length; m++)
        {
            Bounds3d at = world.BoundsOfMover(m, time, dt);
            _boxes[m] = at.Union(at.Translated(dt * _first[m].Velocity));
        }

        _after.PutBack();
    }

    /// <summary>Returns the next pushed object.</summary>
    /// <param name="time">Start time of the step, s.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="box">A box around all positions of the object in the step, with and without the push.</param>
    /// <returns>False after the last one.</returns>
    public bool NextPush(double time, double dt, out Bounds3d box)
    {
        for (; _next < _boxes.Length; _next++)
        {
            Vector3d after = _after.All[_next].Velocity;
            Vector3d change = after - _first[_next].Velocity;
            if (change != Vector3d.Zero)
            {
                // Bound the position: extend the motion after the push over the entire step. The error is at most |ΔV| dt; double it for opposing
                // pushes.
                Bounds3d at = world.BoundsOfMover(_next, time, dt);
                box = at.Union(at.Translated(dt * after)).Expanded(2.0 * dt * change.Length).Union(_boxes[_next]);
                _next++;
                return true;
            }
        }

        int engine = _next++ - _boxes.Length;
        box = default;
        return world.Engine is { } colliders && colliders.Pushes.Has(engine, time, dt, out box);
    }
}
