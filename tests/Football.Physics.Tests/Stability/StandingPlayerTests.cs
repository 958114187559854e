using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>A ball between a board and a player who stands still: a body that does not move gives no energy, so the ball comes to rest without events.</summary>
public sealed class StandingPlayerTests
{
    private const double Tick = 1.0 / 60;
    private const double Radius = 0.11;

    [Theory]
    [InlineData(0, true, true)]
    [InlineData(0, true, false)]
    [InlineData(0, false, true)]
    [InlineData(1, true, true)]
    [InlineData(1, false, true)]
    [InlineData(2, true, true)]
    [InlineData(2, false, true)]
    [InlineData(3, true, true)]
    [InlineData(3, false, true)]
    public void A_ball_beside_a_standing_player_comes_to_rest(int seed, bool rolls, bool isThere)
    {
        // Rolled in between player and board, or dropped between a shoulder and the top of the board.
        var random = new Shots(seed);
        double spread = seed > 0 ? 1 : 0;
        double radius = rolls ? 0.2 : 0.2558;
        double gap = (rolls ? 0.1885 : 0.1443) + (spread * random.Uniform(-0.005, 0.005));
        var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.05), new Vector3d(50, 0.5, 0.05)), Surface = SurfaceMaterial.Board };
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, radius, 0), new Vector3d(0, 1.5, 0), radius), SurfaceMaterial.Boot);
        var simulator = new Simulator(Scene.Default with { Bodies = bodies, Obstacles = [board] });
        double speed = 4.18 + (spread * random.Uniform(-0.5, 0.5));
        BallState ball = rolls
            ? simulator.Launch(new Vector3d(2.96, Radius, 0.127), new Vector3d(-speed, 0, -0.128), Vector3d.Zero)
            : simulator.Launch(new Vector3d(0.024 + (spread * random.Uniform(-0.01, 0.01)), 1.116, Radius), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        for (int tick = 0; tick < 1800; tick++)
        {
            player.MoveTo(new Vector3d(isThere ? 0 : 30, 0, gap + radius), Vector3d.Zero, ball.Time);
            log.Clear();
            simulator.Step(ref ball, Tick, log);
            Assert.Equal(0, log.StalledSteps);
            Assert.True(tick < 900 || log.Events.Count == 0, $"{log.Events.Count} events at {ball.Time} s, {ball.Motion} at {ball.Position}");
        }

        Assert.Equal(MotionState.Rest, ball.Motion);
    }
}
