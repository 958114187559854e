namespace FootballPhysics.Tests.Several;

/// <summary>A crowd of balls in a box of boards, with and without bodies: impacts lie on the boards, paths have no gaps, and a ball that a body covers is pinned.</summary>
public sealed class CrowdTests
{
    private const double Half = 0.6;

    [Theory]
    [InlineData(1.0 / 60)]
    [InlineData(1.0 / 30)]
    [InlineData(0.1)]
    public void Impacts_lie_on_the_boards_and_paths_have_no_gaps(double step)
    {
        int impacts = 0;
        int rests = 0;
        for (int draw = 0; draw < 8; draw++)
        {
            BallGroup group = Crowd(draw, bodies: false, out BallState[] balls);
            Trajectory[] paths = [.. balls.Select(_ => new Trajectory(8192))];
            group.LookAhead(balls, new LookAheadRequest { Duration = 3, TimeStep = step, StopAt = StopAt.Time }, paths);
            foreach (Trajectory path in paths)
            {
                Assert.True(path.IsComplete);
                impacts += path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact && e.OtherBall < 0).Count(e =>
                {
                    double gap = e.ColliderIndex == 0 ? e.Position.Y - 0.11 : Half + Vector3d.Dot(e.Position, e.Normal) - 0.11;
                    Assert.InRange(gap, -1e-9, 1e-9);
                    Assert.InRange(Vector3d.Distance(path.PositionAt(e.Time), e.Position), 0, 1e-9);
                    return true;
                });
                for (int i = 1; i < path.Pieces.Length; i++)
                {
                    PathSegment last = path.Pieces[i - 1];
                    PathSegment next = path.Pieces[i];
                    Assert.InRange(next.Time - last.EndTime, -1e-7, 1e-7);
                    Assert.InRange(Vector3d.Distance(next.StartPosition, last.EndPosition), 0, 1e-6);
                    rests += next.Motion == MotionState.Rest ? 1 : 0;
                }
            }
        }

        Assert.True(impacts > 400, $"{impacts} impacts");
        Assert.True(rests > 0);
    }

    /// <summary>A ball that rests, and is hit later, has a path for the time of its rest, on which it stands still.</summary>
    [Fact]
    public void A_rest_has_a_segment()
    {
        var group = new BallGroup(new Simulator(), 2);
        BallState[] balls = [group.SimulatorOf(0).Launch(new Vector3d(0, 0.11, 0), new Vector3d(0.1, 0, 0), default), group.SimulatorOf(1).Launch(new Vector3d(-2, 0.11, 0), new Vector3d(3, 0, 0), default)];
        Trajectory[] paths = [new Trajectory(512), new Trajectory(512)];
        group.LookAhead(balls, new LookAheadRequest { Duration = 4, TimeStep = 1.0 / 60, StopAt = StopAt.Time }, paths);
        PathSegment rest = Assert.Single(paths[0].Pieces.ToArray(), piece => piece.Motion == MotionState.Rest);
        Assert.InRange(rest.Length, 0.3, 3);
        double middle = rest.Time + (0.5 * rest.Length);
        Assert.Equal(Vector3d.Zero, paths[0].VelocityAt(middle));
        Assert.Equal(rest.StartPosition, paths[0].PositionAt(middle));
    }

    [Fact]
    public void A_ball_that_a_body_covers_at_the_end_of_a_step_is_pinned()
    {
        int pinned = 0;
        for (int draw = 0; draw < 30; draw++)
        {
            BallGroup group = Crowd(draw, bodies: true, out BallState[] balls);
            Simulator simulator = group.SimulatorOf(0);
            var log = new StepLog();
            for (int step = 0; step < 60; step++)
            {
                log.Clear();
                group.Step(balls, 1.0 / 60, log);
                foreach (BallState ball in balls)
                {
                    pinned += ball.Motion == MotionState.Pinned ? 1 : 0;
                    double deepest = simulator.World.Colliders.Where(collider => collider.Moves).Max(collider => 0.11 - collider.At(ball.Position, ball.Time).Distance);
                    Assert.True(deepest <= 5e-6 || ball.Motion == MotionState.Pinned, $"draw {draw} step {step}: {deepest} m inside, {ball}");
                }
            }
        }

        Assert.True(pinned > 20, $"{pinned} pinned");
    }

    private static BallGroup Crowd(int draw, bool bodies, out BallState[] balls)
    {
        var random = new Random(draw);
        double Draw(double low, double high) => low + (random.NextDouble() * (high - low));
        Obstacle Board(double x, double z) => new() { Name = "board", Shape = new PlaneShape(Half * new Vector3d(x, 0, z), new Vector3d(-x, 0, -z)), Surface = SurfaceMaterial.Board };
        KinematicBodies? crowd = bodies ? new KinematicBodies() : null;
        for (int i = 0; i < 3 && crowd is not null; i++)
        {
            crowd.Add("body", BodyKind.Player.Shape, BodyKind.Player.Surface).MoveTo(
                new Vector3d(Draw(-1.2, -0.9) * (i == 0 ? 1 : -1), 0, Draw(-0.6, 0.6)), new Vector3d(Draw(0.5, 3) * (i == 0 ? 1 : -1), 0, Draw(-1, 1)), 0);
        }

        var group = new BallGroup(new Simulator(new Scene { Obstacles = [Board(1, 0), Board(-1, 0), Board(0, 1), Board(0, -1)], Bodies = crowd }), 8);
        balls =
        [
            .. Enumerable.Range(0, 8).Select(i => group.SimulatorOf(i).Launch(
                new Vector3d((0.24 * (i % 3)) - 0.24, 0.15 + (0.3 * (i / 3)), Draw(-0.3, 0.3)), new Vector3d(Draw(-5, 5), Draw(-2, 2), Draw(-5, 5)), new Vector3d(Draw(-20, 20), Draw(-20, 20), 0))),
        ];
        return group;
    }
}
