using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Fit;

/// <summary>A scene, and where a camera saw a ball in it.</summary>
internal sealed record FitScenario
{
    public required Scene Scene { get; init; }

    public required TrackPoint[] Track { get; init; }

    public required TrackFitRequest Request { get; init; }

    /// <summary>Reads a scenario. The library checks the numbers.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static FitScenario Read(InputFields fields)
    {
        InputObject root = fields.Root;
        InputObject fit = root.Object("fit");
        double noise = fit.Number("noise", 0.02);
        var scenario = new FitScenario
        {
            Scene = SceneInput.Scene(root),
            Track = [.. root.Objects("track").Select(item => new TrackPoint(item.Number("time"), item.Vector("position"), item.Number("noise", noise)))],
            Request = FitInput.Track(fit),
        };
        fields.Check();
        return scenario;
    }
}
