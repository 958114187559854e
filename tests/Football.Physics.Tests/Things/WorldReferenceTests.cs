using FootballPhysics.Tests.Reference;

namespace FootballPhysics.Tests.Things;

/// <summary>Goals, nets, walls, things, slopes and bumps against trajectories computed by an independent solver: every event whole, and the end.</summary>
public sealed class WorldReferenceTests
{
    [Fact]
    public void All_cases_are_there() => Assert.Equal(118, ReferenceCase.Lines("world.ndjson").Count());

    [Theory]
    [InlineData(Integrator.Rk4, 0.01, 1)]
    [InlineData(Integrator.Rk4, 0.04, 8)]
    [InlineData(Integrator.Rk2, 0.01, 1e4)]
    public void Every_event_and_the_end_are_within_the_bound_of_each_case(Integrator integrator, double timeStep, double bounds) =>
        WholeRun.HoldAll("world.ndjson", integrator, timeStep, bounds);
}
