using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>The forces on a ball, for display.</content>
internal static unsafe partial class Exports
{
    /// <summary>Computes the forces with which the next step of a ball begins, for arrows and overlays. Nothing changes. It costs about as much as a step, and allocates.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball; unchanged. For a ball of a match, use fp_match_state first; bodies and other balls then do not count.</param>
    /// <param name="dt">The length of the next step, s; above 0, at most 1e12. It matters only for a ball that is about to stop.</param>
    /// <param name="out">Receives the forces.</param>
    /// <param name="contacts">Receives the forces of each contact; null to skip them. In flight there are none.</param>
    /// <param name="capacity">The number of contacts that fit, 0 or more.</param>
    /// <param name="count">Receives the number of contacts, including those that do not fit; null to skip it.</param>
    /// <returns>FP_OK; FP_BUFFER if contacts or count is given, and there are more contacts than capacity: the first ones are written. FP_ARGUMENT or FP_HANDLE, with nothing written.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_forces")]
    public static NativeStatus Forces([In] NativeScene* scene, [In] NativeState* state, double dt, NativeForcesResult* @out, NativeContactForce* contacts, int capacity, int* count)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            ref BallState ball = ref Guard.State(state, compiled);
            Guard.Given(@out, "out");
            Guard.Room(contacts, "contacts", capacity);
            BallForces? forces = compiled.Simulator.ForcesAt(in ball, dt);
            *@out = default;
            if (forces is not null)
            {
                Put(forces, @out);
            }

            IReadOnlyList<ContactForce> found = forces?.Contacts ?? [];
            for (int i = 0; i < Math.Min(capacity, found.Count); i++)
            {
                Put(found[i], contacts + i);
            }

            return contacts is null && count is null ? NativeStatus.Ok : Counted(found.Count, capacity, count, "contacts");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    private static void Put(BallForces from, NativeForcesResult* to)
    {
        Put(from.Weight, to->Weight);
        Put(from.Buoyancy, to->Buoyancy);
        Put(from.Drag, to->Drag);
        Put(from.Magnus, to->Magnus);
        Put(from.Knuckle, to->Knuckle);
        Put(from.Custom, to->Custom);
        Put(from.Nets, to->Nets);
        Put(from.Load, to->Load);
        Put(from.Friction, to->Friction);
        Put(from.Sum, to->Sum);
        Put(from.Acceleration, to->Acceleration);
        to->Determined = 1;
    }

    private static void Put(ContactForce from, NativeContactForce* to)
    {
        to->Thing = from.ColliderIndex;
        to->Reserved = 0;
        Put(from.Point, to->Point);
        Put(from.Normal, to->Normal);
        Put(from.Load, to->Load);
        Put(from.Friction, to->Friction);
    }
}
