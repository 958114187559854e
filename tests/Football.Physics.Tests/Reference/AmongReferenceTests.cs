namespace FootballPhysics.Tests.Reference;

/// <summary>The default ball among posts, walls, moving bodies and slopes, against an independent solver: every event whole, and the end.</summary>
public sealed class AmongReferenceTests
{
    [Fact]
    public void All_cases_are_there() => Assert.Equal(48, ReferenceCase.Lines("among.ndjson").Count());

    [Theory]
    [InlineData(Integrator.Rk4, 0.01, 1)]
    [InlineData(Integrator.Rk4, 0.04, 8)]
    [InlineData(Integrator.Rk2, 0.01, 1e4)]
    public void Every_event_and_the_end_are_within_the_bound_of_each_case(Integrator integrator, double timeStep, double bounds) =>
        WholeRun.HoldAll("among.ndjson", integrator, timeStep, bounds);
}
