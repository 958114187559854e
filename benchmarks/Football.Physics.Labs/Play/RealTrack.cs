using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;

namespace FootballPhysics.Labs.Play;

/// <summary>Compares the track of a real match with the library's balls and surfaces.</summary>
internal static class RealTrack
{
    /// <summary>The name of the turf of <see cref="Scene.Default"/>.</summary>
    private const string Shipped = "default";

    /// <summary>The largest error of the median of a class of bounces: for tracks with millimetres and with centimetres of noise.</summary>
    private const double Near = 0.05;
    private const double Coarse = 0.1;

    private static readonly (string Name, BallProperties Ball)[] Balls =
    [
        ("generic", BallProperties.Tunnel), ("brazuca", BallProperties.Brazuca), ("trionda", BallProperties.Trionda), ("modern", BallProperties.Modern),
    ];

    /// <summary>The surfaces to compare. One is the former match turf, from one minute of one match.</summary>
    private static readonly (string Name, Ground Ground)[] Grounds =
    [
        ("dryTurf", Ground.Of(SurfaceMaterial.DryTurf)), ("wetTurf", Ground.Of(SurfaceMaterial.WetTurf)), ("matchTurf", Ground.Of(SurfaceMaterial.MatchTurf)),
        ("matchTurf by one match", Ground.Of(SurfaceMaterial.MatchTurf with
            {
                NormalRestitution = 0.61,
                RestitutionSpeedScale = 30,
                GrazingRestitutionGain = 0.85,
                ImpactFriction = 0.41,
                TangentialRestitution = -0.1,
            })),
        (Shipped, Scene.Default.Ground),
    ];

    /// <param name="file">The track.</param>
    /// <param name="altitude">The altitude of the stadium above sea level, m.</param>
    /// <param name="flights">Receives the fit of each ball; null to skip the fits.</param>
    /// <param name="impacts">Receives the bounces.</param>
    /// <param name="windows">Receives the slides and rolls.</param>
    /// <param name="run">Receives notes, and remarks on the file.</param>
    public static void Add(string file, double? altitude, LabTable? flights, LabTable impacts, LabTable windows, LabRun run)
    {
        TrackPoint[] track;
        try
        {
            using FileStream stream = File.OpenRead(file);
            track = TrackReader.Read(stream, run.Terminal.Person.WriteLine);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new RefusedException("FILE", Quote.File(file), "a file that can be read");
        }

        Air air = altitude is { } metres ? Weather.AtAltitude(metres, 15, 0.5).ToAir() : new Air();
        string name = Path.GetFileName(file);
        MatchFitResult? last = flights is null ? Fit(track, BallProperties.Modern, air, true) : null;
        foreach ((string ball, BallProperties properties) in flights is null ? [] : Balls)
        {
            foreach (bool fitted in (bool[])[false, true])
            {
                // The ball with its default drag, and with its drag fitted.
                MatchFitResult fit = Fit(track, properties, air, fitted);
                flights!.Add(name, ball, fitted ? "drag, wind, height" : "wind, height", fit.Flights, 100 * fit.Rms, 100 * fit.Covered, Value(fit, "drag"), fit.Scene.Ball.DragCurve.CriticalReynolds, Limit(fit, ball, fitted));
                last = fit;
            }
        }

        AddImpacts(name, last!, impacts);
        AddWindows(name, last!, windows);
        run.Notes.Add($"{name}: good for {last!.Explanation}.");
    }

    private static MatchFitResult Fit(TrackPoint[] track, BallProperties ball, Air air, bool drag) =>
        new MatchFit(new Scene { Ball = ball, Air = air, Ground = Ground.Of(SurfaceMaterial.MatchTurf) }).Find(track, new MatchFitRequest { Drag = drag });

    private static string Limit(MatchFitResult fit, string ball, bool fitted) =>
        ball != "modern" || fit.Flights < 4 || !Sharp(fit) ? "" : Verdict.Of(fit.Rms <= (fitted ? 0.03 : 0.06));

    private static double Value(MatchFitResult fit, string name)
    {
        int at = fit.Names.ToList().IndexOf(name);
        return at >= 0 ? fit.Value(at) : 1;
    }

    private static void AddImpacts(string file, MatchFitResult fit, LabTable table)
    {
        // List the turf of the default scene once, under that name.
        foreach (BounceRow row in BounceClasses.Of(fit, [.. Grounds.Where(surface => surface.Name == Shipped || surface.Ground != Scene.Default.Ground)]))
        {
            bool isSeen = row.Surface is null;
            double most = Sharp(fit) ? Near : Coarse;
            table.Add(
                file, row.Class, row.Surface ?? "seen", row.Impacts, row.Median.Restitution, row.Median.Kept, row.Median.Friction, isSeen ? null : row.Off.Restitution, isSeen ? null : row.Off.Kept,
                row.Surface == Shipped ? Verdict.Of(Math.Abs(row.Off.Restitution) <= most) : "", row.Surface == Shipped ? Verdict.Of(Math.Abs(row.Off.Kept) <= most) : "");
        }
    }

    /// <summary>Adds slides and rolls: the windows of the track, their combined result, and the default turf's values.</summary>
    private static void AddWindows(string file, MatchFitResult fit, LabTable table)
    {
        Ground shipped = Scene.Default.Ground;
        foreach (MotionState motion in (MotionState[])[MotionState.Sliding, MotionState.Rolling])
        {
            GroundWindow[] windows = [.. fit.Windows.Where(window => window.Motion == motion)];
            if (windows.Length == 0)
            {
                continue;
            }

            bool slides = motion == MotionState.Sliding;
            double speed = slides ? windows.Average(window => window.Speed) : fit.RollingSpeed;
            double together = slides ? fit.Scene.Ground.Material.SlidingFriction : fit.Scene.Ground.Material.RollingResistance + (fit.Scene.Ground.Material.RollingResistancePerSpeed * speed);
            double deviation = slides ? fit.StandardError(fit.Names.ToList().IndexOf("slidingFriction")) : fit.RollingDeviation;
            double turf = slides ? shipped.Material.SlidingFriction : shipped.Material.RollingResistance + (shipped.Material.RollingResistancePerSpeed * speed);
            table.Add(
                file, slides ? "slides: μ_s" : "rolls: c₀ + c₁ v", windows.Length, speed, BounceClasses.Median(windows.Select(window => window.Resistance)),
                windows.Min(window => window.Resistance), windows.Max(window => window.Resistance), together, deviation, turf, Verdict.Of(Math.Abs(turf - together) <= 2 * deviation));
        }
    }

    /// <summary>True if the noise of a track is a few millimetres.</summary>
    private static bool Sharp(MatchFitResult fit) => fit.Noise <= 0.005;
}
