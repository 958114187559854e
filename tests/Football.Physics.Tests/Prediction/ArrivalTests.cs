namespace FootballPhysics.Tests.Prediction;

/// <summary>Kicks that are to arrive with a speed, and targets on slopes: what is called a hit is one when it is played.</summary>
public sealed class ArrivalTests
{
    private const double Ground = 0.11;

    [Theory]
    [InlineData(6)]
    [InlineData(10)]
    public void A_ball_along_the_ground_arrives_with_the_speed(double speed)
    {
        var request = new AimRequest { From = new Vector3d(0, Ground, 0), Target = new Vector3d(3, Ground, -36), Speed = 33 };
        AimResult kick = new Aimer().FindAtSpeed(request, speed);
        Assert.Equal(AimStatus.Hit, kick.Status);
        Assert.True(kick.Rolls);
        Assert.Equal(speed, Played(request, in kick), 1e-3);
    }

    /// <summary>Along the ground the ball is slower there, in flight it is faster: there is none in between.</summary>
    [Fact]
    public void An_arrival_between_roll_and_flight_is_no_hit()
    {
        var request = new AimRequest { From = new Vector3d(0, Ground, 0), Target = new Vector3d(3, Ground, -36), Speed = 33 };
        var aimer = new Aimer();
        AimResult fastest = aimer.Find(request with { MaximumElevationDegrees = 0 });
        Assert.True(fastest.Rolls);
        Assert.InRange(Played(request, in fastest), 10.5, 11.9);
        for (double time = 1.2; time < 5; time += 0.05)
        {
            AimResult flight = aimer.FindAtTime(request with { MinimumElevationDegrees = 2 }, time);
            Assert.True(flight.Status != AimStatus.Hit || Played(request, in flight) > 12.5, $"{time}: {flight}");
        }

        Assert.Equal(AimStatus.NotConverged, aimer.FindAtSpeed(request, 12).Status);
    }

    /// <summary>The fastest kick of a volley flies over a low target, and the arrival of a known kick is reached all the same.</summary>
    [Theory]
    [InlineData(1.0, 0.4, 6.0, 14)]
    [InlineData(1.0, 0.5067014145116137, 5.968951163610441, 19.05)]
    [InlineData(1.0, 0.5408443884845515, 4.242710931378677, 13.9)]
    [InlineData(0.11, 1.2, 18.0, 24)]
    [InlineData(0.11, 0.11, 36.0, 26)]
    public void The_arrival_of_a_known_kick_is_found(double from, double height, double away, double speed)
    {
        var request = new AimRequest { From = new Vector3d(0, from, 0), Target = new Vector3d(-0.2, height, -away), Speed = speed };
        var aimer = new Aimer();
        AimResult known = aimer.Find(request);
        Assert.Equal(AimStatus.Hit, known.Status);
        double wanted = Played(request, in known);
        AimResult kick = aimer.FindAtSpeed(request with { Speed = 35 }, wanted);
        Assert.Equal(AimStatus.Hit, kick.Status);
        Assert.Equal(wanted, Played(request, in kick), 0.01);
    }

    /// <summary>Over the time of a lob the arrival falls and rises again: below the least there is none, at either arc above it.</summary>
    [Fact]
    public void An_arrival_slower_than_the_slowest_is_no_hit()
    {
        var request = new AimRequest { From = new Vector3d(0, Ground, 0), Target = new Vector3d(0, 1.5, -20), Speed = 35, MaximumElevationDegrees = 85 };
        var aimer = new Aimer();
        AimResult none = aimer.FindAtSpeed(request, 4);
        Assert.Equal(AimStatus.NotConverged, none.Status);
        double least = Played(request, in none);
        Assert.InRange(least, 4.5, 20);
        AimResult low = aimer.FindAtSpeed(request, least + 1);
        AimResult high = aimer.FindAtSpeed(request with { Arc = AimArc.High }, least + 1);
        Assert.Equal((AimStatus.Hit, AimStatus.Hit), (low.Status, high.Status));
        Assert.True(low.Time < none.Time && high.Time > none.Time);
        Assert.Equal(least + 1, Played(request, in low), 1e-3);
        Assert.Equal(least + 1, Played(request, in high), 1e-3);
        Assert.Equal(AimStatus.OutOfReach, aimer.FindAtSpeed(request, 35).Status);
    }

