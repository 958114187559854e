using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>A look-ahead is the simulation itself, dense in time.</summary>
public sealed class LookAheadTests
{
    private static readonly Simulator s_simulator = new(Scene.Published);

    [Theory]
    [InlineData(Integrator.Euler)]
    [InlineData(Integrator.SemiImplicitEuler)]
    [InlineData(Integrator.Rk2)]
    [InlineData(Integrator.Rk4)]
    public void Its_events_and_its_end_are_those_of_a_run_bit_for_bit(Integrator integrator)
    {
        var simulator = new Simulator(Scene.Published, Flight.With(integrator));
        var path = new Trajectory(4096);
        foreach (BallState ball in Kicks(1, 20))
        {
            simulator.LookAhead(in ball, new LookAheadRequest { Duration = 60, TimeStep = 0.02 }, path);
            BallState state = ball;
            var log = new StepLog();
            simulator.Run(ref state, 0.02, 60, StopAt.Rest, log);
            Assert.True(path.IsComplete);
            Assert.Equal(log.Events.Count, path.Events.Count);
            for (int i = 0; i < log.Events.Count; i++)
            {
                Assert.Equal(log.Events[i].Kind, path.Events[i].Kind);
                Assert.Equal(log.Events[i].Time, path.Events[i].Time);
                Assert.Equal(log.Events[i].Position, path.Events[i].Position);
                Assert.Equal(log.Events[i].Velocity, path.Events[i].Velocity);
            }

            Assert.Equal(state.Position, path.Final.Position);
            Assert.Equal(state.Time, path.Final.Time);
        }
    }

