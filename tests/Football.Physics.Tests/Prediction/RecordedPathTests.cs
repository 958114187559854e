namespace FootballPhysics.Tests.Predictors;

/// <summary>What a path stores of a motion: complete segments, at the cost of the evaluations that they need.</summary>
public sealed class RecordedPathTests
{
    /// <summary>Without air, a path that ends at a plane consists of parabolas.</summary>
    [Fact]
    public void A_path_in_vacuum_up_to_a_plane_is_a_parabola()
    {
        var simulator = new Simulator(Scene.Vacuum);
        var velocity = new Vector3d(3, 8, -7);
        BallState ball = simulator.Launch(new Vector3d(1, 0.5, 2), velocity, Vector3d.Zero);
        foreach (LookAheadRequest request in new[]
        {
            new LookAheadRequest { UntilPlane = new Plane3d(new Vector3d(0, 0, -5), new Vector3d(0, 0, 1)) },
            new LookAheadRequest { UntilPassing = new Vector3d(3, 0, -4) },
            new LookAheadRequest { StopAt = StopAt.Impact },
        })
        {
            var path = new Trajectory();
            simulator.LookAhead(in ball, request, path);
            Assert.True(path.EndTime > 0.85);
            for (double t = 0; t < 0.9; t += 0.013)
            {
                Vector3d expected = ball.Position + (t * velocity) + new Vector3d(0, -0.5 * 9.81 * t * t, 0);
                Assert.InRange(Vector3d.Distance(expected, path.PositionAt(t)), 0, 1e-9);
            }
        }
    }

    /// <summary>The only segment of a path is as accurate as many short ones.</summary>
    [Fact]
    public void A_path_of_one_step_has_the_acceleration_at_its_end()
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(5, 6, -25), new Vector3d(10, 50, 0));
        var path = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.04, TimeStep = 0.04, StopAt = StopAt.Time }, path);
        Assert.Equal(1, path.Pieces.Length);
        var fine = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.04, TimeStep = 0.001, StopAt = StopAt.Time }, fine);
        for (double t = 0.001; t < 0.04; t += 0.001)
        {
            Assert.InRange(Vector3d.Distance(fine.PositionAt(t), path.PositionAt(t)), 0, 1e-6);
        }
    }

    /// <summary>
    /// The next step of flight computes the acceleration at the end of a step anyway. A path that must know it at once, because it ends at a plane,
    /// costs one more evaluation for each step of flight that another one continues: exactly so without impacts, and at least so with them.
    /// </summary>
    [Theory]
    [InlineData(0.9)]
    [InlineData(6)]
    public void A_step_of_flight_takes_the_acceleration_at_its_end_from_the_next_one(double duration)
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 5, -9), new Vector3d(0, 20, 0));
        var request = new LookAheadRequest { Duration = duration, StopAt = StopAt.Time };
        var open = new Trajectory(4096);
        var closed = new Trajectory(4096);
        simulator.LookAhead(in ball, request, open);
        simulator.LookAhead(in ball, request with { UntilPlane = new Plane3d(new Vector3d(0, -50, 0), Vector3d.Up) }, closed);
        Assert.Equal(closed.Pieces.Length, open.Pieces.Length);
        int continued = 0;
        int others = 0;
        for (int i = 0; i + 1 < open.Pieces.Length; i++)
        {
            (PathSegment piece, PathSegment next) = (open.Piece(i), open.Piece(i + 1));
            bool flies = piece.Motion == MotionState.Airborne && next.Motion == MotionState.Airborne;
            bool isWhole = duration < 1 || Math.Min(piece.Length, next.Length) > request.TimeStep - 1e-9;
            continued += flies && isWhole && piece.EndVelocity == next.StartVelocity ? 1 : 0;
            others += next.Motion == MotionState.Airborne ? 0 : 1;
            Assert.Equal(closed.Piece(i).EndAcceleration, piece.EndAcceleration);
        }

        Assert.True(continued > 5 && (others > 20) == (duration > 1));
        Assert.InRange(open.Evaluations, duration > 1 ? 0 : closed.Evaluations - continued, closed.Evaluations - continued);
    }

    /// <summary>A path that fills its memory knows where the ball is at every boundary of its segments.</summary>
    [Fact]
    public void A_full_path_is_continuous_at_its_boundaries()
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 5, -9), new Vector3d(0, 20, 0));
        var path = new Trajectory(new PathSegment[9]);
        simulator.LookAhead(in ball, new LookAheadRequest(), path);
        Assert.Equal(9, path.Pieces.Length);
        for (int i = 1; i < 9; i++)
        {
            Assert.Equal(path.Piece(i - 1).EndPosition, path.PositionAt(path.Piece(i).Time));
        }
    }

    [Fact]
    public void A_request_that_no_step_can_serve_is_refused()
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 6, -18), Vector3d.Zero);
        var unknown = new LookAheadRequest { StopAt = (StopAt)99 };
        Assert.Contains("lookAhead.stopAt", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.LookAhead(in ball, unknown, new Trajectory())).Message, StringComparison.Ordinal);

        // A step of 1e-9 s does not change a clock of a million seconds by much, and one of 1e-12 s not at all.
        BallState late = ball;
        late.Time = 1e6;
        var tiny = new LookAheadRequest { TimeStep = 1e-12, Duration = 1e-3 };
        var run = new LookAheadRun(simulator);
        Assert.Contains("lookAhead.timeStep", Assert.Throws<ArgumentOutOfRangeException>(() => run.Start(in late, tiny)).Message, StringComparison.Ordinal);
        Assert.False(run.IsRunning);
        run.Start(in ball, tiny);
        Assert.True(run.IsRunning);
    }
}
