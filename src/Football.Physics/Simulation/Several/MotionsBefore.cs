namespace FootballPhysics;

/// <summary>The motions, before a step, of all objects that balls push. They are read at the first push: a step without pushes does not pay for them.</summary>
/// <param name="world">All that can be met.</param>
internal sealed class MotionsBefore(World world)
{
    private readonly RigidMotion[] _motions = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private bool _isRead;

    /// <summary>The motions, once they are read.</summary>
    public RigidMotion[] All => _motions;

    /// <summary>A step begins, in which nothing is pushed yet.</summary>
    public void Begin()
    {
        _isRead = false;
        world.Engine?.KeepPushes(EnginePushes.OfStep);
    }

    /// <summary>Reads the motions, if nothing was pushed before.</summary>
    public void Read()
    {
        if (!_isRead && _motions.Length > 0)
        {
            world.ReadMotions(_motions);
        }

        _isRead = true;
    }

    /// <summary>Puts all objects back to their motions before the step.</summary>
    public void PutBack()
    {
        world.Engine?.PutPushesBack(EnginePushes.OfStep);
        if (_isRead && _motions.Length > 0)
        {
            world.WriteMotions(_motions);
        }
    }
}
