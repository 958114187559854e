namespace FootballPhysics;

/// <summary>
/// A ball that is pushed from place to place, by what it overlaps: it meets nets, and comes through goals, on that way too.
/// </summary>
internal sealed class Displacement
{
    /// <summary>A displacement takes no time; to be looked along, it takes this, s.</summary>
    public const double AtOnce = 1e-6;

    /// <summary>Passages on one way at most: more than there can be at one place.</summary>
    private const int MostPassages = 32;

    private readonly World _world;
    private readonly WorldGuard _guard;

    public Displacement(World world, WorldGuard guard)
    {
        _world = world;
        _guard = guard;
    }

    /// <summary>Takes all that the ball passes on the straight way to where it is, in order.</summary>
    /// <param name="s">The ball, where it was moved to.</param>
    /// <param name="from">Where it was before, m.</param>
    /// <param name="run">The step.</param>
    public void Follow(ref BallState s, in Vector3d from, ref StepRun run)
    {
        Vector3d to = s.Position;
        if (_world.Nets.Length + _world.Goals.Length == 0 || to == from)
        {
            return;
        }

        Vector3d velocity = (to - from) / AtOnce;
        double left = AtOnce;
        s.Position = from;
        for (int i = 0; i < MostPassages; i++)
        {
            var path = PathCubic.Line(s.Position, in velocity, left);
            double at = new ContactSearch(_world, in path, s.Time).FirstPassage(in s, out Separation met);
            if (!(at <= left))
            {
                break;
            }

            // It is told where the ball passes, at the time of the displacement.
            s.Position = path.At(at);
            left -= at;
            _guard.Meet(ref s, in met, ref run);
        }

        s.Position = to;
    }
}
