namespace FootballPhysics.Tests.Game;

/// <summary>A late kick while boards hit the ball: every depth gives the bits of a match in which the kick came in time.</summary>
public sealed class RollbackAmongBodiesTests
{
    private const double TimeStep = 1.0 / 60;
    private const int Ticks = 12;

    /// <summary>The game moves two boards in curves before most steps, and a ball between them pushes a dummy.</summary>
    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void Bodies_and_pushed_obstacles_are_where_they_were_at_every_depth(bool asks, bool afterMove)
    {
        int hits = 0;
        int pushed = 0;
        for (int late = 1; late <= Ticks; late++)
        {
            FixedStepRunner inTime = Match(asks, out Action<double> moveInTime);
            FixedStepRunner client = Match(asks, out Action<double> move);
            var rollback = new Rollback(client, Ticks);
            foreach (KickInput kick in Kicks)
            {
                inTime.Kicks.Add(in kick);
            }

            for (int tick = 0; tick < 90; tick++)
            {
                bool moves = !asks && tick % 5 != 0;
                if (moves && afterMove)
                {
                    move(client.Time);
                }

                foreach (KickInput kick in Kicks.Where(kick => kick.Tick + late == tick))
                {
                    Assert.Equal(kick.Tick + 1, rollback.ApplyKick(in kick));
                    int events = rollback.Events.Count;
                    Assert.Null(rollback.ResimulateFrom(kick.Tick));
                    Assert.Equal(events, rollback.Events.Count);
                    Assert.Null(rollback.ResimulateFrom(tick - (late / 2)));
                    Assert.Null(rollback.ResimulateFrom(kick.Tick));
                    hits += rollback.Events.Span.ToArray().Count(at => client.Simulator.NameOf(at.ColliderIndex) == "board");
                    pushed += rollback.Events.Span.ToArray().Count(at => client.Simulator.NameOf(at.ColliderIndex) == "dummy");
                }

                Assert.True(Kicks.Any(kick => tick > kick.Tick && tick < kick.Tick + late) || Snapshot.Same(inTime.State, client.State), $"late {late}, tick {tick}");
                if (moves && !afterMove)
                {
                    move(client.Time);
                }

                if (moves)
                {
                    moveInTime(inTime.Time);
                }

                inTime.Step();
                client.Step();
            }

            Assert.Equal(inTime.Simulator.World.Obstacles.Of(0)!.Motion.Origin, client.Simulator.World.Obstacles.Of(0)!.Motion.Origin);
            Assert.Null(rollback.SyncTest(Ticks));
            Assert.Equal(inTime.Simulator.World.Obstacles.Of(0)!.Motion.Velocity, client.Simulator.World.Obstacles.Of(0)!.Motion.Velocity);
        }

        Assert.True(hits > 20 && pushed >= 5, $"{hits} and {pushed}");
    }

    /// <summary>A step that fails restores what the ball has pushed in it.</summary>
    [Fact]
    public void A_step_that_fails_leaves_a_pushed_obstacle_as_it_was()
    {
        int failed = 0;
        for (double after = 0.2; after < 0.5; after += 0.013)
        {
            double limit = after;
            IForce breaks = IForce.From(ball => ball.Velocity.Z > 0 && ball.Position.Z > -2 + limit ? throw new NotSupportedException() : Vector3d.Zero);
            var runner = new FixedStepRunner(
                new Simulator(new Scene { Forces = ForceSet.Measured with { CustomForces = [breaks] }, Obstacles = [Dummy(-2.2)] }), 0.2);
            runner.Restore(0, runner.Simulator.Launch(new Vector3d(0, 0.8, -0.6), new Vector3d(0, 2, -14), Vector3d.Zero));
            Vector3d velocity = default;
            BallState before = default;
            try
            {
                for (int i = 0; i < 9; i++)
                {
                    velocity = runner.Simulator.World.Obstacles.Of(0)!.Motion.Velocity;
                    before = runner.State;
                    runner.Step();
                }
            }
            catch (NotSupportedException)
            {
                Assert.Equal(velocity, runner.Simulator.World.Obstacles.Of(0)!.Motion.Velocity);
                Assert.True(Snapshot.Same(before, runner.State));
                failed += velocity == Vector3d.Zero ? 1 : 0;
            }
        }

        Assert.InRange(failed, 3, 30);
    }

    private static Obstacle Dummy(double z) => new() { Name = "dummy", Shape = new BoxShape(new Vector3d(0, 0.9, z), new Vector3d(1.5, 0.9, 0.2)), Mass = 20 };

    private static KickInput[] Kicks => [new(20, new Vector3d(14, 0.5, -9), default, 1), new(50, new Vector3d(-14, 0.5, -9), new Vector3d(0, 10, 0), 2)];

    private static FixedStepRunner Match(bool asks, out Action<double> move)
    {
        var bodies = new KinematicBodies();
        KinematicBody[] boards = [.. new[] { -1, 1 }.Select(_ => bodies.Add("board", new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(0.1, 0.5, 3)), SurfaceMaterial.Board))];
        move = time =>
        {
            for (int i = 0; i < 2; i++)
            {
                double side = (2 * i) - 1;
                boards[i].MoveTo(new Vector3d((0.7 * side) + (0.2 * Math.Sin(9 * time)), 0, 0), new Vector3d(1.8 * Math.Cos(9 * time), 0, 0), time);
            }
        };
        move(0);
        var runner = new FixedStepRunner(new Simulator(new Scene { Bodies = bodies, Obstacles = [Dummy(-1)] }), TimeStep);
        runner.Kicks.Add(new KickInput(0, new Vector3d(9, 1, 0), default));
        runner.MoveBodies = asks ? move : null;
        return runner;
    }
}