    [Fact]
    public void A_wall_before_the_target_is_told()
    {
        var wall = new Obstacle { Name = "wall", Shape = new BoxShape(new Vector3d(0, 2, -9), new Vector3d(4, 2, 0.1)) };
        var request = new AimRequest { From = new Vector3d(0, Ground, 0), Target = new Vector3d(0, 1.2, -18), Speed = 30, MaximumElevationDegrees = 20 };
        AimResult kick = new Aimer(new Scene { Obstacles = [wall] }).FindAtSpeed(request, 15);
        Assert.Equal((AimStatus.Blocked, "wall"), (kick.Status, kick.BlockedBy));
    }

    [Theory]
    [InlineData(0.02)]
    [InlineData(-0.01)]
    [InlineData(-0.02)]
    [InlineData(-0.05)]
    public void A_hit_on_a_slope_passes_the_target_that_was_asked_for(double rise)
    {
        var simulator = new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(0, 1, rise).Normalized() } });
        var aimer = new Aimer(simulator);
        int hits = 0;
        for (double away = 6; away < 25; away += 1.5)
        {
            Vector3d target = simulator.Launch(new Vector3d(1, -5, -away), Vector3d.Zero, Vector3d.Zero).Position;
            var request = new AimRequest { From = new Vector3d(0, Ground, 0), Target = target, Speed = 17 };
            AimResult kick = aimer.Find(request);
            if (kick.Status == AimStatus.Hit)
            {
                hits++;
                BallState ball = simulator.Launch(request.From, kick.Velocity, kick.Spin);
                double closest = double.PositiveInfinity;
                while (ball.Time < kick.Time + 0.1)
                {
                    simulator.Step(ref ball, 5e-4, new StepLog());
                    closest = Math.Min(closest, Vector3d.Distance(ball.Position, target));
                }

                // The tolerance, and half of what the ball goes in a step.
                Assert.InRange(closest, 0, request.Tolerance + (0.25e-3 * 17));
            }
        }

        Assert.InRange(hits, 8, 13);
    }

    /// <summary>A hit within the tolerance that came down a few tenths of a millisecond early was not accepted, so that no time from 1.240 to 1.250 s had a kick.</summary>
    [Fact]
    public void A_ground_target_is_hit_at_every_time_between_two_that_have_a_kick()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, Ground, 0),
            Target = new Vector3d(2.3089603126556426, Ground, -32.57194511712154),
            Speed = 35,
            TopSpin = -4.064963843703719,
        };
        var aimer = new Aimer();
        for (int i = 0; i <= 40; i++)
        {
            double time = 1.22 + (0.001 * i);
            AimResult kick = aimer.FindAtTime(request, time);
            Assert.Equal((AimStatus.Hit, i), (kick.Status, i));
            Assert.InRange(time - kick.Time, -1e-9, 1e-4);
        }

        AimResult arrival = aimer.FindAtSpeed(request, 22.967212148674307);
        Assert.Equal(AimStatus.Hit, arrival.Status);
        Assert.Equal(22.967212148674307, Played(request, in arrival), 1e-3);
    }

    private static double Played(AimRequest request, in AimResult kick)
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(request.From, kick.Velocity, kick.Spin);
        var log = new StepLog();
        bool touches = simulator.Run(ref ball, 2e-3, kick.Time, kick.Rolls ? StopAt.Time : StopAt.Impact, log);
        return (touches ? log.Events[log.Events.Count - 1].VelocityBefore : ball.Velocity).Length;
    }
}
