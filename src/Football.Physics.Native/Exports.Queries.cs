using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Queries: the future path of a ball, and the kick that reaches a target.</content>
internal static unsafe partial class Exports
{
    /// <summary>The longest step of a look-ahead, s; the default of LookAheadRequest.</summary>
    private const double LongestStep = 0.08;

    /// <summary>The longest time of a look-ahead, s. No ball moves for longer.</summary>
    private const double FarthestAhead = 3600;

    /// <summary>Predicts the path of a ball: runs the simulation on a copy. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball; unchanged.</param>
    /// <param name="seconds">The length of the prediction, s; 0 ... 3600.</param>
    /// <param name="every">Time between rows, s; 1e-6 ... 3600. The step is every, divided by the smallest integer that makes it at most 0.08 s. If every is your game's step, the rows are bit-identical to its later steps.</param>
    /// <param name="path">Receives rows t, x, y, z, in s since the launch and m: the first now, the others every so many seconds. A ball at rest has rows too.</param>
    /// <param name="rows">The number of rows that fit, 0 or more.</param>
    /// <param name="written">Receives the number of rows written; null to skip it.</param>
    /// <returns>FP_OK, FP_BUFFER if there are more rows, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_look_ahead")]
    public static NativeStatus LookAhead([In] NativeScene* scene, [In] NativeState* state, double seconds, double every, double* path, long rows, long* written)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            BallState ball = Guard.State(state, compiled);
            Guard.Within(seconds, 0, FarthestAhead, "seconds");
            Guard.Within(every, 1e-6, FarthestAhead, "every");
            Guard.AtLeast(rows, 0, "rows");
            if (rows > 0)
            {
                Guard.Given(path, "path");
            }

            // 1e-9 absorbs the rounding error of the quotient if seconds is a multiple of every.
            long all = (long)((seconds / every) + 1e-9) + 1;
            long filled = Math.Min(all, rows);
            int parts = (int)Math.Ceiling(every / LongestStep);
            for (long row = 0; row < filled; row++)
            {
                StepLog log = ThreadMemory.Mine.ClearLog();
                for (int part = 0; row > 0 && part < parts; part++)
                {
                    compiled.Simulator.Step(ref ball, every / parts, log);
                }

                path[4 * row] = ball.Time;
                Put(ball.Position, path + (4 * row) + 1);
            }

            if (written is not null)
            {
                *written = filled;
            }

            return filled == all
                ? NativeStatus.Ok
                : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"rows is {rows}; the look-ahead has {all}."));
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Finds a kick that reaches a target.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="requestJson">An object in UTF-8 with the members of a scenario's aim: from, target, speed, and the optional ones.</param>
    /// <param name="bytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="velocity">Receives the velocity of the best kick found, m/s, whatever the verdict.</param>
    /// <param name="spin">Receives the spin of that kick, rad/s, world frame.</param>
    /// <param name="miss">Receives the distance by which that kick misses the target, m; null to skip it.</param>
    /// <param name="aimStatus">Receives the verdict, one of fp_aim_status; null to skip it. fp_aim_reason explains it.</param>
    /// <returns>FP_OK, whatever the verdict; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_aim")]
    public static NativeStatus Aim([In] NativeScene* scene, [In] byte* requestJson, long bytes, [CArray(3)] double* velocity, [CArray(3)] double* spin, double* miss, int* aimStatus)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(velocity, "velocity");
            Guard.Given(spin, "spin");
            AimResult kick = Requests.Aim(compiled, Requests.Text(requestJson, bytes, "request_json"));
            ThreadMemory.Mine.Aim = kick;
            Put(kick.Velocity, velocity);
            Put(kick.Spin, spin);
            if (miss is not null)
            {
                *miss = kick.Miss;
            }

            if (aimStatus is not null)
            {
                *aimStatus = (int)kick.Status;
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Returns the reason for the verdict of this thread's last fp_aim: the bound that excludes every kick, the undefined quantity, or the nearest miss. A failed fp_aim does not change it.</summary>
    /// <returns>a text in UTF-8, valid until the thread's next call of fp_aim_reason; "" after a hit, or if there was no fp_aim.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_aim_reason")]
    public static byte* AimReason()
    {
        try
        {
            return ThreadMemory.Mine.AimReason();
        }
        catch (OutOfMemoryException)
        {
            return s_noError;
        }
    }

    /// <summary>Runs a ball to an event or a time, and computes the derivatives of its final position with respect to the launch, in one run.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball. Its current motion is the launch. Receives the state at the end, as in fp_run_many.</param>
    /// <param name="dt">Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last step is shortened.</param>
    /// <param name="seconds">The maximum duration, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run, one of fp_stop.</param>
    /// <param name="out">Receives the derivatives.</param>
    /// <param name="ended">Receives 1 if the event ended the run, 0 if the time did; null to skip it.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with the ball unchanged.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_derivatives_run")]
    public static NativeStatus DerivativesRun([In] NativeScene* scene, NativeState* state, double dt, double seconds, int stopAt, NativeDerivatives* @out, int* ended)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            ref BallState ball = ref Guard.State(state, compiled);
            Guard.Given(@out, "out");
            LaunchDerivatives run = compiled.TakeDerivatives();
            bool byEvent = run.Run(ref ball, dt, seconds, (StopAt)stopAt);
            Put(run.PositionByVelocity, @out->PositionByVelocity);
            Put(run.PositionBySpin, @out->PositionBySpin);
            Put(run.VelocityByVelocity, @out->VelocityByVelocity);
            Put(run.VelocityBySpin, @out->VelocityBySpin);
            Put(run.TimeByVelocity, @out->TimeByVelocity);
            Put(run.TimeBySpin, @out->TimeBySpin);
            if (ended is not null)
            {
                *ended = byEvent ? 1 : 0;
            }

            compiled.GiveBack(run);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes a matrix row by row.</summary>
    private static void Put(Matrix3d from, double* to)
    {
        Put(from.X, to);
        Put(from.Y, to + 3);
        Put(from.Z, to + 6);
    }
}
