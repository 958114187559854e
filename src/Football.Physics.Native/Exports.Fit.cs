using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Fits of launches and scenes to the track of a camera.</content>
internal static unsafe partial class Exports
{
    /// <summary>Estimates the launch of a ball, and on request factors of the scene, from its tracked positions.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="times">n times, s, in order.</param>
    /// <param name="positions">n rows x, y, z of the ball's centre, m; y is up.</param>
    /// <param name="noise">n standard deviations of the coordinates, m; above 0; null for 0.02 m.</param>
    /// <param name="n">The number of points, 4 ... 1 000 000.</param>
    /// <param name="requestJson">An object in UTF-8 with the members of a scenario's fit, except noise: also, spin, spinDeviation, factorDeviation, timeStep; {} for none.</param>
    /// <param name="bytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="out">Receives the result.</param>
    /// <returns>FP_OK, whatever the verdict; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_fit")]
    public static NativeStatus Fit(
        [In] NativeScene* scene, [In] double* times, [In] double* positions, [In] double* noise, long n, [In] byte* requestJson, long bytes, NativeFitResult* @out) =>
        FindLaunch(scene, times, positions, noise, n, requestJson, bytes, @out, null);

    /// <summary>The same as fp_fit, with progress and cancellation.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="times">As for fp_fit, like all parameters up to out.</param>
    /// <param name="positions">n rows x, y, z, m.</param>
    /// <param name="noise">n standard deviations, m; null for 0.02 m.</param>
    /// <param name="n">The number of points.</param>
    /// <param name="requestJson">The request.</param>
    /// <param name="bytes">Its length in bytes.</param>
    /// <param name="out">Receives the result.</param>
    /// <param name="watch">Shows the progress, and cancels the call; null for neither.</param>
    /// <returns>As fp_fit; FP_CANCELLED if watch cancelled the call.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_fit_watched")]
    public static NativeStatus FitWatched(
        [In] NativeScene* scene,
        [In] double* times,
        [In] double* positions,
        [In] double* noise,
        long n,
        [In] byte* requestJson,
        long bytes,
        NativeFitResult* @out,
        NativeWatch* watch) => FindLaunch(scene, times, positions, noise, n, requestJson, bytes, @out, watch);

