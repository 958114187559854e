using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>What becomes of a ball, and which kick gets where.</content>
internal static unsafe partial class Exports
{
    /// <summary>Longest step of a look-ahead, s; the default of LookAheadRequest.</summary>
    private const double LongestStep = 0.08;

    /// <summary>How far a look-ahead may look, s: no ball moves so long.</summary>
    private const double FarthestAhead = 3600;

    /// <summary>Where a ball will be: the simulation itself on a copy. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball; unchanged.</param>
    /// <param name="seconds">How far to look, s; 0 ... 3600.</param>
    /// <param name="every">Time between rows, s; 1e-6 ... 3600. It is the step too, or a whole part of it, at most 0.08 s: at the game's own step the rows are the future to the bit.</param>
    /// <param name="path">Rows t, x, y, z, s since the launch and m: now, and every so often until seconds are over; a ball that rests has rows too.</param>
    /// <param name="rows">How many rows there is room for, 0 or more.</param>
    /// <param name="written">Where the number of rows goes that were written; null where it is not wanted.</param>
    /// <returns>FP_OK, FP_BUFFER where there are more rows, FP_ARGUMENT or FP_HANDLE.</returns>
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

            // As many as there are, though seconds be no whole number of times the distance of the rows, as doubles go.
            long all = (long)((seconds / every) + 1e-9) + 1;
            long told = Math.Min(all, rows);
            int parts = (int)Math.Ceiling(every / LongestStep);
            for (long row = 0; row < told; row++)
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
                *written = told;
            }

            return told == all
                ? NativeStatus.Ok
                : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"rows is {rows}; the look-ahead has {all}."));
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Finds a kick.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="requestJson">An object in UTF-8 with the members of a scenario's aim: from, target, speed, and those that may be left out.</param>
    /// <param name="bytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="velocity">Where the velocity of the kick goes, m/s: whatever the verdict, the best one found.</param>
    /// <param name="spin">Where its spin goes, rad/s, world frame.</param>
    /// <param name="miss">Where the distance goes by which that kick misses the target, m; null where it is not wanted.</param>
    /// <param name="aimStatus">Where the verdict goes, one of fp_aim_status; null where it is not wanted.</param>
    /// <returns>FP_OK, whatever the verdict; FP_SCENE where the text is refused, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_aim")]
    public static NativeStatus Aim([In] NativeScene* scene, [In] byte* requestJson, long bytes, [CArray(3)] double* velocity, [CArray(3)] double* spin, double* miss, int* aimStatus)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(velocity, "velocity");
            Guard.Given(spin, "spin");
            AimResult kick = Requests.Aim(compiled, Requests.Text(requestJson, bytes, "request_json"));
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

    /// <summary>Runs a ball to an event or a time, and finds how its place there changes with the launch: derivatives, by one run.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball; its motion now is the launch. It is then as after fp_run_many.</param>
    /// <param name="dt">Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last one is shortened.</param>
    /// <param name="seconds">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run, one of fp_stop.</param>
    /// <param name="out">Where the derivatives go.</param>
    /// <param name="ended">1 where the event ended the run, 0 where its time did; null where it is not wanted.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, and the ball is as it was.</returns>
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

    /// <summary>A matrix by rows.</summary>
    private static void Put(Matrix3d from, double* to)
    {
        Put(from.X, to);
        Put(from.Y, to + 3);
        Put(from.Z, to + 6);
    }
}
