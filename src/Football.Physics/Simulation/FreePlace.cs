using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Finds out whether the objects that close in on a ball leave it room at the end of a step.</summary>
/// <remarks>
/// A ball is squeezed if no position within the distance that the moving objects travel in a step is free of these objects at its end.
/// </remarks>
internal static class FreePlace
{
    /// <summary>Number of projections out of the objects, from each start.</summary>
    private const int MostRounds = 24;

    /// <summary>Number of directions across a normal from which the search starts, at half of the distance and at all of it.</summary>
    private const int Directions = 8;

    /// <summary>True if a ball has a free position at the end of the step.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball, which touches the objects.</param>
    /// <param name="velocity">Its velocity after the contact, m/s.</param>
    /// <param name="normal">The normal of the contact.</param>
    /// <param name="run">The step.</param>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static bool Exists(World world, in BallState s, in Vector3d velocity, in Vector3d normal, in StepRun run)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        double travel = 0;
        foreach (ref readonly Contact contact in ContactSet.Near(world, in s, ContactTolerances.Touching + (run.Length * world.FastestMover), room, world.Room))
        {
            double own = contact.Moves ? run.Length * contact.Velocity.Length : 0;
            travel = contact.Gap <= own ? Math.Max(travel, own) : travel;
        }

        // Only objects within this distance can close in on the ball. It keeps its velocity along all of them.
        Span<Contact> set = ContactSet.Near(world, in s, ContactTolerances.Touching + travel, room, world.Room);
        Vector3d along = velocity;
        for (int round = 0; round < set.Length; round++)
        {
            foreach (ref readonly Contact contact in set)
            {
                along -= Vector3d.Dot(in along, in contact.Normal) * contact.Normal;
            }
        }

        Vector3d centre = s.Position + (run.Left * along);
        bool exists = Leads(world, set, in centre, centre, travel, run.End);

        // Objects that close in from opposite sides leave room at most across their normals: search around the ball.
        Vector3d across = Vector3d.Cross(in normal, Math.Abs(normal.X) < 0.6 ? new Vector3d(1, 0, 0) : Vector3d.Up);
        for (int i = 0; i < Directions && !exists; i++)
        {
            // Turn by an eighth of a full turn.
            across += Vector3d.Cross(in normal, in across);
            across = travel / across.Length * across;
            exists = Leads(world, set, in centre, centre + (0.5 * across), travel, run.End) || Leads(world, set, in centre, centre + across, travel, run.End);
        }

        return exists;
    }

    /// <summary>True if projections lead from a start to a free position within a distance of the centre.</summary>
    private static bool Leads(World world, Span<Contact> set, in Vector3d centre, Vector3d place, double most, double time)
    {
        for (int round = 0; round < MostRounds; round++)
        {
            double deepest = ContactTolerances.Touching;
            foreach (ref readonly Contact contact in set)
            {
                ShapePoint at = world.ByIndex[contact.Collider].At(place, time);
                double depth = world.Ball.Radius - at.Distance;
                deepest = Math.Max(deepest, depth);
                place += Math.Max(0, depth) * at.Normal;
            }

            Vector3d off = place - centre;
            double far = off.Length;
            if (deepest <= ContactTolerances.Touching && far <= most + ContactTolerances.Touching)
            {
                return true;
            }

            place = far > most ? centre + (most / far * off) : place;
        }

        return false;
    }
}
