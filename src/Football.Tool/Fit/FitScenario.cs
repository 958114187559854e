using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Cameras;

namespace FootballPhysics.Tool.Fit;

/// <summary>A scene, and the positions or pixels of a ball that cameras observed in it.</summary>
internal sealed record FitScenario
{
    public required Scene Scene { get; init; }

    /// <summary>The observed positions; empty if there are cameras.</summary>
    public TrackPoint[] Track { get; init; } = [];

    /// <summary>The cameras of the observed pixels; empty if the track has positions.</summary>
    public TrackCamera[] Cameras { get; init; } = [];

    public PixelPoint[] Pixels { get; init; } = [];

    public required TrackFitRequest Request { get; init; }

    /// <summary>Reads a scenario. The library checks the numbers.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static FitScenario Read(InputFields fields)
    {
        InputObject root = fields.Root;
        InputObject fit = root.Object("fit");
        bool hasCameras = root.Has("cameras");
        CameraView[] cameras = CameraView.Take(root);
        double noise = fit.Number("noise", hasCameras ? 1 : 0.02);
        IReadOnlyList<InputObject> track = root.Objects("track");
        var scenario = new FitScenario
        {
            Scene = SceneInput.Scene(root),
            Track = hasCameras ? [] : [.. track.Select(item => new TrackPoint(item.Number("time"), item.Vector("position"), item.Number("noise", noise)))],
            Cameras = [.. cameras.Select(view => view.Camera)],
            Pixels = hasCameras ? [.. track.Select(item => Pixel(item, noise))] : [],
            Request = FitInput.Track(fit),
        };
        fields.Check();
        return scenario;
    }

    /// <summary>Fits the launch.</summary>
    public TrackFitResult Find() => Cameras.Length > 0 ? new TrackFit(Scene).Find(Cameras, Pixels, Request) : new TrackFit(Scene).Find(Track, Request);

    private static PixelPoint Pixel(InputObject item, double noise)
    {
        double[] pixel = item.Numbers("pixel", "[u, v]", 2);
        return new PixelPoint(item.Number("time"), item.Whole("camera", 0), pixel[0], pixel[1], item.Number("noise", noise));
    }
}
