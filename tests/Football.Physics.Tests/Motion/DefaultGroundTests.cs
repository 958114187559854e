using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>The ball that everybody has, on the ground: how it turns, what presses it on, what grips it. In closed form.</summary>
public sealed class DefaultGroundTests
{
    private const double Radius = 0.11;
    private const double Alpha = 2.0 / 3.0;
    private static readonly Vector3d s_start = new(0, Radius, 0);

    /// <summary>Dry turf whose rolling friction is the same at every speed, without air: what is pushed constantly moves by squares of the time.</summary>
    private static readonly Scene s_airless = new() { Air = new Air { Density = 0 }, Ground = Ground.Of(SurfaceMaterial.DryTurf with { RollingResistancePerSpeed = 0 }) };

    public static TheoryData<double> Speeds() => [2.5, 3.1, 4.7, 6.3, 8.9];

    [Theory]
    [MemberData(nameof(Speeds))]
    public void A_roll_to_rest_turns_the_ball_by_its_way_over_its_radius(double speed)
    {
        var velocity = new Vector3d(0, 0, -speed);
        BallState end = Flight.Play(new Scene(), Flight.With(Integrator.Rk4), 0.01, 60, StopAt.Rest, s_start, velocity, Rolling(velocity), out StepLog log);
        Assert.Equal("Rest", Flight.Kinds(log));
        var turned = Quaterniond.FromAxisAngle(new Vector3d(-1, 0, 0), -end.Position.Z / Radius);
        Assert.InRange(Differences.Rotation(end.Orientation, turned), 0, 1e-6);
    }

    /// <summary>While it slides at a constant friction its spin grows evenly, up to the speed over the radius.</summary>
    [Theory]
    [MemberData(nameof(Speeds))]
    public void A_slide_and_the_roll_after_it_turn_the_ball_by_the_integral_of_its_spin(double speed)
    {
        BallState end = Flight.Play(
            s_airless, Flight.With(Integrator.Rk4), 0.01, 60, StopAt.Rest, s_start, new Vector3d(0, 0, -speed), Vector3d.Zero, out StepLog log);
        Assert.Equal("Slide Roll Rest", "Slide " + Flight.Kinds(log));
        double friction = s_airless.Ground.Material.SlidingFriction * s_airless.Gravity;
        double time = speed / (friction * (1 + (1 / Alpha)));
        double sliding = 0.5 * friction * time * time / (Alpha * Radius);
        double way = Vector3d.Distance(Flight.First(log, BallEventKind.Roll).Position, end.Position);
        var turned = Quaterniond.FromAxisAngle(new Vector3d(-1, 0, 0), sliding + (way / Radius));
        Assert.InRange(Differences.Rotation(end.Orientation, turned), 0, 1e-6);
    }

    /// <summary>A push along the normal takes of the load what it is, not its share along the vertical: v̇ = g sin θ/(1+α) − c₀ (g cos θ − F·n/m).</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(-4)]
    [InlineData(5)]
    public void What_lifts_along_the_normal_of_a_slope_lightens_the_ball(double push)
    {
        var normal = new Vector3d(Math.Sin(Math.PI / 12), Math.Cos(Math.PI / 12), 0);
        Scene scene = Pushed(push * normal, Vector3d.Zero, s_airless.Ground with { Normal = normal });
        var down = new Vector3d(normal.Y, -normal.X, 0);
        Vector3d velocity = 2 * down;
        BallState end = Flight.Play(
            scene, Flight.With(Integrator.Rk4), 0.01, 1, StopAt.Time, Radius / normal.Y * Vector3d.Up, velocity, Vector3d.Cross(in normal, in velocity) / Radius, out StepLog log);
        Assert.Equal(0, log.Events.Count);
        double rate = (9.81 * normal.X / (1 + Alpha)) - (scene.Ground.Material.RollingResistance * ((9.81 * normal.Y) - push));
        Assert.Equal(2 + (0.5 * rate), Vector3d.Dot(end.Position - (Radius / normal.Y * Vector3d.Up), in down), 1e-9);
    }

