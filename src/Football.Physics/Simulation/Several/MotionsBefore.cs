using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>The motions of all pushed objects before a step.</summary>
/// <remarks>The first push reads them, so a step without pushes has no cost.</remarks>
/// <param name="world">The world.</param>
internal sealed class MotionsBefore(World world)
{
    private readonly RigidMotion[] _motions = new RigidMotion[world.GivesWay ? world.Movers : 0];
    private bool _isRead;

    /// <summary>The motions, once they are read.</summary>
    public RigidMotion[] All => _motions;

    /// <summary>Starts a step, before any push.</summary>
    public void Begin()
    {
        _isRead = false;
        world.Engine?.BeginPushes();
    }

    /// <summary>Reads the motions before the first push.</summary>
    public void Read()
    {
        if (!_isRead && _motions.Length > 0)
        {
            world.ReadMotions(_motions);
        }

        _isRead = true;
    }

    /// <summary>Restores the motions of all objects before the step.</summary>
    public void PutBack()
    {
        world.Engine?.PutPushesBack(EnginePushes.OfStep);
        if (_isRead && _motions.Length > 0)
        {
            world.WriteMotions(_motions);
        }
    }
}
