using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Filters: follow a ball through a stream of points.</content>
internal static unsafe partial class Exports
{
    /// <summary>Writes the default settings of a filter.</summary>
    /// <param name="settings">Receives the settings.</param>
    /// <returns>FP_OK, or FP_ARGUMENT.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_default")]
    public static NativeStatus FilterDefault(NativeFilterSettings* settings)
    {
        try
        {
            Guard.Given(settings, "settings");
            var defaults = new BallFilterSettings();
            *settings = new NativeFilterSettings
            {
                Noise = defaults.Noise,
                PixelNoise = defaults.PixelNoise,
                KickVelocity = defaults.KickVelocity,
                KickSpin = defaults.KickSpin,
                KicksPerSecond = defaults.KicksPerSecond,
                OutlierShare = defaults.OutlierShare,
                Window = defaults.Window,
                MaximumGap = defaults.MaximumGap,
            };
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Creates a filter that follows one ball.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="settings">The settings; null for the defaults.</param>
    /// <param name="filter">Receives the handle; null if the call fails. Free it with fp_filter_free.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_create")]
    public static NativeStatus FilterCreate([In] NativeScene* scene, [In] NativeFilterSettings* settings, NativeFilter** filter)
    {
        try
        {
            Guard.Given(filter, "filter");
            *filter = null;
            CompiledScene compiled = Guard.SceneOf(scene);
            BallFilterSettings given = settings is null ? new BallFilterSettings() : new BallFilterSettings
            {
                Noise = settings->Noise,
                PixelNoise = settings->PixelNoise,
                KickVelocity = settings->KickVelocity,
                KickSpin = settings->KickSpin,
                KicksPerSecond = settings->KicksPerSecond,
                OutlierShare = settings->OutlierShare,
                Window = settings->Window,
                MaximumGap = settings->MaximumGap,
            };
            nuint handle = Handles.Add(new FollowedBall(new BallFilter(compiled.Simulator.Scene, given)));
            *filter = (NativeFilter*)handle;
            return Guard.Made(handle);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Frees a filter.</summary>
    /// <param name="filter">The filter; null or a freed handle is rejected.</param>
    /// <returns>FP_OK, or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_free")]
    public static NativeStatus FilterFree(NativeFilter* filter)
    {
        try
        {
            Guard.FilterOf(filter);
            return Handles.Remove((nuint)filter) ? NativeStatus.Ok : Guard.Fail(NativeStatus.Handle, "filter was freed by another thread.");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Forgets all points.</summary>
    /// <param name="filter">The filter.</param>
    /// <returns>FP_OK, or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_reset")]
    public static NativeStatus FilterReset(NativeFilter* filter)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            lock (ball)
            {
                ball.Filter.Reset();
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Includes measured positions, and writes the estimate after each.</summary>
    /// <param name="filter">The filter.</param>
    /// <param name="times">n times, s, within 1e10.</param>
    /// <param name="positions">n rows x, y, z of the ball's centre, m; y is up. A row with y = NaN has no height; a row with x = NaN is a gap.</param>
    /// <param name="noise">n standard deviations of the coordinates, m; null for that of the settings.</param>
    /// <param name="n">The number of points, 0 ... 1 000 000.</param>
    /// <param name="estimates">Receives n estimates; null to skip them. A gap before the first point has zeros.</param>
    /// <returns>FP_OK; FP_ARGUMENT if a point is rejected (the points before it count), or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_update")]
    public static NativeStatus FilterUpdate(NativeFilter* filter, [In] double* times, [In] double* positions, [In] double* noise, long n, NativeEstimate* estimates)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            Guard.Within(n, 0, 1_000_000, "n");
            if (n > 0)
            {
                Guard.Given(times, "times");
                Guard.Given(positions, "positions");
            }

            lock (ball)
            {
                for (int i = 0; i < n; i++)
                {
                    Vector3d position = Row(positions, i);
                    double? deviation = noise is null ? null : noise[i];
                    if (!double.IsNaN(position.X) && double.IsNaN(position.Y))
                    {
                        ball.Filter.Update(times[i], position.X, position.Z, deviation);
                    }
                    else if (!double.IsNaN(position.X))
                    {
                        ball.Filter.Update(times[i], position, deviation);
                    }

                    if (estimates is not null)
                    {
                        Put(ball.Filter, estimates + i);
                    }
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Includes a pixel of a camera.</summary>
    /// <param name="filter">The filter.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="camera">The 3 x 4 matrix of the camera, row by row: (a, b, w) = matrix (x, y, z, 1), u = a/w, v = b/w; w is positive in front of the camera.</param>
    /// <param name="u">The pixel to the right.</param>
    /// <param name="v">The pixel downwards.</param>
    /// <param name="noise">The standard deviation of each coordinate, pixels; 0 for that of the settings.</param>
    /// <param name="estimate">Receives the estimate; null to skip it.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_update_pixel")]
    public static NativeStatus FilterUpdatePixel(NativeFilter* filter, double time, [In, CArray(12)] double* camera, double u, double v, double noise, NativeEstimate* estimate)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            Guard.Given(camera, "camera");
            double[] matrix = new ReadOnlySpan<double>(camera, 12).ToArray();
            lock (ball)
            {
                ball.Filter.Update(time, new TrackCamera(matrix), u, v, noise == 0 ? null : noise);
                if (estimate is not null)
                {
                    Put(ball.Filter, estimate);
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Predicts the path from the estimate, with its standard deviation.</summary>
    /// <param name="filter">The filter.</param>
    /// <param name="seconds">The duration, s; above 0, at most 60.</param>
    /// <param name="every">The interval of the rows, s; above 0.</param>
    /// <param name="path">Receives rows (t, x, y, z, deviation), the first at the last point; the deviation is that of a component, m.</param>
    /// <param name="rows">The number of rows that fit, 0 or more.</param>
    /// <param name="written">Receives the number of rows written; null to skip it.</param>
    /// <returns>FP_OK, FP_ARGUMENT (also before the first point) or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_look_ahead")]
    public static NativeStatus FilterLookAhead(NativeFilter* filter, double seconds, double every, double* path, long rows, long* written)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            Guard.Within(rows, 0, int.MaxValue, "rows");
            Guard.Room(path, "path", (int)rows);
            Guard.Within(every, 1e-6, Guard.LongestTime, "every");
            lock (ball)
            {
                ball.Filter.LookAhead(seconds, ball.Path);
                double from = ball.Path.StartTime;
                double end = ball.Path.EndTime;
                long count = Math.Min(rows, 1 + (long)Math.Floor((end - from) / every * (1 + 1e-12)));
                for (long i = 0; i < count; i++)
                {
                    double time = Math.Min(end, from + (i * every));
                    Vector3d position = ball.Path.PositionAt(time);
                    (path[5 * i], path[(5 * i) + 1], path[(5 * i) + 2], path[(5 * i) + 3]) = (time, position.X, position.Y, position.Z);
                    path[(5 * i) + 4] = ball.Filter.DeviationAt(time);
                }

                if (written is not null)
                {
                    *written = count;
                }
            }

            return NativeStatus.Ok;
        }
        catch (InvalidOperationException e)
        {
            return Guard.Fail(NativeStatus.Argument, e.Message);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Saves the whole filter as bytes.</summary>
    /// <param name="filter">The filter.</param>
    /// <param name="bytes">Receives the bytes; null if capacity is 0.</param>
    /// <param name="capacity">The number of bytes that fit, 0 or more.</param>
    /// <param name="count">Receives the number of bytes, even if they do not fit.</param>
    /// <returns>FP_OK, FP_BUFFER if capacity is too small (nothing is written), FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_save")]
    public static NativeStatus FilterSave([In] NativeFilter* filter, byte* bytes, long capacity, long* count)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            Guard.Within(capacity, 0, int.MaxValue, "capacity");
            Guard.Room(bytes, "bytes", (int)capacity);
            Guard.Given(count, "count");
            lock (ball)
            {
                *count = ball.Filter.SavedBytes;
                if (*count > capacity)
                {
                    return Guard.Fail(NativeStatus.Buffer, FormattableString.Invariant($"bytes has room for {capacity} bytes; the filter has {*count}."));
                }

                ball.Filter.Save(new Span<byte>(bytes, (int)*count));
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Restores a filter from the bytes of fp_filter_save. It then gives the same bits as the saved one.</summary>
    /// <param name="filter">A filter with the same scene and settings.</param>
    /// <param name="bytes">The bytes.</param>
    /// <param name="count">Their number.</param>
    /// <returns>FP_OK; FP_ARGUMENT if these are not the bytes of such a filter (nothing changes), or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_filter_restore")]
    public static NativeStatus FilterRestore(NativeFilter* filter, [In] byte* bytes, long count)
    {
        try
        {
            FollowedBall ball = Guard.FilterOf(filter);
            Guard.Given(bytes, "bytes");
            Guard.Within(count, 0, 1 << 30, "count");
            lock (ball)
            {
                ball.Filter.Restore(new ReadOnlySpan<byte>(bytes, (int)count));
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    private static void Put(BallFilter from, NativeEstimate* to)
    {
        *to = default;
        if (!from.HasEstimate)
        {
            return;
        }

        BallEstimate estimate = from.Estimate;
        to->Time = estimate.State.Time;
        Put(estimate.State.Position, to->Position);
        Put(estimate.State.Velocity, to->Velocity);
        Put(estimate.State.Spin, to->Spin);
        to->Deviations[0] = estimate.PositionDeviation;
        to->Deviations[1] = estimate.VelocityDeviation;
        to->Deviations[2] = estimate.SpinDeviation;
        for (int i = 0; i < BallEstimate.Components * BallEstimate.Components; i++)
        {
            to->Covariance[i] = estimate.Covariance(i / BallEstimate.Components, i % BallEstimate.Components);
        }

        to->KickTime = estimate.KickTime;
        to->KickDeviation = estimate.KickDeviation;
        to->KickProbability = estimate.KickProbability;
        to->Motion = (int)estimate.State.Motion;
        to->HasKick = estimate.HasKick ? 1 : 0;
        to->IsOutlier = estimate.IsOutlier ? 1 : 0;
        to->IsHeld = estimate.IsHeld ? 1 : 0;
    }
}
