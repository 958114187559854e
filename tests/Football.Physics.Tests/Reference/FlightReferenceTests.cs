namespace FootballPhysics.Tests.Reference;

/// <summary>Knuckle balls, named balls, smooth balls and impacts against an independent solver.</summary>
public sealed class FlightReferenceTests
{
    /// <summary>The bound of a case is a micrometre, or ten thousand roundings of its launch; a fast spin turns the field of the seams by half a radian in 10 ms.</summary>
    [Theory]
    [InlineData(Integrator.Rk4, 0.0025, 1)]
    [InlineData(Integrator.Rk4, 0.01, 40)]
    [InlineData(Integrator.Rk2, 0.0025, 2000)]
    public void Flights_end_where_and_how_the_reference_says(Integrator integrator, double timeStep, double bounds) =>
        WholeRun.HoldAll("flight.ndjson", integrator, timeStep, bounds);
}
