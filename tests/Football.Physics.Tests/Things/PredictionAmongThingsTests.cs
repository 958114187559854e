using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Paths that are predicted among things.</summary>
public sealed class PredictionAmongThingsTests
{
    private static readonly SolverSettings s_rk4 = Flight.With(Integrator.Rk4);

    [Theory]
    [ProfileData]
    public void A_trajectory_tells_a_touchdown_from_a_hit(Profile profile)
    {
        Scene scene = profile.Scene() with { Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -10), new Vector3d(0, 0, 1)) }] };
        var simulator = new Simulator(scene, s_rk4);
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 3, -20), Vector3d.Zero), new LookAheadRequest(), path);
        Assert.True(path.TryGetHit(0, out BallEvent hit));
        Assert.True(path.TryGetTouchdown(0, out BallEvent touchdown));
        Assert.Equal("wall", simulator.NameOf(hit.ColliderIndex));
        Assert.Equal("ground", simulator.NameOf(touchdown.ColliderIndex));
        Assert.True(hit.Time < touchdown.Time);
        Assert.False(path.TryGetHit(1, out _));
        Assert.Equal(touchdown.Time, path.HangTime);
    }

    [Theory]
    [ProfileData]
    public void A_look_ahead_meets_a_body_on_the_path_that_the_game_gives_and_leaves_it_where_it_is(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody foot = bodies.Add("foot", new SphereShape(Vector3d.Zero, 0.15), SurfaceMaterial.Boot);
        var simulator = new Simulator(profile.Scene() with { Bodies = bodies }, s_rk4);

        // It swings on a circle, which is not how it goes at any one moment.
        void Swing(double time) => foot.MoveTo(
            new Vector3d(0, 1 - Math.Cos(4 * (time - 0.5)) + 0.2, -8 + (1.5 * Math.Sin(4 * (time - 0.5)))),
            new Vector3d(0, 4 * Math.Sin(4 * (time - 0.5)), 6 * Math.Cos(4 * (time - 0.5))),
            time);
        Swing(0);
        Vector3d before = foot.Position;
        BallState ball = simulator.Launch(new Vector3d(0, 0.4, 0), new Vector3d(0, 2, -16), Vector3d.Zero);
        BallState played = ball;
        var log = new StepLog();
        for (int tick = 0; tick < 100; tick++)
        {
            Swing(played.Time);
            simulator.Step(ref played, 0.01, log);
        }

        Swing(0);
        var request = new LookAheadRequest { Duration = 1, TimeStep = 0.01, MoveBodies = Swing, StopAt = StopAt.Time };
        var path = new Trajectory();
        simulator.LookAhead(in ball, request, path);
        Assert.True(path.TryGetHit(0, out BallEvent hit));
        Assert.Equal("foot", simulator.NameOf(hit.ColliderIndex));
        Assert.Equal(0, (played.Position - path.Final.Position).Length, 1e-9);
        Assert.Equal(before, foot.Position);
        Assert.Equal(0, foot.Time);

        // A kept prediction does the same, and a request without it sees the body go on straight.
        var kept = new TrajectoryCache(simulator, request);
        kept.Update(in ball);
        Assert.Equal(hit.Time, kept.Path.TryGetHit(0, out BallEvent again) ? again.Time : 0);
        Assert.Equal(before, foot.Position);
        simulator.LookAhead(in ball, request with { MoveBodies = null }, path);
        Assert.False(path.TryGetHit(0, out BallEvent other) && other.Time == hit.Time);
    }

    [Theory]
    [ProfileData]
    public void A_batch_among_things_that_stand_still_has_the_rows_of_the_single_ball(Profile profile)
    {
        Scene scene = Pitch.Stadium.On(profile.Scene());
        const int Count = 400;
        var launches = new BatchLaunches(Count);
        var flights = new BatchFlights(Count);
        var random = new Random(5);
        for (int i = 0; i < Count; i++)
        {
            double angle = random.NextDouble() * 2 * Math.PI;
            double speed = 8 + (18 * random.NextDouble());
            launches.Position[i] = new Vector3d((random.NextDouble() - 0.5) * 60, Flight.Radius, (random.NextDouble() - 0.5) * 100);
            launches.Velocity[i] = new Vector3d(speed * Math.Cos(angle), 2 + (8 * random.NextDouble()), speed * Math.Sin(angle));
            launches.Spin[i] = new Vector3d(random.NextDouble() * 20, random.NextDouble() * 40, 0);
        }

        var batch = new BallBatch(scene);
        batch.Fly(launches, flights, Count);
        var simulator = new Simulator(scene, new SolverSettings { Integrator = batch.Settings.Integrator });
        int hits = 0;
        for (int i = 0; i < Count; i++)
        {
            BallState ball = simulator.Launch(launches.Position[i], launches.Velocity[i], launches.Spin[i]);
            var log = new StepLog();
            Assert.True(simulator.Run(ref ball, batch.TimeStep, 30, StopAt.Impact, log));
            BallEvent impact = log.Events[log.Events.Count - 1];
            hits += impact.ColliderIndex > 0 ? 1 : 0;
            Assert.Equal(BatchEnd.Impact, flights.End[i]);
            Assert.Equal(0, (impact.Position - flights.Position[i]).Length, 5e-3);
            Assert.Equal(0, (impact.Velocity - flights.VelocityAfter[i]).Length, 5e-3);
        }

        Assert.InRange(hits, 10, 200);
        Assert.InRange(batch.ScalarFallbackCount, hits, (9 * Count) / 10);
    }
}
