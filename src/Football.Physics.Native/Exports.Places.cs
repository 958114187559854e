using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Functions that place balls.</content>
internal static unsafe partial class Exports
{
    /// <summary>Places a ball: sets its position, velocity, spin and orientation, and keeps its time. Without velocity and spin it is at rest, or falls.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="position">Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000; null: zero.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000; null: zero.</param>
    /// <param name="orientation">A quaternion x, y, z, w of any length except 0; null: the identity.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_place")]
    public static NativeStatus Place(
        [In] NativeScene* scene, NativeState* state, [In][CArray(3)] double* position, [In][CArray(3)] double* velocity, [In][CArray(3)] double* spin, [In][CArray(4)] double* orientation)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            ref BallState ball = ref Guard.State(state, compiled);
            var place = new PlaceInput(0, 0, 0, Guard.Vector(position, "position"), Guard.VectorOrZero(velocity), Guard.VectorOrZero(spin), Guard.RotationOrNull(orientation));
            place.Apply(compiled.Simulator, ref ball);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Moves a ball to a position at once, sets its velocity and spin to zero, and discards its kick and restart of the next step. A recording ends; fp_match_queue_place continues it.</summary>
    /// <param name="match">The match.</param>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <param name="position">Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_place")]
    public static NativeStatus MatchPlace(NativeMatch* match, int ball, [In][CArray(3)] double* position)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Plays();
                played.Runner.Place(Guard.Vector(position, "position"), ball);
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Restarts a ball at the start of the next step, before its kick: sets its position, velocity, spin and orientation. The clock and a recording continue, and no kick is discarded. A second restart of this ball before the step replaces the first.</summary>
    /// <param name="match">The match.</param>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <param name="position">Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000; null: zero.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000; null: zero.</param>
    /// <param name="orientation">A quaternion x, y, z, w of any length except 0; null: the identity.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_queue_place")]
    public static NativeStatus MatchQueuePlace(
        NativeMatch* match, int ball, [In][CArray(3)] double* position, [In][CArray(3)] double* velocity, [In][CArray(3)] double* spin, [In][CArray(4)] double* orientation)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Plays();
                played.Runner.QueuePlace(Guard.Vector(position, "position"), Guard.VectorOrZero(velocity), Guard.VectorOrZero(spin), Guard.RotationOrNull(orientation), ball);
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }
}
