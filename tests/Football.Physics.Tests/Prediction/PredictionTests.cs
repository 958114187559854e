namespace FootballPhysics.Tests.Predictors;

/// <summary>A prediction is kept and extended while the ball keeps to it, and made anew only after a kick.</summary>
public sealed class PredictionTests
{
    private const double Step = 1.0 / 60;

    [Theory]
    [InlineData(Integrator.SemiImplicitEuler)]
    [InlineData(Integrator.Rk2)]
    [InlineData(Integrator.Rk4)]
    public void With_the_games_own_step_it_is_the_future_bit_for_bit_and_is_never_made_again(Integrator integrator)
    {
        var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = integrator });
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = Step, Duration = 2 }, tolerance: 0);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(14, 8, 3), new Vector3d(5, 30, -20));
        Assert.True(prediction.Update(in ball));
        int checks = 0;
        while (ball.Motion != MotionState.Rest)
        {
            // What is predicted for a second later is what will be.
            BallState later = ball;
            for (int i = 0; i < 60; i++)
            {
                simulator.Step(ref later, Step, log);
            }

            if (later.Time <= prediction.Path.EndTime && later.Motion != MotionState.Rest)
            {
                Assert.Equal(later.Position, prediction.Path.PositionAt(later.Time));
                checks++;
            }

            simulator.Step(ref ball, Step, log);
            Assert.False(prediction.Update(in ball));
            Assert.True(prediction.Path.StartTime <= ball.Time);
            Assert.True(prediction.Path.EndTime >= Math.Min(ball.Time + 2, prediction.Path.TryGetRest(out BallEvent rest) ? rest.Time : double.PositiveInfinity));
        }

        Assert.True(checks > 100, $"{checks}");
        Assert.Equal(1, prediction.Recomputations);
        Assert.Equal(ball.Position, prediction.Path.Final.Position);
    }

    [Fact]
    public void With_coarser_steps_it_is_kept_within_its_tolerance()
    {
        var simulator = new Simulator(Scene.Published);
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = 0.05, Duration = 3 });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(18, 9, 3), new Vector3d(5, 10, -10));
        int updates = 0;
        while (ball.Motion != MotionState.Rest)
        {
            prediction.Update(in ball);
            updates++;
            Assert.True(Vector3d.Distance(prediction.Path.PositionAt(ball.Time), ball.Position) <= prediction.Tolerance);
            simulator.Step(ref ball, 0.01, log);
        }

        Assert.InRange(prediction.Recomputations, 1, updates / 20);
    }

    [Fact]
    public void A_kick_and_an_invalidation_make_it_anew()
    {
        var simulator = new Simulator(Scene.Published);
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = Step, Duration = 2 });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(14, 8, 3), default);
        Assert.True(prediction.Update(in ball));
        simulator.Step(ref ball, Step, log);
        Assert.False(prediction.Update(in ball));
        simulator.Kick(ref ball, new Vector3d(-5, 6, 0), default);
        Assert.True(prediction.Update(in ball));
        Assert.Equal(ball.Position, prediction.Path.PositionAt(ball.Time));
        Assert.Equal(ball.Velocity, prediction.Path.VelocityAt(ball.Time));
        prediction.Invalidate();
        Assert.True(prediction.Update(in ball));
        Assert.Equal(3, prediction.Recomputations);
    }

    [Fact]
    public void It_ends_at_the_event_asked_for_and_is_made_anew_after_it()
    {
        var simulator = new Simulator(Scene.Published);
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = Step, Duration = 5, StopAt = StopAt.Impact });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(10, 6, 0), default);
        int impacts = 0;
        while (impacts < 4)
        {
            prediction.Update(in ball);
            Assert.True(Vector3d.Distance(prediction.Path.PositionAt(ball.Time), ball.Position) <= prediction.Tolerance);
            Assert.Equal(impacts + 1, prediction.Recomputations);
            log.Clear();
            simulator.Step(ref ball, Step, log);
            impacts += log.Events.Count;
            Assert.True(ball.Time < 10);
        }
    }

    [Fact]
    public void It_allocates_nothing_from_kick_to_rest()
    {
        var simulator = new Simulator(Scene.Published);
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = Step, Duration = 2 });
        var log = new StepLog();
        void Live()
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(14, 8, 3), new Vector3d(5, 30, -20));
            while (ball.Motion != MotionState.Rest)
            {
                prediction.Update(in ball);
                simulator.Step(ref ball, Step, log);
                log.Clear();
            }
        }

        Assert.Equal(0, Allocation.Of(Live));
    }

    [Fact]
    public void One_that_does_not_fit_grows()
    {
        var simulator = new Simulator(Scene.Published);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 6, -18), new Vector3d(20, 5, 0));
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest { Duration = 3, TimeStep = 0.01, StopAt = StopAt.Time }, capacity: 60);
        var log = new StepLog();
        for (int i = 0; i < 400; i++)
        {
            prediction.Update(in ball);
            Assert.True(prediction.Path.EndTime - ball.Time > 2.99, $"{i}: {prediction.Path.EndTime - ball.Time} s ahead");
            Assert.True(prediction.Path.IsComplete);
            Vector3d expected = prediction.Path.PositionAt(ball.Time + 0.01);
            simulator.Step(ref ball, 0.01, log);
            Assert.Equal(0, Vector3d.Distance(expected, ball.Position), 1e-12);
        }

        Assert.Equal(1, prediction.Recomputations);
    }
}
