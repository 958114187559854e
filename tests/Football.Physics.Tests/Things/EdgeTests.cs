using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Balls that slide and roll over the edges of boxes, where the load ends at once.</summary>
public sealed class EdgeTests
{
    [Theory]
    [ProfileData(Integrator.Rk4, 0.01)]
    [ProfileData(Integrator.Rk2, 0.04)]
    [ProfileData(Integrator.Rk4, 0.2)]
    public void A_ball_that_goes_over_the_edge_of_a_table_leaves_it_there_in_a_few_pieces(Profile profile, Integrator integrator, double step)
    {
        var table = new Obstacle { Name = "table", Shape = new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.5, 1)), Surface = SurfaceMaterial.Wood };
        foreach (double speed in new[] { 2.5, 6, 25 })
        {
            var simulator = new Simulator(profile.Scene() with { Obstacles = [table] }, Flight.With(integrator));
            BallState state = simulator.Launch(new Vector3d(-0.9, 1.5 + Flight.Radius, 0.1), new Vector3d(speed, 0, 0.2), new Vector3d(5, 20, -3));
            Assert.Equal(MotionState.Sliding, state.Motion);
            var log = new StepLog();
            long most = 0;
            while (state.Time < 1.6)
            {
                long before = log.Steps;
                simulator.Step(ref state, step, log);
                most = Math.Max(most, log.Steps - before);
            }

            BallEvent leave = log.Events.Span.ToArray().First(item => item.Kind == BallEventKind.ContactEnd);
            Assert.Equal(1, leave.Position.X, 1e-7);
            Assert.True(most < 200, $"{most} pieces in a step at {speed} m/s");
        }
    }

    [Theory]
    [ProfileData(Integrator.Rk4, 0.01)]
    [ProfileData(Integrator.Rk2, 0.04)]
    [ProfileData(Integrator.Rk4, 0.2)]
    public void A_slow_ball_rolls_round_the_edge_and_leaves_it_further_down(Profile profile, Integrator integrator, double step)
    {
        var table = new Obstacle { Name = "table", Shape = new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.5, 1)), Surface = SurfaceMaterial.Wood };
        var simulator = new Simulator(profile.Scene() with { Obstacles = [table] }, Flight.With(integrator));
        BallState state = simulator.Launch(new Vector3d(0.5, 1.5 + Flight.Radius, 0), new Vector3d(1, 0, 0), new Vector3d(0, 0, -1 / Flight.Radius));
        var log = new StepLog();
        simulator.Run(ref state, step, 2, StopAt.Impact, log);
        BallEvent leave = log.Events.Span.ToArray().First(item => item.Kind == BallEventKind.ContactEnd);
        Vector3d fromEdge = leave.Position - new Vector3d(1, 1.5, 0);
        Assert.Equal(Flight.Radius, new Vector3d(fromEdge.X, fromEdge.Y, 0).Length, 1e-6);
        Assert.InRange(fromEdge.X, 0.02, 0.1);
    }
}
