using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Follows a ball that is displaced out of an overlap: on that path it may enter nets and pass through goals.</summary>
internal sealed class Displacement
{
    /// <summary>Maximum number of passages on one path: more than can exist at one position.</summary>
    private const int MostPassages = 32;

    private readonly World _world;
    private readonly WorldGuard _guard;

    public Displacement(World world, WorldGuard guard)
    {
        _world = world;
        _guard = guard;
    }

    /// <summary>Handles all nets and goals on the straight path to the ball's position, in order.</summary>
    /// <param name="s">The ball, at its new position.</param>
    /// <param name="from">Its old position, m.</param>
    /// <param name="run">The step.</param>
    public void Follow(ref BallState s, in Vector3d from, ref StepRun run)
    {
        Vector3d to = s.Position;
        if (_world.Nets.Length + _world.Goals.Length == 0 || to == from)
        {
            return;
        }

        Vector3d velocity = (to - from) / ContactTolerances.Displacement;
        double left = ContactTolerances.Displacement;
        s.Position = from;
        for (int i = 0; i < MostPassages; i++)
        {
            var path = PathCubic.Line(s.Position, in velocity, left);
            double at = new ContactSearch(_world, in path, s.Time).FirstPassage(in s, out Separation met);
            if (!(at <= left))
            {
                break;
            }

            // The event contains the position of the passage, and the time of the displacement.
            s.Position = path.At(at);
            left -= at;
            _guard.Meet(ref s, in met, ref run);
        }

        s.Position = to;
    }
}
