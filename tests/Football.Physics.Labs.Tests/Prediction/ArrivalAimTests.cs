using System.Text.Json;
using FootballPhysics.Aiming;
using FootballPhysics.Prediction;

namespace FootballPhysics.Labs.Tests.Prediction;

/// <summary>Kicks that arrive as they are asked to, and after what is to be met before.</summary>
public sealed class ArrivalAimTests
{
    private const string Aim = "\"from\":[0,0.11,0],\"target\":[20,1.5,3],\"speed\":30";

    [Theory]
    [InlineData(15.0)]
    [InlineData(20.0)]
    public void A_kick_arrives_with_the_speed_asked_for(double speed)
    {
        var aimer = new Aimer();
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(20, 1.5, 3), Speed = 35 };
        AimResult found = aimer.FindAtSpeed(request, speed);
        Assert.Equal(AimStatus.Hit, found.Status);
        var simulator = new Simulator();
        BallState state = simulator.Launch(request.From, found.Velocity, found.Spin);
        simulator.Run(ref state, 0.005, found.Time, StopAt.Time, new StepLog());
        Assert.Equal(speed, state.Velocity.Length, 4);
    }

    [Fact]
    public void A_speed_that_no_kick_arrives_with_is_out_of_reach()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(20, 1.5, 3), Speed = 20 };
        Assert.Equal(AimStatus.OutOfReach, new Aimer().FindAtSpeed(request, 25).Status);
    }

    [Theory]
    [InlineData("ground")]
    [InlineData("wall")]
    public void A_kick_goes_where_another_one_came_after_what_it_met(string thing)
    {
        Scene scene = Scene.Measured with
        {
            Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-6, 0, 0), new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.PublishedGoalFrame }],
        };
        var simulator = new Simulator(scene);
        Vector3d velocity = thing == "ground" ? new Vector3d(1, 4, -14) : new Vector3d(-12, 5, -10);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, KickVectors.Spin(velocity, 5, 10));
        var path = new Trajectory();
        simulator.LookAhead(in state, new LookAheadRequest { Duration = 3, TimeStep = 0.01, StopAt = StopAt.Time }, path);
        BallEvent met = path.Events[0];
        Assert.Equal(thing, simulator.NameOf(met.ColliderIndex));
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = path.PositionAt(met.Time + 0.2),
            Speed = velocity.Length,
            TopSpin = 5,
            SideSpin = 10,
            Tolerance = 0.001,
        };
        AimResult found = new BankShotAimer(scene).Find(request, thing);
        Assert.Equal(AimStatus.Hit, found.Status);
        Assert.InRange(found.Miss, 0, 1e-3);

        // Flown: it meets that, and then the target.
        BallState again = simulator.Launch(request.From, found.Velocity, found.Spin);
        simulator.LookAhead(in again, new LookAheadRequest { Duration = found.Time, TimeStep = 0.005, StopAt = StopAt.Time }, path);
        Assert.Equal(thing, simulator.NameOf(path.Events[0].ColliderIndex));
        Assert.Equal(1, path.Events.Count);
        Assert.InRange(Vector3d.Distance(path.Final.Position, request.Target), 0, 1.1e-3);
        Assert.Equal(request.Speed, found.Velocity.Length, 9);
    }

    [Fact]
    public void What_is_not_there_cannot_be_met()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(20, 1.5, 3) };
        ArgumentException refused = Assert.ThrowsAny<ArgumentException>(() => new BankShotAimer().Find(request, "wall"));
        Assert.Contains("aim.after[0] is wall; allowed: ground.", refused.Message);
        Assert.Contains("aim.after is []", Assert.ThrowsAny<ArgumentException>(() => new BankShotAimer().Find(request)).Message);
    }

    [Fact]
    public void The_command_takes_arc_slowest_arrival_and_a_moving_target()
    {
        double Speed(string more) => Velocity(Find(more)).Length;
        Assert.True(Speed(",\"slowest\":true") < Speed(",\"arrival\":{\"time\":1.1}"));
        Assert.Equal(1.1, Find(",\"arrival\":{\"time\":1.1}").GetProperty("time").GetDouble(), 6);
        Assert.Equal("high", Find(",\"arc\":\"high\",\"elevation\":{\"max\":85}").GetProperty("arc").GetString());
        Assert.NotEqual(Velocity(Find("")), Velocity(Find(",\"targetVelocity\":[0,0,3]")));
        Assert.Equal("hit", Find(",\"arrival\":{\"speed\":18}").GetProperty("status").GetString());
    }

    [Theory]
    [InlineData(",\"slowest\":true,\"arrival\":{\"time\":1}", "aim.slowest")]
    [InlineData(",\"arrival\":{\"time\":1,\"speed\":3}", "aim.arrival.time")]
    [InlineData(",\"arrival\":{\"time\":-1}", "aim.arrival.time is -1; allowed: a finite number above 0")]
    [InlineData(",\"after\":\"wall\"", "aim.after is \"wall\"; allowed: a list of texts")]
    [InlineData(",\"targetVelocity\":[0,0,3],\"through\":[10,2,1]", "aim.targetVelocity cannot be combined with aim.through")]
    [InlineData(",\"slowest\":true,\"method\":\"angle\"", "aim.method is \"angle\"; allowed: direct, with slowest, arrival or after")]
    public void What_excludes_each_other_is_refused(string more, string message)
    {
        FootballCommand done = FootballCommand.Run("{\"aim\":{" + Aim + more + "}}", "aim", "-");
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(message, done.Error);
    }

    private static JsonElement Find(string more)
    {
        FootballCommand done = FootballCommand.Run("{\"aim\":{" + Aim + more + "}}", "aim", "-");
        Assert.Equal("", done.Error);
        return done.Result;
    }

    private static Vector3d Velocity(JsonElement of)
    {
        JsonElement v = of.GetProperty("velocity");
        return new Vector3d(v[0].GetDouble(), v[1].GetDouble(), v[2].GetDouble());
    }
}
