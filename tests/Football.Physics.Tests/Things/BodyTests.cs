using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Bodies that the game moves.</summary>
public sealed class BodyTests
{
    private const double Tick = 0.01;

    private static readonly SolverSettings s_rk4 = Flight.With(Integrator.Rk4);

    [Theory]
    [ProfileData]
    public void A_body_hits_as_an_obstacle_of_the_same_velocity_does(Profile profile)
    {
        var velocity = new Vector3d(0.1, -0.3, 8);
        var spin = new Vector3d(3, -2, 1);
        var from = new Vector3d(-0.05, 0.3, -3);
        var obstacle = new Obstacle { Name = "foot", Shape = new SphereShape(from, 0.15), Surface = SurfaceMaterial.Boot, Velocity = velocity, Spin = spin, Pivot = from };
        BallState expected = Played(profile.Scene() with { Obstacles = [obstacle] }, _ => { }, out string[] events);

        var bodies = new KinematicBodies();
        KinematicBody foot = bodies.Add("foot", new SphereShape(Vector3d.Zero, 0.15), SurfaceMaterial.Boot);
        void Move(double time) => foot.MoveTo(from + (time * velocity), Quaterniond.Identity, velocity, spin, time);
        BallState actual = Played(profile.Scene() with { Bodies = bodies }, Move, out string[] again);
        Assert.Contains("Impact foot", events);
        Assert.Equal(events, again);

        // The foot hits the ball again and again, and each hit on a ball of 15 cm magnifies the rounding of its place about a hundredfold.
        Assert.Equal(0, (expected.Position - actual.Position).Length, 1e-7);
        Assert.Equal(0, (expected.Spin - actual.Spin).Length, 1e-6);
    }

    [Theory]
    [ProfileData]
    public void A_body_that_is_turned_is_its_shape_turned(Profile profile)
    {
        Quaterniond turn = Quaterniond.FromAxisAngle(new Vector3d(0.6, 0, 0.8), 0.7);
        var at = new Vector3d(0.2, 1, -4);
        var half = new Vector3d(0.5, 0.3, 0.2);
        Scene fixedScene = profile.Scene() with { Obstacles = [new Obstacle { Name = "board", Shape = new BoxShape(at, half, turn), Surface = SurfaceMaterial.Board }] };
        var bodies = new KinematicBodies();
        KinematicBody board = bodies.Add("board", new BoxShape(Vector3d.Zero, half), SurfaceMaterial.Board);
        board.MoveTo(at, turn, Vector3d.Zero, Vector3d.Zero, 0);
        BallState expected = Played(fixedScene, _ => { }, out string[] events, new Vector3d(1, 4, -18));
        BallState actual = Played(profile.Scene() with { Bodies = bodies }, _ => { }, out string[] again, new Vector3d(1, 4, -18));
        Assert.Contains("Impact board", events);
        Assert.Equal(events, again);
        Assert.Equal(0, (expected.Position - actual.Position).Length, 1e-8);
    }

