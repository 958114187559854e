using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>Reads the request for a fit: the parameters to estimate, and their priors.</summary>
public static class FitInput
{
    /// <summary>The names of the quantities that a match fit can estimate for the whole track.</summary>
    public static IReadOnlyList<string> Free { get; } = ["wind", "drag", "crisis", "lift", "surface", "height"];

    private static readonly string[] s_also = ["drag", "lift", "restitution", "friction"];

    /// <summary>Reads the request for the fit of one flight: the member "fit" of a scenario. The library checks the numbers.</summary>
    /// <param name="fit">The object "fit".</param>
    public static TrackFitRequest Track(InputObject fit)
    {
        var defaults = new TrackFitRequest();
        string[] also = fit.Texts("also") ?? [];
        fit.Demand("also", Array.TrueForAll(also, s_also.Contains), "a list of " + string.Join(" | ", s_also));
        return new TrackFitRequest
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
        };
    }

    /// <summary>Reads the request for the fit of a match. The library checks the numbers.</summary>
    /// <param name="fit">The object "fit".</param>
    public static MatchFitRequest Match(InputObject fit)
    {
        string[]? free = fit.Texts("free");
        fit.Demand("free", free is null || Array.TrueForAll(free, Free.Contains), "a list of " + string.Join(" | ", Free));
        MatchFitRequest request = free is null ? new MatchFitRequest() : Match(free);
        return request with
        {
            WindDeviation = fit.Number("windDeviation", request.WindDeviation),
            FactorDeviation = fit.Number("factorDeviation", request.FactorDeviation),
            CrisisDeviation = fit.Number("crisisDeviation", request.CrisisDeviation),
            SpinDeviation = fit.Number("spinDeviation", request.SpinDeviation),
        };
    }

    /// <summary>Creates a request that estimates only the given quantities.</summary>
    /// <param name="free">Names from <see cref="Free"/>.</param>
    public static MatchFitRequest Match(string[] free) => new()
    {
        Wind = free.Contains("wind"),
        Drag = free.Contains("drag"),
        Crisis = free.Contains("crisis"),
        Lift = free.Contains("lift"),
        Surface = free.Contains("surface"),
        Height = free.Contains("height"),
    };
}
