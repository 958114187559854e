using FootballPhysics.Contacts;
using FootballPhysics.State;
using BallMotion = FootballPhysics.Motion;

namespace FootballPhysics.Tests.Things;

/// <summary>The equations of a ball on a surface at the ends of their range.</summary>
public sealed class SurfaceSystemTests
{
    /// <summary>The air brakes the spin of one stage, and a later stage has reversed it.</summary>
    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e-150)]
    [InlineData(1e-200)]
    [InlineData(2.5e-312)]
    [InlineData(0)]
    public void The_rates_of_a_spin_that_ends_are_finite(double spin)
    {
        var scene = new Scene { Ground = new Ground { Material = SurfaceMaterial.MatchTurf with { SlidingFriction = 0 } } };
        var around = new Surroundings(scene, SceneAir.Of(scene));
        BallState ball = new Simulator(scene).Launch(new Vector3d(0, scene.Ball.Radius, 0), new Vector3d(5, 0, 0), Vector3d.Zero);
        SurfaceSystem system = SurfaceSystem.On(around, around.World.Ground!, in ball, DragBranch.Unknown);
        system.StartSpin = new Vector3d(spin, 0, 0);
        var start = new BallMotion(ball.Position, ball.Velocity, new Vector3d(40, 0, 0));
        system.Rates(0, in start, out _);
        var reversed = new BallMotion(ball.Position, ball.Velocity, new Vector3d(-40, 0, 0));
        system.Rates(0, in reversed, out MotionRates rates);
        Assert.True(rates.Acceleration.IsFinite);
        Assert.True(rates.SpinAcceleration.IsFinite);
    }
}
