using FootballPhysics.Contacts;
using FootballPhysics.Scenes;
using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>Directions of the forces and torques.</summary>
public sealed class AirRatesTests
{
    private static readonly Scene s_scene = LawGrid.Scene;

    private static MotionRates InFlight(ForceSet forces, in Vector3d u, in Vector3d w)
    {
        Scene scene = s_scene with { Forces = forces };
        var flight = new FlightSystem { Around = new Surroundings(scene, SceneAir.Of(scene)), Branch = DragBranch.Spinning };
        flight.Rates(0, new FootballPhysics.Motion(Vector3d.Zero, in u, in w), out MotionRates rates);
        return new MotionRates(rates.Acceleration - new Vector3d(0, flight.Around.Upward, 0), in rates.SpinAcceleration);
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

    [Fact]
    public void Buoyancy_is_the_weight_of_the_air_displaced()
    {
        double r = s_scene.Ball.Radius;
        Assert.Equal(4.0 / 3.0 * Math.PI * Math.Pow(r, 3) * 1.17 * 9.81 / 0.41, Buoyancy.Acceleration(s_scene), 1e-15);
        Assert.Equal(0, Buoyancy.Acceleration(s_scene with { Forces = ForceSet.None }));
        Assert.Equal(-9.81, Gravity.Acceleration(s_scene));
    }
}