    /// <summary>Air streaming down along the normal of a slope, and the ball at rest on it: the least lift that frees it is its weight across the slope.</summary>
    [Theory]
    [InlineData(0.999, false)]
    [InlineData(1.001, true)]
    public void A_ball_leaves_a_slope_where_the_push_along_its_normal_outweighs_it(double share, bool leaves)
    {
        var normal = new Vector3d(Math.Sin(0.06), Math.Cos(0.06), 0);
        Scene scene = Pushed(share * 9.81 * normal.Y * normal, Vector3d.Zero, s_airless.Ground with { Normal = normal });
        Flight.Play(scene, Flight.With(Integrator.Rk4), 0.01, 0.5, StopAt.Time, Radius / normal.Y * Vector3d.Up, Vector3d.Zero, Vector3d.Zero, out StepLog log);
        Assert.Equal(leaves, Flight.Kinds(log).Contains("ContactEnd", StringComparison.Ordinal) || log.Events.Count == 0);
    }

    [Fact]
    public void A_ball_that_the_air_lifts_does_not_stay_where_it_hits_too_slowly_to_bounce()
    {
        Scene scene = Pushed(new Vector3d(0, 1.02 * 9.81, 0), Vector3d.Zero, s_airless.Ground);
        BallState end = Flight.Play(
            scene, Flight.With(Integrator.Rk4), 0.01, 0.5, StopAt.Time, new Vector3d(0, Radius + 0.005, 0), new Vector3d(0, -0.1, 0), Vector3d.Zero, out StepLog log);
        Assert.Equal("Impact", Flight.Kinds(log));
        Assert.Equal(MotionState.Airborne, end.Motion);
        Assert.True(end.Position.Y > Radius + 0.01);
    }

    /// <summary>A push F and the torque that would turn the ball just as fast: friction has nothing to do, and v̇ = F/m − c₀ g.</summary>
    [Fact]
    public void A_push_and_the_torque_that_goes_with_it_need_no_grip()
    {
        const double Push = 15;
        Scene scene = Pushed(new Vector3d(Push, 0, 0), new Vector3d(0, 0, -Push / Radius), s_airless.Ground);
        var velocity = new Vector3d(2, 0, 0);
        BallState end = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.01, 0.5, StopAt.Time, s_start, velocity, Rolling(velocity), out StepLog log);
        Assert.Equal(0, log.Events.Count);
        Assert.Equal(1 + (0.125 * (Push - (scene.Ground.Material.RollingResistance * 9.81))), end.Position.X, 1e-9);

        // Turned the other way friction must give α/(1+α) · 30 m/s², more than it has.
        Scene against = Pushed(new Vector3d(Push, 0, 0), new Vector3d(0, 0, Push / Radius), s_airless.Ground);
        Flight.Play(against, Flight.With(Integrator.Rk4), 0.01, 0.1, StopAt.Time, s_start, velocity, Rolling(velocity), out log);
        Assert.StartsWith("Slide", Flight.Kinds(log), StringComparison.Ordinal);
    }

    /// <summary>A torque T alone rolls it on by T/((1+α) m r); on one that slides it adds T/I to the spin.</summary>
    [Fact]
    public void A_torque_of_the_game_s_own_acts_on_the_ground()
    {
        const double Turning = 20;
        Scene scene = Pushed(Vector3d.Zero, new Vector3d(0, 0, -Turning), s_airless.Ground);
        var velocity = new Vector3d(2, 0, 0);
        BallState rolled = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.01, 0.5, StopAt.Time, s_start, velocity, Rolling(velocity), out _);
        double rate = (Alpha * Radius * Turning / (1 + Alpha)) - (scene.Ground.Material.RollingResistance * 9.81);
        Assert.Equal(1 + (0.125 * rate), rolled.Position.X, 1e-9);

        BallState slid = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.01, 0.1, StopAt.Time, s_start, new Vector3d(9, 0, 0), Vector3d.Zero, out _);
        Assert.Equal(MotionState.Sliding, slid.Motion);
        Assert.Equal(-0.1 * (Turning + (scene.Ground.Material.SlidingFriction * 9.81 / (Alpha * Radius))), slid.Spin.Z, 1e-9);
    }

    private static Vector3d Rolling(in Vector3d velocity) => Vector3d.Cross(Vector3d.Up, in velocity) / Radius;

    /// <summary>A steady push and torque, per mass and per moment of inertia.</summary>
    private static Scene Pushed(Vector3d acceleration, Vector3d turning, Ground ground) => s_airless with
    {
        Ground = ground,
        Forces = ForceSet.Measured with { CustomForces = [new Steady(s_airless.Ball.Mass * acceleration, s_airless.Ball.MomentOfInertia * turning)] },
    };

    private sealed class Steady(Vector3d force, Vector3d torque) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(in force);
            sum.AddTorque(in torque);
        }
    }
}
