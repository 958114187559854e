namespace FootballPhysics.Tests.Several;

/// <summary>Balls at one place have no line of centres: they part along x, in the air as on the ground.</summary>
public sealed class OnePlaceTests
{
    [Theory]
    [InlineData(2, 1.0, false, false)]
    [InlineData(2, 0.11, false, false)]
    [InlineData(2, 5.0, true, false)]
    [InlineData(3, 1.0, false, false)]
    [InlineData(3, 0.11, true, false)]
    [InlineData(4, 2.0, true, false)]
    [InlineData(4, 1.0, false, true)]
    [InlineData(9, 3.0, true, true)]
    public void They_part(int count, double height, bool moves, bool different)
    {
        BallProperties[] kinds = [.. Enumerable.Range(0, count).Select(i => !different || i % 3 == 0 ? BallProperties.Modern : i % 3 == 1 ? BallProperties.MedicineBall : BallProperties.Futsal)];
        var group = new BallGroup(new Scene(), kinds);
        BallState[] balls = [.. kinds.Select((_, i) => group.SimulatorOf(i).Launch(new Vector3d(1, height, 2), moves ? new Vector3d(3, 2, 1) : Vector3d.Zero, Vector3d.Zero))];
        var log = new StepLog();
        for (int step = 0; step < 4; step++)
        {
            group.Step(balls, 1.0 / 60, log);
        }

        for (int i = 0; i < count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                Assert.InRange(Vector3d.Distance(balls[i].Position, balls[j].Position) - kinds[i].Radius - kinds[j].Radius, -2e-5, 10);
            }
        }

        // They part along x only, so nobody is thrown up.
        Assert.All(balls, ball => Assert.InRange(Math.Abs(ball.Velocity.Z - (moves ? 1 : 0)), 0, 0.7));
        if (!different && height > 0.5)
        {
            Assert.All(balls, ball => Assert.Equal(balls[0].Position.Y, ball.Position.Y, 1e-9));
        }
    }

    [Fact]
    public void Two_resting_balls_at_one_place_part()
    {
        var group = new BallGroup(new Simulator(), 2);
        BallState[] balls = [group.SimulatorOf(0).Launch(new Vector3d(0, 0.11, 0), default, default), group.SimulatorOf(1).Launch(new Vector3d(3, 0.11, 0), default, default)];
        var log = new StepLog();
        for (int i = 0; i < 30; i++)
        {
            group.Step(balls, 1.0 / 60, log);
        }

        Assert.All(balls, ball => Assert.Equal(MotionState.Rest, ball.Motion));
        balls[1] = balls[0];
        for (int i = 0; i < 30; i++)
        {
            group.Step(balls, 1.0 / 60, log);
        }

        Assert.Equal(0.22, Vector3d.Distance(balls[0].Position, balls[1].Position), 1e-6);
    }

    [Fact]
    public void The_direction_is_fixed()
    {
        BallContact(new Vector3d(0, 0, 0), new Vector3d(1, 0, 0));
        BallContact(new Vector3d(0, 0.1, 0), Vector3d.Up);

        static void BallContact(Vector3d apart, Vector3d normal) => Assert.Equal(normal, Simulation.BallContact.Normal(in apart, apart.Length));
    }
}
