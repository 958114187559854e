using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Limits the parts of a step in which the normal of a curved surface turns.</summary>
internal static class TurningNormals
{
    /// <summary>Maximum rotation of a normal per part, rad.</summary>
    private const double LargestTurn = 0.1;

    /// <summary>Maximum number of parts per step that are shortened for this reason.</summary>
    private const int MostTurns = 64;

    /// <summary>Shortens a part in which a normal would turn too far, because the straight path of a part leaves a curved
    /// surface.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball at the start of the part.</param>
    /// <param name="set">The contacts.</param>
    /// <param name="run">The step.</param>
    /// <param name="h">Length of the part, s.</param>
    /// <returns>True if it shortened the part.</returns>
    [SkipLocalsInit]
    public static bool Shorten(World world, in BallState s, scoped Span<Contact> set, ref StepRun run, ref double h)
    {
        if (run.Spent.Turns >= MostTurns)
        {
            return false;
        }

        double turning = 0;
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        foreach (ref readonly Contact contact in set)
        {
            if (!contact.IsFlat)
            {
                Collider collider = world.ByIndex[contact.Collider];
                ShapePoint at = collider.At(s.Position, s.Time);
                Unsafe.SkipInit(out SurfaceForces on);
                SurfaceForces.Describe(collider, world.Ball.Radius, in at, s.Time, in from, ref on);
                turning = Math.Max(turning, on.Turning.Length);
            }
        }

        // At this rotation per part, the remaining parts cannot cover the rest of the step: allow longer parts.
        double longest = Math.Max(LargestTurn, turning * (run.Left / (MostTurns - run.Spent.Turns)));
        bool shortens = turning * h > longest;
        h = shortens ? longest / turning : h;
        return shortens;
    }
}
