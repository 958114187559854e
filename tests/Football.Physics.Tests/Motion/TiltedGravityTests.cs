namespace FootballPhysics.Tests.Motion;

/// <summary>Gravity that is not straight down. A world with it, turned until its gravity points down, is a world with a slope: the same ball goes the same way in both.</summary>
public sealed class TiltedGravityTests
{
    private const double Radius = 0.11;

    public static TheoryData<double, bool, Integrator> Worlds()
    {
        var worlds = new TheoryData<double, bool, Integrator>();
        foreach (double angle in new[] { 0.02, 0.1, 0.4, -0.7 })
        {
            foreach (Integrator integrator in new[] { Integrator.Rk4, Integrator.Rk2 })
            {
                worlds.Add(angle, true, integrator);
                worlds.Add(angle, false, integrator);
            }
        }

        return worlds;
    }

    [Theory]
    [MemberData(nameof(Worlds))]
    public void A_tilted_gravity_is_a_slope(double angle, bool isMeasured, Integrator integrator)
    {
        Quaterniond turn = Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), -angle);
        Vector3d gravity = 9.81 * new Vector3d(Math.Sin(angle), -Math.Cos(angle), 0);
        Assert.Equal(0, Vector3d.Distance(turn.Rotate(gravity), new Vector3d(0, -9.81, 0)), 1e-14);
        Scene own = isMeasured ? Scene.Measured with { Ground = Ground.Of(SurfaceMaterial.MatchTurf) } : Scene.Published with { Forces = ForceSet.Regularized };
        Scene tilted = own with { GravityVector = gravity, Obstacles = [Wall(new Vector3d(6, 0, 0), new Vector3d(-1, 0, 0))] };
        Scene slope = own with
        {
            Ground = own.Ground with { Normal = turn.Rotate(Vector3d.Up) },
            Obstacles = [Wall(turn.Rotate(new Vector3d(6, 0, 0)), turn.Rotate(new Vector3d(-1, 0, 0)))],
        };
        foreach ((Vector3d position, Vector3d velocity, Vector3d spin) in new[]
        {
            (new Vector3d(0, Radius + 0.5, 0), new Vector3d(3, 2, 1), new Vector3d(5, 20, -8)),
            (new Vector3d(0, Radius, 0), new Vector3d(1, 0, 2), Vector3d.Zero),
            (new Vector3d(0, Radius, 0), Vector3d.Zero, Vector3d.Zero),
            (new Vector3d(5, Radius, 0), new Vector3d(2, 0, -1), Vector3d.Zero),
        })
        {
            // Rounding of the turned start must not put the ball into the slope.
            var lifted = new Vector3d(position.X, position.Y + 1e-12, position.Z);
            BallState a = Play(tilted, integrator, lifted, velocity, spin);
            BallState b = Play(slope, integrator, turn.Rotate(lifted), turn.Rotate(velocity), turn.Rotate(spin));
            double apart = Vector3d.Distance(turn.Rotate(a.Position), b.Position);

            // Level ground under a tilted gravity takes the plane form of the laws, a slope the general form: they differ by less than the error of RK2, which is 3e-5 m here.
            Assert.True(apart < (integrator == Integrator.Rk4 ? 2e-6 : 1e-5), $"{apart} m apart: {a.Motion} at {turn.Rotate(a.Position)}, {b.Motion} at {b.Position}");
            Assert.Equal(b.Motion, a.Motion);
        }
    }

    [Fact]
    public void Straight_down_is_the_same_number_and_the_same_bits()
    {
        Scene scene = Scene.Default with { GravityVector = new Vector3d(0, -9.81, 0) };
        Assert.Equal(Scene.Default, scene);
        Assert.Equal(new Vector3d(0, -9.81, 0), Scene.Default.GravityVector);
        Assert.Equal(3, (Scene.Default with { GravityVector = new Vector3d(1, -3, 2) }).Gravity);
    }

    /// <summary>Without vertical weight nothing presses the ball on the ground: it falls sideways.</summary>
    [Fact]
    public void Gravity_may_be_sideways_alone()
    {
        var scene = new Scene { GravityVector = new Vector3d(4, 0, 0), Forces = ForceSet.None, Ground = Ground.None };
        BallState end = Play(scene, Integrator.Rk4, Vector3d.Zero, new Vector3d(0, 1, 0), Vector3d.Zero);
        Assert.Equal(0.5 * 4 * end.Time * end.Time, end.Position.X, 1e-9);
        Assert.Equal(end.Time, end.Position.Y, 1e-9);
    }

    /// <summary>Aims and look-aheads fly in the same gravity as the steps.</summary>
    [Fact]
    public void Queries_fly_in_it_too()
    {
        var simulator = new Simulator(Scene.Default with { GravityVector = new Vector3d(2, -9.6, 1) });
        AimResult aim = new Aimer(simulator).Find(new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(3, 1.5, -20), Speed = 25 });
        Assert.True(aim.HitsTarget);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), aim.Velocity, aim.Spin);
        var path = new Trajectory();
        simulator.LookAhead(in state, new LookAheadRequest { Duration = 2, StopAt = StopAt.Time, TimeStep = 0.01 }, path);
        var log = new StepLog();
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < 2000; i++)
        {
            simulator.Step(ref state, 0.001, log);
            nearest = Math.Min(nearest, Vector3d.Distance(state.Position, new Vector3d(3, 1.5, -20)));
        }

        Assert.InRange(nearest, 0, 0.02);
        Assert.Equal(0, Vector3d.Distance(path.PositionAt(2), state.Position), 1e-4);
    }

    [Theory]
    [InlineData(0, 1, 0, "gravity")]
    [InlineData(1001, -1, 0, "gravity[0]")]
    [InlineData(0, -1, double.NaN, "gravity[2]")]
    public void What_is_out_of_range_is_refused(double x, double y, double z, string field) => Assert.StartsWith(
        field + " is", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(Scene.Default with { GravityVector = new Vector3d(x, y, z) })).Message, StringComparison.Ordinal);

    private static Obstacle Wall(in Vector3d point, in Vector3d normal) => new() { Shape = new PlaneShape(point, normal), Surface = SurfaceMaterial.Board };

    private static BallState Play(Scene scene, Integrator integrator, in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
        BallState state = simulator.Launch(position, velocity, spin);
        var log = new StepLog();
        for (int i = 0; i < 1500; i++)
        {
            simulator.Step(ref state, 0.002, log);
        }

        return state;
    }
}
