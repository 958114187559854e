using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>The motions of all objects that balls push: before and after a push, and saved during a look-ahead.</summary>
/// <param name="world">The world.</param>
internal sealed class PushedMotions(World world)
{
    private readonly RigidMotion[] _before = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private readonly RigidMotion[] _after = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private readonly RigidMotion[] _kept = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private readonly Bounds3d[] _boxes = new Bounds3d[world.GivesWay ? world.Movers : 0];
    private RigidMotion[] _first = [];
    private int _next;

    /// <summary>Saves all motions before a push.</summary>
    public void ReadBefore()
    {
        Read(_before);
        world.Engine?.KeepPushes(EnginePushes.BeforePush);
    }

    /// <summary>Saves all motions after a push, and restores those before it.</summary>
    public void ReadAfter()
    {
        Read(_after);
        Restore(_before);
        world.Engine?.KeepPushes(EnginePushes.AfterPush);
        world.Engine?.PutPushesBack(EnginePushes.BeforePush);
    }

    /// <summary>Restores all motions after the push.</summary>
    public void PutAfter()
    {
        Restore(_after);
        world.Engine?.PutPushesBack(EnginePushes.AfterPush);
    }

    /// <summary>Saves all motions before a trial.</summary>
    public void Keep()
    {
        Read(_kept);
        world.Engine?.KeepPushes(EnginePushes.OfTry);
    }

    /// <summary>Restores the motions before the trial.</summary>
    public void PutBack()
    {
        world.Engine?.PutPushesBack(EnginePushes.OfTry);
        Restore(_kept);
    }

    /// <summary>Restores saved motions.</summary>
    private void Restore(RigidMotion[] motions)
    {
        if (motions.Length > 0)
        {
            world.WriteMotions(motions);
        }
    }

    /// <summary>True if a ball may reach an object whose motion the push changes.</summary>
    /// <param name="position">Position of the ball, m.</param>
    /// <param name="reach">Maximum distance that the ball and its surface reach, m.</param>
    /// <param name="time">Time of the push, s.</param>
    /// <param name="end">End of the time considered, s.</param>
    public bool MayBeMet(in Vector3d position, double reach, double time, double end)
    {
        bool meets = world.Engine is not null;
        for (int m = 0; m < _before.Length && !meets; m++)
        {
            if (_before[m].Velocity != _after[m].Velocity)
            {
                // The volume that the object sweeps until the end, both with and without the push.
                Bounds3d box = world.BoundsOfMover(m, time, end - time);
                box = box.Union(box.Translated((end - time) * _before[m].Velocity)).Union(box.Translated((end - time) * _after[m].Velocity));
                meets = box.Expanded(reach).Intersects(new Bounds3d(position, position));
            }
        }

        return meets;
    }

    /// <summary>Starts the enumeration of the objects pushed in a finished step.</summary>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <param name="time">Start time of the step, s.</param>
    /// <param name="dt">Length of the step, s.</param>
    public void BeginPushes(MotionsBefore motions, double time, double dt)
    {
        _first = motions.All;
        _next = 0;
        Read(_after);

        // The box of an object that rotates since an earlier time is larger before the push than after it.
        Restore(_first);
        for (int m = 0; m < _boxes.Length; m++)
        {
            Bounds3d at = world.BoundsOfMover(m, time, dt);
            _boxes[m] = at.Union(at.Translated(dt * _first[m].Velocity));
        }

        Restore(_after);
    }

    /// <summary>Returns the next pushed object.</summary>
    /// <param name="time">Start time of the step, s.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="box">A box around all positions of the object in the step, with and without the push.</param>
    /// <returns>False after the last one.</returns>
    public bool NextPush(double time, double dt, out Bounds3d box)
    {
        for (; _next < _after.Length; _next++)
        {
            Vector3d change = _after[_next].Velocity - _first[_next].Velocity;
            if (change != Vector3d.Zero)
            {
                // Bound the position: extend the motion after the push over the entire step. The error is at most |ΔV| dt; double it for opposing
                // pushes.
                Bounds3d at = world.BoundsOfMover(_next, time, dt);
                box = at.Union(at.Translated(dt * _after[_next].Velocity)).Expanded(2.0 * dt * change.Length).Union(_boxes[_next]);
                _next++;
                return true;
            }
        }

        int engine = _next++ - _after.Length;
        box = default;
        return world.Engine is { } colliders && colliders.Pushes.Has(engine, time, dt, out box);
    }

    private void Read(RigidMotion[] into)
    {
        if (into.Length > 0)
        {
            world.ReadMotions(into);
        }
    }
}
