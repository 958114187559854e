using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>The motions of the bodies and movable obstacles in a look-ahead in parts, which the game's own motions replace between the parts.</summary>
internal sealed class LookAheadMotions
{
    private readonly World _world;
    private readonly MotionSnapshot _start;
    private readonly MotionSnapshot _now;

    /// <exception cref="ArgumentOutOfRangeException">The scene has engine colliders.</exception>
    public LookAheadMotions(World world)
    {
        if (world.Engine is not null)
        {
            throw Check.Conflict("scene.engineColliders", "scene.engineColliders is set, but engine colliders move between the parts of a look-ahead. Use LookAhead, which runs in one go.");
        }

        _world = world;
        _start = new MotionSnapshot(world, world.Movers);
        _now = new MotionSnapshot(world, world.Movers);
    }

    /// <summary>Saves the current motions as those of the start.</summary>
    public void Start()
    {
        _start.Save();
        _now.Save();
    }

    /// <summary>Returns to the motions of the start.</summary>
    public void Restart() => Array.Copy(_start.All, _now.All, _now.All.Length);

    /// <summary>Replaces the game's motions by those of the look-ahead.</summary>
    public void Enter()
    {
        if (_now.All.Length > 0)
        {
            _world.KeepMotions();
            _now.PutBack();
        }
    }

    /// <summary>Restores the game's motions.</summary>
    public void Leave()
    {
        if (_now.All.Length > 0)
        {
            _now.Save();
            _world.PutMotionsBack();
        }
    }

    /// <summary>Moves the bodies to the start time, because the game may have set them to another time.</summary>
    public void MoveTo(in BallState start, Simulator.StepCallback? move)
    {
        if (move is null)
        {
            return;
        }

        Enter();
        try
        {
            move(in start);
        }
        finally
        {
            Leave();
        }
    }
}