    private static NativeStatus FindLaunch(
        NativeScene* scene, double* times, double* positions, double* noise, long n, byte* requestJson, long bytes, NativeFitResult* @out, NativeWatch* watch)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@out, "out");
            TrackPoint[] track = Track(times, positions, noise, n);
            TrackFitRequest request = Requests.Fit(Requests.Text(requestJson, bytes, "request_json"));
            using var watched = Watch.Of(watch);
            Put(new TrackFit(compiled.Simulator.Scene).Find(track, request, watched, watched?.Token ?? default), request, @out);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Divides the track of a match into flights, impacts, touches and ground contact, and estimates the wind, the ball and the surface.</summary>
    /// <param name="scene">The scene, with the values known before the fit.</param>
    /// <param name="times">n times, s, in order.</param>
    /// <param name="positions">n rows x, y, z of the ball's centre, m; y is up.</param>
    /// <param name="noise">n minimum standard deviations of the coordinates, m; null for 0.02 m.</param>
    /// <param name="n">The number of points, 8 ... 1 000 000.</param>
    /// <param name="requestJson">
    /// An object in UTF-8: free, a list of the quantities to estimate (wind, drag, crisis, lift, surface, height; default wind, drag, surface, height);
    /// windDeviation, factorDeviation, crisisDeviation, spinDeviation; {} for the default.
    /// </param>
    /// <param name="bytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="pieces">Receives the pieces, in order of time; null if capacity is 0.</param>
    /// <param name="capacity">The number of pieces that fit, 0 or more.</param>
    /// <param name="count">Receives the number of pieces, including those that do not fit; null to skip it.</param>
    /// <param name="out">Receives the parameters; null to skip them.</param>
    /// <param name="fitted">Receives the handle of a new scene with the parameters. Free it with fp_scene_free. Null to skip it.</param>
    /// <returns>FP_OK; FP_BUFFER if there are more pieces than capacity (all other results are written); FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_fit_match")]
    public static NativeStatus FitMatch(
        [In] NativeScene* scene,
        [In] double* times,
        [In] double* positions,
        [In] double* noise,
        long n,
        [In] byte* requestJson,
        long bytes,
        NativePiece* pieces,
        int capacity,
        int* count,
        NativeFitMatchResult* @out,
        NativeScene** fitted) => FindMatch(scene, times, positions, noise, n, requestJson, bytes, pieces, capacity, count, @out, fitted, null);

    /// <summary>The same as fp_fit_match, with progress and cancellation.</summary>
    /// <param name="scene">The scene, with the values known before the fit.</param>
    /// <param name="times">As for fp_fit_match, like all parameters up to fitted.</param>
    /// <param name="positions">n rows x, y, z, m.</param>
    /// <param name="noise">n minimum standard deviations, m; null for 0.02 m.</param>
    /// <param name="n">The number of points.</param>
    /// <param name="requestJson">The request.</param>
    /// <param name="bytes">Its length in bytes.</param>
    /// <param name="pieces">Receives the pieces; null if capacity is 0.</param>
    /// <param name="capacity">The number of pieces that fit.</param>
    /// <param name="count">Receives the number of pieces; null to skip it.</param>
    /// <param name="out">Receives the parameters; null to skip them.</param>
    /// <param name="fitted">Receives the handle of a new scene; null to skip it.</param>
    /// <param name="watch">Shows the progress, and cancels the call; null for neither.</param>
    /// <returns>As fp_fit_match; FP_CANCELLED if watch cancelled the call, and fitted then receives null.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_fit_match_watched")]
    public static NativeStatus FitMatchWatched(
        [In] NativeScene* scene,
        [In] double* times,
        [In] double* positions,
        [In] double* noise,
        long n,
        [In] byte* requestJson,
        long bytes,
        NativePiece* pieces,
        int capacity,
        int* count,
        NativeFitMatchResult* @out,
        NativeScene** fitted,
        NativeWatch* watch) => FindMatch(scene, times, positions, noise, n, requestJson, bytes, pieces, capacity, count, @out, fitted, watch);

    private static NativeStatus FindMatch(
        NativeScene* scene,
        double* times,
        double* positions,
        double* noise,
        long n,
        byte* requestJson,
        long bytes,
        NativePiece* pieces,
        int capacity,
        int* count,
        NativeFitMatchResult* @out,
        NativeScene** fitted,
        NativeWatch* watch)
    {
        try
        {
            if (fitted is not null)
            {
                *fitted = null;
            }

            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Room(pieces, "pieces", capacity);
            TrackPoint[] track = Track(times, positions, noise, n);
            MatchFitRequest request = Requests.MatchFit(Requests.Text(requestJson, bytes, "request_json"));
            using var watched = Watch.Of(watch);
            MatchFitResult found = new MatchFit(compiled.Simulator.Scene).Find(track, request, watched, watched?.Token ?? default);
            if (fitted is not null)
            {
                nuint handle = Handles.Add(new CompiledScene(found.Scene, compiled.Simulator.Settings));
                *fitted = (NativeScene*)handle;
                if (handle == 0)
                {
                    return Guard.Made(handle);
                }
            }

            for (int i = 0; i < Math.Min(capacity, found.Pieces.Count); i++)
            {
                Put(found.Pieces[i], pieces + i);
            }

            if (@out is not null)
            {
                Put(found, @out);
            }

            return Counted(found.Pieces.Count, capacity, count, "pieces");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    private static TrackPoint[] Track(double* times, double* positions, double* noise, long n)
    {
        Guard.Within(n, 0, 1_000_000, "n");
        Guard.Given(times, "times");
        Guard.Given(positions, "positions");
        var track = new TrackPoint[n];
        for (int i = 0; i < track.Length; i++)
        {
            track[i] = noise is null ? new TrackPoint(times[i], Row(positions, i)) : new TrackPoint(times[i], Row(positions, i), noise[i]);
        }

        return track;
    }

    private static void Put(TrackFitResult from, TrackFitRequest request, NativeFitResult* to)
    {
        *to = default;
        to->Time = from.Time;
        Put(from.Position, to->Position);
        Put(from.Velocity, to->Velocity);
        Put(from.Spin, to->Spin);
        bool* estimated = stackalloc bool[4] { request.Drag, request.Lift, request.Restitution, request.Friction };
        int launch = 9;
        int index = launch;
        for (int i = 0; i < launch + 4; i++)
        {
            // The estimated factors follow the launch, in this order.
            bool isLaunch = i < launch;
            int at = isLaunch ? i : estimated[i - launch] ? index++ : -1;
            double deviation = at >= 0 ? from.StandardError(at) : 0;
            to->Identified |= at >= 0 && from.IsIdentified(at) ? 1 << i : 0;
            double* deviations = i < 3 ? to->PositionDeviation + i : i < 6 ? to->VelocityDeviation + i - 3 : isLaunch ? to->SpinDeviation + i - 6 : to->FactorDeviations + i - launch;
            *deviations = deviation;
            if (!isLaunch)
            {
                to->Factors[i - launch] = at >= 0 ? from.Value(at) : 1;
            }
        }

        Put(from.OtherSpin ?? Vector3d.Zero, to->OtherSpin);
        to->HasOtherSpin = from.OtherSpin is null ? 0 : 1;
        to->ChiSquared = from.ChiSquared;
        to->Probability = from.Probability;
        to->DegreesOfFreedom = from.DegreesOfFreedom;
        to->Iterations = from.Iterations;
        to->Verdict = (int)from.Verdict;
        to->GoodFor = (int)from.GoodFor;
        to->Suspicions = (int)from.Suspicions;
        to->Converged = from.Converged ? 1 : 0;
    }

    private static void Put(MatchPiece from, NativePiece* to)
    {
        *to = default;
        to->Kind = (int)from.Kind;
        to->Points = from.Points;
        to->StartTime = from.StartTime;
        to->EndTime = from.EndTime;
        to->Rms = from.Rms;
        to->MaximumResidual = from.MaximumResidual;
        Put(from.Position, to->Position);
        Put(from.Velocity, to->Velocity);
        Put(from.Spin, to->Spin);
        Put(from.VelocityBefore, to->VelocityBefore);
        Put(from.SpinBefore, to->SpinBefore);
        Put(from.VelocityDeviation, to->VelocityDeviation);
        Put(from.SpinDeviation, to->SpinDeviation);
        to->Restitution = from.Restitution ?? 0;
        to->SpeedRetained = from.SpeedRetained;
        to->HasRestitution = from.Restitution is null ? 0 : 1;
    }

    private static void Put(MatchFitResult from, NativeFitMatchResult* to)
    {
        *to = default;
        SurfaceMaterial material = from.Scene.Ground.Material;
        Span<double> values =
        [
            from.Scene.Air.Wind.X, from.Scene.Air.Wind.Z, 1, from.Scene.Ball.DragCurve.CriticalReynolds, 1, from.Scene.Ground.Height, material.NormalRestitution,
            material.GrazingRestitutionGain, material.ImpactFriction, material.SlidingFriction, material.RollingResistance, material.RollingResistancePerSpeed,
        ];
        values.CopyTo(new Span<double>(to->Values, NativeFitMatchResult.Parameters));
        for (int i = 0; i < from.Names.Count; i++)
        {
            int parameter = (int)Requests.Parameter(from.Names[i]);
            to->Values[parameter] = from.Value(i);
            to->Deviations[parameter] = from.StandardError(i);
            to->Estimated |= 1 << parameter;
        }

        to->Rms = from.Rms;
        to->Covered = from.Covered;
        to->Noise = from.Noise;
        to->RollingSpeed = from.RollingSpeed;
        to->RollingDeviation = from.RollingDeviation;
        to->Flights = from.Flights;
        to->Impacts = from.Impacts;
        to->Windows = from.Windows.Count;
        to->GoodFor = (int)from.GoodFor;
        to->Suspicions = (int)from.Suspicions;
    }
}