    // Flight to the first touchdown; the jump of the drag law is located, so all kicks count.
    [Theory]
    [InlineData(0.01, 1e-7)]
    [InlineData(0.02, 1e-6)]
    [InlineData(0.04, 1e-5)]
    [InlineData(0.08, 1e-4)]
    public void Positions_in_between_are_those_of_a_run_in_steps_of_a_millisecond(double timeStep, double bound)
    {
        var coarse = new Trajectory();
        var fine = new Trajectory(8192);
        foreach (BallState ball in Kicks(2, 30))
        {
            s_simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = timeStep, StopAt = StopAt.Impact }, coarse);
            s_simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 0.001, StopAt = StopAt.Impact }, fine);
            double end = Math.Min(coarse.EndTime, fine.EndTime);
            for (double t = 0; t < end; t += 0.0037)
            {
                double error = Vector3d.Distance(coarse.PositionAt(t), fine.PositionAt(t));
                Assert.True(error <= bound, $"{error} at {t}");
                Assert.True(Vector3d.Distance(coarse.VelocityAt(t), fine.VelocityAt(t)) <= 30 * bound);
            }

            Assert.Equal(fine.Apex, coarse.Apex, bound);
            Assert.Equal(fine.HangTime, coarse.HangTime, bound);
            Assert.Equal(fine.Carry, coarse.Carry, 3 * bound);
        }
    }

    [Fact]
    public void Apex_carry_and_hang_time_are_those_of_the_events()
    {
        var path = new Trajectory();
        foreach (BallState ball in Kicks(3, 30))
        {
            s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 60 }, path);
            Assert.True(path.TryGetTouchdown(0, out BallEvent first));
            Assert.Equal(first.Time, path.HangTime);
            Assert.Equal((first.Position - ball.Position).Horizontal.Length, path.Carry);
            double highest = 0;
            for (double t = 0; t < path.EndTime; t += 0.001)
            {
                highest = Math.Max(highest, path.PositionAt(t).Y);
            }

            Assert.InRange(path.Apex, highest, highest + 1e-5);
            int touchdowns = 0;
            while (path.TryGetTouchdown(touchdowns, out BallEvent next))
            {
                Assert.Equal(0.11, next.Position.Y, 1e-9);
                touchdowns++;
            }

            int impacts = path.Events.Span.ToArray().Count(item => item.Kind == BallEventKind.Impact);
            Assert.Equal(impacts, touchdowns);
            Assert.True(path.TryGetRest(out BallEvent rest));
            Assert.Equal(path.Final.Position, rest.Position);
            Assert.Equal(path.Final.Position, path.PositionAt(path.EndTime + 5));
            Assert.Equal(Vector3d.Zero, path.VelocityAt(path.EndTime + 5));
        }
    }

    [Fact]
    public void A_ball_that_still_rolls_at_the_end_has_no_rest()
    {
        var path = new Trajectory();
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, 7, -23), new Vector3d(10, 30, 0));
        s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 10 }, path);
        Assert.Equal(BallEventKind.Roll, path.Events[path.Events.Count - 1].Kind);
        Assert.False(path.TryGetRest(out BallEvent none));
        Assert.Equal(default, none.Position);
        s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 20 }, path);
        Assert.True(path.TryGetRest(out BallEvent rest));
        Assert.InRange(rest.Time, 10, 20);
    }

    [Fact]
    public void A_crossing_lies_on_its_plane_and_no_earlier_one_is_missed()
    {
        var random = new Shots(4);
        var path = new Trajectory();
        int crossed = 0;
        foreach (BallState ball in Kicks(4, 100))
        {
            s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 60 }, path);
            var plane = new Plane3d(ball.Position + (random.Uniform(1, 20) * random.Direction()), random.Direction());
            double first = double.PositiveInfinity;
            double before = Vector3d.Dot(path.PositionAt(0) - plane.Point, plane.Normal);
            for (double t = 0.001; t < path.EndTime && double.IsInfinity(first); t += 0.001)
            {
                double now = Vector3d.Dot(path.PositionAt(t) - plane.Point, plane.Normal);
                first = before < 0 != now < 0 ? t : first;
                before = now;
            }

            if (path.TryGetCrossing(in plane, out PathPoint crossing))
            {
                crossed++;
                Assert.Equal(0, Vector3d.Dot(crossing.Position - plane.Point, plane.Normal), 1e-11);
                Assert.Equal(crossing.Position, path.PositionAt(crossing.Time));
                Assert.True(double.IsInfinity(first) || Math.Abs(crossing.Time - first) <= 0.0011 || crossing.Time < first, $"{crossing.Time} {first}");
            }
            else
            {
                Assert.True(double.IsInfinity(first), $"{first}");
            }
        }

        Assert.InRange(crossed, 20, 100);
    }

    [Fact]
    public void The_closest_approach_is_that_of_a_fine_scan()
    {
        var random = new Shots(5);
        var path = new Trajectory();
        foreach (BallState ball in Kicks(5, 100))
        {
            s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 60 }, path);
            Vector3d point = new(random.Uniform(-25, 25), random.Uniform(0, 5), random.Uniform(-25, 25));
            PathPoint closest = path.ClosestApproach(point);
            double best = double.PositiveInfinity;
            for (double t = 0; t < path.EndTime; t += 0.001)
            {
                best = Math.Min(best, Vector3d.Distance(path.PositionAt(t), point));
            }

            Assert.InRange(closest.Distance, best - 0.02, best + 1e-12);
            Assert.Equal(closest.Distance, Vector3d.Distance(closest.Position, point), 1e-12);

            // Where two pieces meet they agree to rounding.
            Assert.Equal(0, Vector3d.Distance(closest.Position, path.PositionAt(closest.Time)), 1e-14);
        }
    }

    [Fact]
    public void It_stops_as_soon_as_what_was_asked_is_known_and_the_answer_is_the_same()
    {
        var whole = new Trajectory();
        var early = new Trajectory();
        var forward = new Vector3d(1, 0, 0);
        var plane = new Plane3d(new Vector3d(5, 0, 0), forward);
        var point = new Vector3d(6, 1, 0);
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(22, 7, 0), new Vector3d(0, 20, 0));
        var request = new LookAheadRequest { Duration = 60 };
        s_simulator.LookAhead(in ball, request, whole);
        s_simulator.LookAhead(in ball, request with { UntilPlane = plane }, early);
        Assert.True(early.IsComplete);
        Assert.True(whole.Evaluations > 5 * early.Evaluations, $"{early.Evaluations} of {whole.Evaluations}");
        Assert.True(whole.TryGetCrossing(in plane, out PathPoint late));
        Assert.True(early.TryGetCrossing(in plane, out PathPoint soon));
        Assert.Equal(late.Time, soon.Time);
        Assert.Equal(late.Position, soon.Position);

        s_simulator.LookAhead(in ball, request with { UntilPassing = point }, early);
        Assert.True(whole.Evaluations > 5 * early.Evaluations);
        Assert.Equal(whole.ClosestApproach(point).Distance, early.ClosestApproach(point).Distance);

        s_simulator.LookAhead(in ball, request with { StopAt = StopAt.Impact }, early);
        Assert.True(whole.Evaluations > early.Evaluations);
        Assert.Equal(1, early.Events.Count);
    }

    [Fact]
    public void Where_the_memory_is_full_it_says_so()
    {
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(22, 7, 0), default);
        var small = new Trajectory(new PathSegment[5]);
        s_simulator.LookAhead(in ball, new LookAheadRequest(), small);
        Assert.False(small.IsComplete);
        Assert.Equal(5, small.Pieces.Length);
        var large = new Trajectory();
        s_simulator.LookAhead(in ball, new LookAheadRequest(), large);
        Assert.True(large.IsComplete);
        for (double t = 0; t < small.EndTime; t += 0.01)
        {
            Assert.Equal(large.PositionAt(t), small.PositionAt(t));
        }

        s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.1 }, small);
        Assert.True(small.IsComplete);
    }

    /// <summary>A trajectory with its own buffer grows, with the path of a larger one to the bit, and then keeps its size.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(300)]
    public void One_that_is_too_small_grows_and_keeps_its_size(int capacity)
    {
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(22, 7, 0), default);
        var request = new LookAheadRequest { TimeStep = 0.005 };
        var grown = new Trajectory(capacity);
        var large = new Trajectory(8192);
        s_simulator.LookAhead(in ball, request, grown);
        s_simulator.LookAhead(in ball, request, large);
        Assert.True(grown.IsComplete && grown.Pieces.Length > 1000);
        Assert.Equal(large.Pieces.ToArray(), grown.Pieces.ToArray());
        Assert.Equal(large.Evaluations, grown.Evaluations);
        Assert.Equal(0, Allocation.Of(() => s_simulator.LookAhead(in ball, request, grown)));
    }

    [Fact]
    public void It_allocates_nothing()
    {
        var path = new Trajectory();
        var request = new LookAheadRequest { UntilPlane = new Plane3d(new Vector3d(90, 0, 0), new Vector3d(1, 0, 0)) };
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(22, 7, 0), new Vector3d(0, 20, 0));
        Assert.Equal(0, Allocation.Of(() =>
        {
            s_simulator.LookAhead(in ball, request, path);
            _ = path.Apex + path.Carry + path.HangTime + path.ClosestApproach(new Vector3d(10, 1, 0)).Distance + path.PositionAt(1).X;
        }));
    }

    private static IEnumerable<BallState> Kicks(int seed, int count)
    {
        var random = new Shots(seed);
        for (int i = 0; i < count; i++)
        {
            yield return s_simulator.Launch(new Vector3d(0, 0.11, 0), random.Velocity(8, 32, 3, 60), random.Uniform(0, 60) * random.Direction());
        }
    }
}
