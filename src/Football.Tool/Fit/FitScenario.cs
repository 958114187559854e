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
        var defaults = new TrackFitRequest();
        InputObject fit = root.Object("fit");
        double noise = fit.Number("noise", 0.02);
        string[] also = fit.Texts("also") ?? [];
        var scenario = new FitScenario
        {
            Scene = SceneInput.Scene(root),
            Track = [.. root.Objects("track").Select(item => new TrackPoint(item.Number("time"), item.Vector("position"), item.Number("noise", noise)))],
            Request = new TrackFitRequest
            {
                Drag = also.Contains("drag"),
                Lift = also.Contains("lift"),
                Restitution = also.Contains("restitution"),
                Friction = also.Contains("friction"),
                Spin = fit.Vector("spin", defaults.Spin),
                SpinDeviation = fit.Number("spinDeviation", defaults.SpinDeviation),
                FactorDeviation = fit.Number("factorDeviation", defaults.FactorDeviation),
                TimeStep = fit.Number("timeStep", defaults.TimeStep),
            },
        };
        fields.Check();
        string? unknown = Array.Find(also, name => name is not ("drag" or "lift" or "restitution" or "friction"));
        return unknown is null ? scenario : throw new RefusedException($"fit.also has {Quote.Short(unknown)}; allowed: drag | lift | restitution | friction.");
    }
}
