namespace FootballPhysics.Tests.Api;

/// <summary>A clock that a step would not move is refused: nothing would ever end.</summary>
public sealed class ClockTests
{
    [Theory]
    [InlineData(1e-300)]
    [InlineData(1e-9)]
    [InlineData(0)]
    [InlineData(double.NaN)]
    public void A_runner_whose_frame_would_have_more_than_a_million_steps_is_refused(double timeStep) =>
        Assert.StartsWith("timeStep is ", Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepRunner(timeStep: timeStep)).Message);

    [Theory]
    [InlineData(1e13)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(double.NaN)]
    [InlineData(-1)]
    public void A_step_or_a_run_longer_than_any_clock_is_refused(double time)
    {
        var ball = new Ball();
        BallState state = ball.State;
        Assert.Throws<ArgumentOutOfRangeException>(() => ball.Step(time));
        Assert.Throws<ArgumentOutOfRangeException>(() => ball.Simulator.Step(ref state, time, new StepLog()));
        Assert.Throws<ArgumentOutOfRangeException>(() => ball.Simulator.Run(ref state, time, 1, StopAt.Time, new StepLog()));
        Assert.Throws<ArgumentOutOfRangeException>(() => ball.Simulator.Run(ref state, 1, time, StopAt.Time, new StepLog()));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepRunner(maximumFrameTime: time));
        Assert.True(Snapshot.Same(ball.State, state));
    }

    [Fact]
    public void A_run_at_a_clock_of_1e15_is_refused_and_one_in_longer_steps_ends()
    {
        var simulator = new Simulator(Scene.Published);
        BallState state = At(simulator, 1e15);
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Run(ref state, 0.01, 1, StopAt.Time, new StepLog()));
        Assert.StartsWith("timeStep is 0.01; allowed: more than the rounding error of the clock at 1000000000000001 s", refused.Message);
        simulator.Run(ref state, 1, 5, StopAt.Time, new StepLog());
        Assert.Equal(1e15 + 5, state.Time);
    }

    [Fact]
    public void A_look_ahead_from_a_clock_of_1e17_is_refused()
    {
        var simulator = new Simulator(Scene.Published);
        BallState state = At(simulator, 1e17);
        var path = new Trajectory();
        Assert.Equal("lookAhead.timeStep", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.LookAhead(in state, new LookAheadRequest(), path)).ParamName);
        var prediction = new TrajectoryCache(simulator, new LookAheadRequest());
        Assert.Equal("lookAhead.timeStep", Assert.Throws<ArgumentOutOfRangeException>(() => prediction.Update(in state)).ParamName);
        var runner = new FixedStepRunner(simulator);
        BallState before = runner.State;
        Assert.Equal("TimeStep", Assert.Throws<ArgumentOutOfRangeException>(() => runner.Restore(3, in state)).ParamName);
        Assert.True(Snapshot.Same(before, runner.State));
    }

    /// <summary>Every clock that is accepted lets a run end, also just above where it is refused.</summary>
    [Fact]
    public void Steps_that_are_accepted_move_the_clock()
    {
        var simulator = new Simulator(Scene.Vacuum);
        for (double time = 1; time < 1e17; time *= 3)
        {
            for (double step = 1e-6; step < 10; step *= 1.7)
            {
                BallState state = At(simulator, time);
                try
                {
                    simulator.Run(ref state, step, 20 * step, StopAt.Time, new StepLog());
                }
                catch (ArgumentOutOfRangeException)
                {
                    continue;
                }

                Assert.InRange(state.Time, time + (10 * step), time + (40 * step));
            }
        }
    }

    private static BallState At(Simulator simulator, double time)
    {
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(1, 2, 3), Vector3d.Zero);
        state.Time = time;
        return state;
    }
}
