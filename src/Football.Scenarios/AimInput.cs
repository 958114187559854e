using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>Reads the request for a kick: the member "aim" of a scenario.</summary>
public static class AimInput
{
    /// <summary>Reads the request. The library checks its numbers during the search.</summary>
    /// <param name="aim">The object "aim".</param>
    public static AimRequest Request(InputObject aim)
    {
        var request = new AimRequest();
        InputObject spin = aim.Object("spin");
        InputObject elevation = aim.Object("elevation");
        InputObject maxSpin = aim.Object("maxSpin");
        return new AimRequest
        {
            From = aim.Vector("from"),
            Target = aim.Vector("target"),
            Waypoint = aim.OptionalVector("through"),
            Speed = aim.Number("speed"),
            TargetVelocity = aim.Vector("targetVelocity", request.TargetVelocity),
            KickTime = aim.Number("kickTime", request.KickTime),
            Arc = aim.Choice("arc", request.Arc),
            TopSpin = spin.Number("top", request.TopSpin),
            SideSpin = spin.Number("side", request.SideSpin),
            MinimumElevationDegrees = elevation.Number("min", request.MinimumElevationDegrees),
            MaximumElevationDegrees = elevation.Number("max", request.MaximumElevationDegrees),
            SpinIsFree = spin.Flag("free", request.SpinIsFree),
            MaximumTopSpin = maxSpin.Number("top", request.MaximumTopSpin),
            MaximumSideSpin = maxSpin.Number("side", request.MaximumSideSpin),
            Orientation = Scenario.OrientationOf(aim),
            Tolerance = aim.Number("tolerance", request.Tolerance),
            WaypointTolerance = aim.Number("throughTolerance", request.WaypointTolerance),
            MaximumIterations = aim.Whole("maxIterations", request.MaximumIterations),
        };
    }
}
