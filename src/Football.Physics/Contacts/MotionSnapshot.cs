using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>The motions of the bodies, the obstacles with a mass and the pushed engine colliders at one moment.</summary>
/// <param name="world">The world.</param>
/// <param name="count">The number of bodies and obstacles: <see cref="World.Movers"/>, or 0 if nothing can change their motions.</param>
internal sealed class MotionSnapshot(World world, int count)
{
    private readonly List<(EngineCollider Collider, EnginePush Push)> _pushes = [];
    private bool _isSaved;

    /// <summary>Creates a snapshot of the objects that balls push.</summary>
    public static MotionSnapshot OfPushed(World world) => new(world, world.GivesWay ? world.Movers : 0);

    /// <summary>The motions of the bodies and the obstacles.</summary>
    public RigidMotion[] All { get; } = new RigidMotion[count];

    /// <summary>The pushes of the engine colliders.</summary>
    public IReadOnlyList<(EngineCollider Collider, EnginePush Push)> Pushes => _pushes;

    /// <summary>Starts a step, whose first push reads the motions, so that a step without pushes has no cost.</summary>
    public void Begin()
    {
        _isSaved = false;
        world.Engine?.BeginPushes();
    }

    /// <summary>Saves the motions, if they have not been saved in this step.</summary>
    public void Read()
    {
        if (!_isSaved)
        {
            Save();
        }
    }

    /// <summary>Saves the current motions.</summary>
    public void Save()
    {
        _isSaved = true;
        if (count > 0)
        {
            world.ReadMotions(All);
        }

        world.Engine?.Pushes.Read(_pushes);
    }

    /// <summary>Restores the saved motions.</summary>
    public void PutBack()
    {
        if (_isSaved && count > 0)
        {
            world.WriteMotions(All);
        }

        if (_isSaved)
        {
            world.Engine?.PutPushesBack(_pushes);
        }
    }
}