    [Theory]
    [ProfileData(0.05, 0.11, 0)]
    [ProfileData(0, 0.2, 0.05)]
    [ProfileData(0, 0.35, 0)]
    [ProfileData(-0.005, 0.4195, 0)]
    [ProfileData(-0.1, 0.6, -0.1)]
    public void A_body_put_over_the_ball_pushes_it_out_and_gives_it_no_speed(Profile profile, double x, double y, double z)
    {
        var bodies = new KinematicBodies();
        KinematicBody boot = bodies.Add("boot", new SphereShape(Vector3d.Zero, 0.2));
        boot.MoveTo(new Vector3d(50, 50, 50), Vector3d.Zero, 0);
        var simulator = new Simulator(profile.Scene() with { Bodies = bodies }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, Flight.Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Step(ref state, Tick, log);
        boot.MoveTo(new Vector3d(x, y, z), Vector3d.Zero, state.Time);
        bool over = (boot.Position - state.Position).Length < 0.2 + Flight.Radius;
        simulator.Step(ref state, Tick, log);
        Assert.InRange((boot.Position - state.Position).Length, 0.2 + Flight.Radius - 1e-9, over ? 0.2 + Flight.Radius + 1e-9 : 10);
        Assert.Equal(Flight.Radius, state.Position.Y, 1e-12);
        Assert.Equal(0, state.Velocity.Length, 1e-12);
    }

    [Fact]
    public void A_body_that_comes_up_under_a_ball_hits_it()
    {
        var bodies = new KinematicBodies();
        KinematicBody tray = bodies.Add("tray", new BoxShape(Vector3d.Zero, new Vector3d(1, 0.1, 1)), SurfaceMaterial.Wood);
        tray.MoveTo(new Vector3d(0, 2, 0), Vector3d.Zero, 0);
        var simulator = new Simulator(new Scene { Bodies = bodies }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 2.1 + Flight.Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, Tick, 0.2, StopAt.Time, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        log.Clear();
        tray.MoveTo(new Vector3d(0, 2, 0), new Vector3d(0, 2, 0), state.Time);
        simulator.Step(ref state, Tick, log);
        BallEvent hit = Flight.First(log, BallEventKind.Impact);
        Assert.Equal("tray", simulator.NameOf(hit.ColliderIndex));
        double e = 0.65 * Math.Sqrt((1 + (36.0 / 900)) / (1 + (4.0 / 900)));
        Assert.Equal(2 * (1 + e), hit.Velocity.Y, 1e-3);
        Assert.Equal(MotionState.Airborne, state.Motion);
    }

    [Theory]
    [ProfileData]
    public void A_ball_lies_on_a_body_until_that_is_taken_away(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody tray = bodies.Add("tray", new BoxShape(Vector3d.Zero, new Vector3d(1, 0.1, 1)), SurfaceMaterial.Wood);
        tray.MoveTo(new Vector3d(0, 2, 0), Vector3d.Zero, 0);
        var simulator = new Simulator(profile.Scene() with { Bodies = bodies }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 2.5, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, Tick, 10, StopAt.Rest, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(2.1 + Flight.Radius, state.Position.Y, 1e-9);
        for (int i = 0; i < 50; i++)
        {
            tray.MoveTo(tray.Position + new Vector3d(0.002, 0, 0), new Vector3d(0.2, 0, 0), state.Time);
            simulator.Step(ref state, Tick, log);
        }

        Assert.NotEqual(MotionState.Airborne, state.Motion);
        Assert.InRange(state.Position.X, 0.001, 0.2);
        tray.MoveTo(new Vector3d(0, -5, 0), Vector3d.Zero, state.Time);
        simulator.Step(ref state, Tick, log);
        Assert.Equal(MotionState.Airborne, state.Motion);
        simulator.Run(ref state, Tick, 20, StopAt.Rest, log);
        Assert.Equal(Flight.Radius, state.Position.Y, 1e-9);
    }

    [Fact]
    public void Bodies_are_listed_in_the_order_of_their_addition()
    {
        var bodies = new KinematicBodies();
        KinematicBody[] added = [bodies.Add("right foot", new SphereShape(Vector3d.Zero, 0.1)), bodies.Add("left foot", new SphereShape(Vector3d.Zero, 0.1))];
        var listed = new List<object>();
        foreach (object body in (System.Collections.IEnumerable)bodies)
        {
            listed.Add(body);
        }

        Assert.Equal(added, listed);
        Assert.Equal(added, bodies);
    }

    [Theory]
    [ProfileData]
    public void Whatever_the_game_does_with_bodies_the_ball_is_in_none_of_them_and_its_energy_is_theirs(Profile profile)
    {
        for (int seed = 0; seed < 40; seed++)
        {
            var random = new Random(seed);
            double Range(double low, double high) => low + ((high - low) * random.NextDouble());
            Vector3d Place() => new(Range(-2, 2), Range(0.3, 2), Range(-2, 2));
            var bodies = new KinematicBodies();
            for (int i = 0; i < 6; i++)
            {
                bodies.Add($"body {i}", i % 2 == 0 ? new SphereShape(Vector3d.Zero, Range(0.1, 0.4)) : new CapsuleShape(Vector3d.Zero, Place(), Range(0.05, 0.2)));
            }

            var simulator = new Simulator(profile.Scene() with { Bodies = bodies }, s_rk4);
            BallState state = simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, Vector3d.Zero);
            var log = new StepLog();
            double fastest = 0;
            for (int tick = 0; tick < 300; tick++)
            {
                foreach (KinematicBody body in bodies)
                {
                    bool jumps = random.Next(20) == 0;
                    Vector3d velocity = random.Next(5) == 0 ? 4 * Place() : body.Velocity;
                    Quaterniond orientation = random.Next(5) == 0 ? Quaterniond.FromRotationVector(Place()) : body.Orientation;
                    Vector3d place = jumps ? Place() : body.Position + ((state.Time - body.Time) * body.Velocity);
                    body.MoveTo(place.Length > 6 ? Place() : place, orientation, velocity, Vector3d.Zero, state.Time);
                    fastest = Math.Max(fastest, velocity.Length);
                }

                log.Clear();
                simulator.Step(ref state, Tick, log);
                Assert.True(state.Position.IsFinite && state.Spin.IsFinite, $"scene {seed}, tick {tick}");
                Assert.True(state.Velocity.Length < 4 * (fastest + 10), $"scene {seed}, tick {tick}: {state.Velocity}");
                Assert.True(log.Steps < 4000, $"scene {seed}, tick {tick}: {log.Steps} pieces");
                Assert.True(state.Position.Y >= Flight.Radius - 1e-9, $"scene {seed}, tick {tick}: {state.Position}");
                double[] gaps = [.. bodies.Select(body => body.Placement.Motion.At(body.Shape, state.Position, state.Time).Distance - Flight.Radius)];

                // Between two bodies that close in on it, or one and the ground, there may be no place for it: it may end the step apart from one of them, and squeezed.
                Assert.True(state.Motion == MotionState.Pinned || gaps.Count(gap => gap < 0.02) > 1 || state.Position.Y < Flight.Radius + 0.02 || gaps.Min() > -1e-9, $"scene {seed}, tick {tick}: {gaps.Min()} m, {state.Motion}");
            }
        }
    }

    [Theory]
    [ProfileData]
    public void Moving_bodies_and_stepping_among_them_allocates_nothing(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody leg = bodies.Add("leg", new CapsuleShape(Vector3d.Zero, new Vector3d(0, 0.8, 0), 0.1));
        var simulator = new Simulator(profile.Scene() with { Bodies = bodies }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 2, -5), Vector3d.Zero);
        var log = new StepLog();
        void Play(int ticks)
        {
            for (int i = 0; i < ticks; i++)
            {
                leg.MoveTo(new Vector3d(0.05, 0, -4 + (0.1 * (i % 30))), new Vector3d(0, 0, 3), state.Time);
                log.Clear();
                simulator.Step(ref state, Tick, log);
            }
        }

        Assert.Equal(0, Allocation.Of(() => Play(200)));
    }

    [Theory]
    [ProfileData]
    public void What_is_wrong_is_refused_by_name(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody leg = bodies.Add("leg", new SphereShape(Vector3d.Zero, 0.1));
        Assert.Equal("velocity", Assert.Throws<ArgumentOutOfRangeException>(() => leg.MoveTo(Vector3d.Zero, new Vector3d(2000, 0, 0), 0)).ParamName);
        Assert.Equal("position", Assert.Throws<ArgumentOutOfRangeException>(() => leg.MoveTo(new Vector3d(double.NaN, 0, 0), Vector3d.Zero, 0)).ParamName);
        _ = new Simulator(profile.Scene() with { Bodies = bodies });
        Assert.Contains("after a Simulator was built with these bodies", Assert.Throws<InvalidOperationException>(() => bodies.Add("arm", leg.Shape)).Message);
    }

    private static BallState Played(Scene scene, Action<double> before, out string[] events, Vector3d velocity = default)
    {
        var simulator = new Simulator(scene, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, Flight.Radius, 0), velocity, Vector3d.Zero);
        var log = new StepLog();
        for (int i = 0; i < 100; i++)
        {
            before(state.Time);
            simulator.Step(ref state, Tick, log);
        }

        events = [.. log.Events.Span.ToArray().Select(item => $"{item.Kind} {simulator.NameOf(item.ColliderIndex)}")];
        return state;
    }
}
