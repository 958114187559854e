using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Scenes;
using FootballPhysics.Simulation;
using FootballPhysics.State;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>Directions of the forces and torques.</summary>
public sealed class AirForcesTests
{
    private static readonly Scene s_scene = LawGrid.Scene;

    private static MotionRates InFlight(ForceSet forces, in Vector3d u, in Vector3d w) => InFlight(s_scene with { Forces = forces }, in u, in w, DragBranch.Spinning);

    private static MotionRates InFlight(Scene scene, in Vector3d v, in Vector3d w, DragBranch branch)
    {
        var flight = new FlightSystem { Around = new Surroundings(scene, SceneAir.Of(scene)), Branch = branch };
        flight.Rates(0, new FootballPhysics.Motion(Vector3d.Zero, in v, in w), out MotionRates rates);
        return new MotionRates(rates.Acceleration - new Vector3d(0, flight.Around.Upward, 0), in rates.SpinAcceleration);
    }

    /// <summary>If a fast spin turns the velocity within a step, the step uses RK4, regardless of the method of the scene.</summary>
    [Fact]
    public void A_classical_flight_is_a_step_of_RK4()
    {
        var around = new Surroundings(s_scene, SceneAir.Of(s_scene));
        var flight = new ClassicalFlight(around);
        BallState start = new Simulator(s_scene).Launch(new Vector3d(0, 3, 0), new Vector3d(20, 4, 1), new Vector3d(0, 30, -10));
        FlightMotion expected = start.Flight;
        FlightMotion motion = start.Flight;
        default(ClassicalRungeKutta).Fly(ref around.Air, in start, ref expected, Vector3d.Zero, DragBranch.Spinning, around.Upward, 0.01, out FlightStep wanted);
        flight.Fly(in start, ref motion, Vector3d.Zero, DragBranch.Spinning, around.Upward, 0.01, out FlightStep step);
        Assert.NotEqual(start.Flight.Velocity, motion.Velocity);
        Assert.Equal(expected, motion);
        Assert.Equal(wanted, step);
        Assert.Equal((4, 4), (flight.Order, flight.Stages));
    }

    [Fact]
    public void Drag_brakes_and_decay_acts_against_the_spin()
    {
        var u = new Vector3d(3, -4, 12);
        var w = new Vector3d(-20, 5, 9);
        MotionRates rates = InFlight(ForceSet.Published with { Magnus = ForceLaw.None }, in u, in w);
        Assert.Equal(-1, Vector3d.Dot(rates.Acceleration / rates.Acceleration.Length, u / u.Length), 1e-14);
        Assert.Equal(-1, Vector3d.Dot(rates.SpinAcceleration / rates.SpinAcceleration.Length, w / w.Length), 1e-14);
    }

    [Fact]
    public void The_Magnus_force_acts_along_spin_times_velocity()
    {
        var u = new Vector3d(0, 0, -20);
        var w = new Vector3d(0, 30, 0);
        MotionRates rates = InFlight(ForceSet.Published with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None }, in u, in w);

        // ŷ × (−ẑ) = −x̂: to the left of a ball that flies to −z.
        Assert.True(rates.Acceleration.X < -1);
        Assert.Equal(0, rates.Acceleration.Y);
        Assert.Equal(0, rates.Acceleration.Z);
    }

    [Fact]
    public void Spin_along_the_flight_gives_no_lift_and_the_cross_product_is_not_normalised()
    {
        var u = new Vector3d(0, 0, -20);
        double Lift(Vector3d w) => InFlight(ForceSet.Published with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None }, in u, in w).Acceleration.Length;
        Assert.Equal(0, Lift(new Vector3d(0, 0, 30)));
        Assert.Equal(0.5, Lift(new Vector3d(0, 15, -15 * Math.Sqrt(3))) / Lift(new Vector3d(0, 30, 0)), 1e-12);
    }

    /// <summary>A piece in still air keeps its branch up to the jump. In a wind field, the flow at each instant selects the branch.</summary>
    [Theory]
    [InlineData(8)]
    [InlineData(20)]
    public void In_a_wind_field_the_branch_is_that_of_the_flow(double speed)
    {
        var u = new Vector3d(speed, 0, 0);
        var w = new Vector3d(0, 0, 30);
        var wind = new Vector3d(0, 0, 5);
        Scene still = s_scene with { Forces = ForceSet.Published };
        Scene windy = still with { Air = still.Air with { WindField = new UniformWind(wind) } };
        MotionRates expected = InFlight(still, in u, in w, LawGrid.BranchOf(speed, s_scene.Ball.Radius * 30 / speed));
        foreach (DragBranch branch in (DragBranch[])[DragBranch.Spinning, DragBranch.NoSpin])
        {
            Assert.Equal(0, (InFlight(windy, u + wind, in w, branch).Acceleration - expected.Acceleration).Length, 1e-12);
        }

        Assert.NotEqual(InFlight(still, in u, in w, DragBranch.Spinning), InFlight(still, in u, in w, DragBranch.NoSpin));
    }

    [Fact]
    public void Buoyancy_is_the_weight_of_the_air_displaced()
    {
        double r = s_scene.Ball.Radius;
        Assert.Equal(4.0 / 3.0 * Math.PI * Math.Pow(r, 3) * 1.17 * 9.81 / 0.41, Buoyancy.Acceleration(s_scene), 1e-15);
        Assert.Equal(0, Buoyancy.Acceleration(s_scene with { Forces = ForceSet.None }));
        Assert.Equal(-9.81, Gravity.Acceleration(s_scene));
    }

    /// <summary>In a wind field the jump of the law is not located: the known branch of a step does not matter.</summary>
    [Theory]
    [InlineData(25, 60)]
    [InlineData(25, 1)]
    [InlineData(8, 60)]
    public void In_a_wind_field_the_factors_do_not_depend_on_the_branch_of_the_step(double speed, double spin)
    {
        var still = SceneAir.Of(s_scene with { Forces = ForceSet.Published });
        var windy = SceneAir.Of(s_scene with { Forces = ForceSet.Published, Air = s_scene.Air with { WindField = new WindByHeight(5, 1, 0) } });
        double radius = s_scene.Ball.Radius;
        DragBranch branch = DragJump.At(speed * speed, radius * radius * spin * spin).Branch;
        still.Factors(speed * speed, spin, speed * speed, branch, out double drag, out double lift, out double decay);
        foreach (DragBranch known in new[] { DragBranch.NoSpin, DragBranch.Spinning })
        {
            windy.Factors(speed * speed, spin, speed * speed, known, out double d, out double l, out double q);
            Assert.Equal((drag, lift, decay), (d, l, q));
        }
    }

    [Fact]
    public void A_wind_that_depends_on_the_height_alone_does_not_change_in_time()
    {
        Assert.False(SceneAir.Of(s_scene).ChangesInTime);
        Assert.False(SceneAir.Of(s_scene with { Air = s_scene.Air with { WindField = new WindByHeight(5, 1, 0) } }).ChangesInTime);
        Assert.True(SceneAir.Of(s_scene with { Air = s_scene.Air with { WindField = new UniformWind(new Vector3d(1, 0, 0)) } }).ChangesInTime);
    }
}
