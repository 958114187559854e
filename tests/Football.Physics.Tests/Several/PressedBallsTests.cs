namespace FootballPhysics.Tests.Several;

/// <summary>Balls that a player presses against each other and against boards.</summary>
public sealed class PressedBallsTests
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    /// <summary>
    /// Two balls that a player drove to a board overlapped by up to 99 mm: at the end of each step, a ball was put out of the player at once, into the other ball. They
    /// overlap by no more than 1e-6 m now, and neither is in the board.
    /// </summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    public void Balls_in_a_row_do_not_overlap_between_a_player_and_a_board(int balls)
    {
        int pressed = 0;
        for (int seed = 1; seed <= 12; seed++)
        {
            var random = new Random(seed);
            double Between(double low, double high) => low + ((high - low) * random.NextDouble());
            var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.05), new Vector3d(50, 0.5, 0.05)), Surface = SurfaceMaterial.Board };
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25));
            var simulator = new Simulator(new Scene { Bodies = bodies, Obstacles = [board] });
            var group = new BallGroup(simulator, balls);
            var states = new BallState[balls];
            for (int i = 0; i < balls; i++)
            {
                states[i] = simulator.Launch(new Vector3d(Between(-0.02, 0.02), Radius, Radius + 0.01 + (0.235 * i)), Vector3d.Zero, Vector3d.Zero);
            }

            var place = new Vector3d(Between(-0.05, 0.05), 0, 1.5);
            var velocity = new Vector3d(0, 0, -Between(0.5, 5));
            var log = new StepLog();
            for (int frame = 0; frame < 150; frame++)
            {
                bool runs = frame < 60;
                player.MoveTo(place, runs ? velocity : Vector3d.Zero, states[0].Time);
                place += runs ? Frame * velocity : Vector3d.Zero;
                log.Clear();
                group.Step(states, Frame, log);
                Assert.Equal(0, log.StalledSteps);
                for (int i = 0; i < balls; i++)
                {
                    pressed += states[i].Motion == MotionState.Pinned ? 1 : 0;
                    Assert.InRange(states[i].Position.Y, Radius - 1e-9, 60);
                    Assert.InRange(board.Shape.At(states[i].Position).Distance, Radius - 1e-9, 60);
                    for (int j = 0; j < i; j++)
                    {
                        Assert.InRange((states[i].Position - states[j].Position).Length, (2 * Radius) - 1e-6, 60);
                    }
                }
            }
        }

        Assert.True(pressed > 0, "Nobody presses the balls.");
    }
}
