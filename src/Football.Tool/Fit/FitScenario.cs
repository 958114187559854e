using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Cameras;

namespace FootballPhysics.Tool.Fit;

/// <summary>A scene, and the positions or pixels at which cameras saw a ball in it.</summary>
internal sealed record FitScenario
{
    public required Scene Scene { get; init; }

    /// <summary>The positions; empty if there are cameras.</summary>
    public TrackPoint[] Track { get; init; } = [];

    /// <summary>The cameras that saw the pixels; empty if the track has positions.</summary>
    public TrackCamera[] Cameras { get; init; } = [];

    public PixelPoint[] Pixels { get; init; } = [];

    public required TrackFitRequest Request { get; init; }

    /// <summary>Reads a scenario. The library checks the numbers.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static FitScenario Read(InputFields fields)
    {
        InputObject root = fields.Root;
        var defaults = new TrackFitRequest();
        InputObject fit = root.Object("fit");
        bool hasCameras = root.Has("cameras");
        CameraView[] cameras = CameraView.Take(root);
        double noise = fit.Number("noise", hasCameras ? 1 : 0.02);
        IReadOnlyList<InputObject> track = root.Objects("track");
        string[] also = fit.Texts("also") ?? [];
        var scenario = new FitScenario
        {
            Scene = SceneInput.Scene(root),
            Track = hasCameras ? [] : [.. track.Select(item => new TrackPoint(item.Number("time"), item.Vector("position"), item.Number("noise", noise)))],
            Cameras = [.. cameras.Select(view => view.Camera)],
            Pixels = hasCameras ? [.. track.Select(item => Pixel(item, noise))] : [],
            Request = new TrackFitRequest
            {
                Drag = also.Contains("drag"),
                Lift = also.Contains("lift"),
                Restitution = also.Contains("restitution"),
                Friction = also.Contains("friction"),
                Spin = fit.Vector("spin", defaults.Spin),
                SpinDeviation = fit.Number("spinDeviation", defaults.SpinDeviation),
                FactorDeviation = fit.Number("factorDeviation", defaults.FactorDeviation),
                FromGround = fit.Flag("fromGround", false),
                TimeStep = fit.Number("timeStep", defaults.TimeStep),
            },
        };
        fields.Check();
        string? unknown = Array.Find(also, name => name is not ("drag" or "lift" or "restitution" or "friction"));
        return unknown is null ? scenario : throw new RefusedException($"fit.also has {Quote.Short(unknown)}; allowed: drag | lift | restitution | friction.");
    }

    /// <summary>Fits the launch.</summary>
    public TrackFitResult Find() => Cameras.Length > 0 ? new TrackFit(Scene).Find(Cameras, Pixels, Request) : new TrackFit(Scene).Find(Track, Request);

    private static PixelPoint Pixel(InputObject item, double noise)
    {
        double[] pixel = item.Numbers("pixel", "[u, v]", 2);
        return new PixelPoint(item.Number("time"), item.Whole("camera", 0), pixel[0], pixel[1], item.Number("noise", noise));
    }
}
