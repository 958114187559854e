namespace FootballPhysics;

/// <summary>Motions of all that balls push: before and after a push, and as they are put back after a look at what would come.</summary>
/// <param name="world">All that can be met.</param>
internal sealed class PushedMotions(World world)
{
    private readonly RigidMotion[] _before = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private readonly RigidMotion[] _after = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private readonly RigidMotion[] _kept = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private RigidMotion[] _first = [];
    private int _next;

    /// <summary>Remembers how all moves before a push.</summary>
    public void ReadBefore()
    {
        Read(_before);
        world.Engine?.KeepPushes(EnginePushes.BeforePush);
    }

    /// <summary>Remembers how all moves after it, and puts it back to how it moved before.</summary>
    public void ReadAfter()
    {
        Read(_after);
        Restore(_before);
        world.Engine?.KeepPushes(EnginePushes.AfterPush);
        world.Engine?.PutPushesBack(EnginePushes.BeforePush);
    }

    /// <summary>Puts all to how it moves after the push.</summary>
    public void PutAfter()
    {
        Restore(_after);
        world.Engine?.PutPushesBack(EnginePushes.AfterPush);
    }

    /// <summary>Remembers how all moves before one only looks.</summary>
    public void Keep()
    {
        Read(_kept);
        world.Engine?.KeepPushes(EnginePushes.OfTry);
    }

    /// <summary>... and puts it back.</summary>
    public void PutBack()
    {
        world.Engine?.PutPushesBack(EnginePushes.OfTry);
        Restore(_kept);
    }

    /// <summary>Puts all to how it moved at some time.</summary>
    private void Restore(RigidMotion[] motions)
    {
        if (motions.Length > 0)
        {
            world.WriteMotions(motions);
        }
    }

    /// <summary>True when a ball may come to a place where something is that was pushed, or would have been.</summary>
    /// <param name="position">Where it is, m.</param>
    /// <param name="reach">How far it and its surface get, m.</param>
    /// <param name="time">When the push is, s.</param>
    /// <param name="end">Until when that counts, s.</param>
    public bool MayBeMet(in Vector3d position, double reach, double time, double end)
    {
        bool meets = world.Engine is not null;
        for (int m = 0; m < _before.Length && !meets; m++)
        {
            if (_before[m].Velocity != _after[m].Velocity)
            {
                // The volume swept until the end, with and without the push.
                Bounds3d box = world.BoundsOfMover(m, time, end - time);
                box = box.Union(box.Translated((end - time) * _before[m].Velocity)).Union(box.Translated((end - time) * _after[m].Velocity));
                meets = box.Expanded(reach).Intersects(new Bounds3d(position, position));
            }
        }

        return meets;
    }

    /// <summary>Begins to list the objects that were pushed in a step that has been taken.</summary>
    /// <param name="motions">The motions of all objects before the step.</param>
    public void BeginPushes(MotionsBefore motions)
    {
        _first = motions.All;
        _next = 0;
        Read(_after);
    }

    /// <summary>The next object that was pushed.</summary>
    /// <param name="time">The start of the step, s.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="box">A box around all positions of the object in the step, pushed and not pushed.</param>
    /// <returns>False after the last one.</returns>
    public bool NextPush(double time, double dt, out Bounds3d box)
    {
        for (; _next < _after.Length; _next++)
        {
            Vector3d change = _after[_next].Velocity - _first[_next].Velocity;
            if (change != Vector3d.Zero)
            {
                // Bound the position by the motion after the push, extended over the step. It is at most |ΔV| dt off; double that for
                // opposing pushes.
                Bounds3d at = world.BoundsOfMover(_next, time, dt);
                box = at.Union(at.Translated(dt * _after[_next].Velocity)).Expanded(2.0 * dt * change.Length);
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
