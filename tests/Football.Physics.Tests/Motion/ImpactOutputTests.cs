using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>The outputs of impacts, for sound, haptics and looks.</summary>
public sealed class ImpactOutputTests
{
    /// <summary>Without air and gravity.</summary>
    private static readonly Scene s_still = Scene.Measured with { Forces = ForceSet.None, Gravity = 0 };

    /// <summary>A real ball touches for 10.7 ms and dents by 57 mm at 19.2 m/s; a foot of 1.9 kg presses with 2.4 kN.</summary>
    [Fact]
    public void A_shot_at_a_wall_has_the_measured_duration_and_dent()
    {
        SurfaceMaterial hard = SurfaceMaterial.Concrete with { NormalRestitution = 0.72, RestitutionSpeedScale = double.PositiveInfinity };
        Impact wall = Against(double.PositiveInfinity, hard, 19.2, out _);
        Assert.Equal(10.69e-3, wall.ContactTime, 0.005e-3);
        Assert.Equal(55.6e-3, wall.Compression, 0.05e-3);
        Assert.InRange(wall.PeakForce, 2775, 2785);
        Impact foot = Against(1.9, hard with { NormalRestitution = 0.6 }, 20, out _);
        Assert.Equal(9.66e-3, foot.ContactTime, 0.005e-3);
        Assert.InRange(foot.PeakForce, 2425, 2435);
        Assert.Equal(1.2 * 0.11, Against(double.PositiveInfinity, hard, 60, out _).Compression, 1e-12);
    }

    /// <summary>Impulse, slip and energy are those of the event and of an object that recoils.</summary>
    [Theory]
    [InlineData(double.PositiveInfinity)]
    [InlineData(5)]
    [InlineData(0.5)]
    public void An_object_with_a_mass_counts(double mass)
    {
        Impact impact = Against(mass, SurfaceMaterial.Concrete, 15, out BallEvent hit);
        BallProperties ball = BallProperties.Modern;
        Vector3d recoil = -impact.Impulse / mass;
        Assert.Equal(impact.Impulse.Length, Math.Sqrt((impact.NormalImpulse * impact.NormalImpulse) + (impact.TangentialImpulse * impact.TangentialImpulse)), 1e-12);
        double before = (0.5 * ball.Mass * hit.VelocityBefore.LengthSquared) + (0.5 * ball.MomentOfInertia * hit.SpinBefore.LengthSquared);
        double after = (0.5 * ball.Mass * hit.Velocity.LengthSquared) + (0.5 * ball.MomentOfInertia * hit.Spin.LengthSquared);
        after += double.IsFinite(mass) ? 0.5 * mass * recoil.LengthSquared : 0;
        Assert.Equal(before - after, impact.EnergyLost, 1e-9);
        Assert.True(impact.Grips);

        // Grip turns the slip back by e_t.
        Assert.Equal(SurfaceMaterial.Concrete.TangentialRestitution * impact.SlipBefore, impact.SlipAfter, 1e-9);
    }

    /// <summary>Both balls report the same impulse, slip and energy, which is all that the pair loses.</summary>
    [Fact]
    public void Two_balls_report_the_same_impact()
    {
        BallProperties large = BallProperties.Modern with { Mass = 0.6, Radius = 0.13, InertiaFactor = 0.5 };
        var group = new BallGroup(s_still, [BallProperties.Modern, large], contact: SurfaceMaterial.Ball with { ImpactFriction = 0.3 });
        Simulator light = group.SimulatorOf(0);
        Simulator heavy = group.SimulatorOf(1);
        BallState[] balls =
        [
            light.Launch(new Vector3d(0, 5, 0), new Vector3d(12, 0, 1), new Vector3d(5, 20, -7)), heavy.Launch(new Vector3d(1, 5.03, 0.02), new Vector3d(-4, 0, 0), new Vector3d(0, -9, 3)),
        ];
        var log = new StepLog();
        group.Run(balls, 0.01, 0.5, StopAt.Impact, log);
        BallEvent[] hits = [.. log.Events.Span.ToArray().Where(item => item.OtherBall >= 0)];
        Assert.Equal(2, hits.Length);
        Impact one = light.ImpactOf(in hits[0]);
        Impact other = heavy.ImpactOf(in hits[1]);
        Assert.Equal(one.NormalImpulse, other.NormalImpulse, 1e-12);
        Assert.Equal(one.TangentialImpulse, other.TangentialImpulse, 1e-12);
        Assert.Equal(one.SlipBefore, other.SlipBefore, 1e-12);
        Assert.Equal(one.SlipAfter, other.SlipAfter, 1e-9);
        Assert.Equal(one.Grips, other.Grips);
        Assert.Equal(one.EnergyLost, other.EnergyLost, 1e-9);
        double now = Kinetic(light, hits[0].Velocity, hits[0].Spin) + Kinetic(heavy, hits[1].Velocity, hits[1].Spin);
        double then = Kinetic(light, hits[0].VelocityBefore, hits[0].SpinBefore) + Kinetic(heavy, hits[1].VelocityBefore, hits[1].SpinBefore);
        Assert.Equal(then - now, one.EnergyLost, 1e-9);
    }

    /// <summary>An event that lost its object, as in C, has the same outputs on every stationary surface; what moves is refused.</summary>
    [Fact]
    public void An_event_alone_is_enough_for_stationary_surfaces()
    {
        var simulator = new Simulator(Pitch.Standard.On(new Scene()));
        var random = new Shots(3);
        int grips = 0;
        int hits = 0;
        for (int i = 0; i < 200; i++)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 1, 0), random.Velocity(3, 30, 5, 50), random.Uniform(0, 80) * random.Direction());
            var log = new StepLog();
            simulator.Run(ref ball, 0.01, 4, StopAt.Time, log);
            foreach (ref readonly BallEvent item in log.Events.Span)
            {
                if (item.Kind == BallEventKind.Impact)
                {
                    var bare = new BallEvent(
                        item.Kind, item.ColliderIndex, item.Normal, item.Time, item.Position, item.VelocityBefore, item.SpinBefore, item.Velocity, item.Spin);
                    Assert.Equal(simulator.ImpactOf(in item), simulator.ImpactOfStationary(in bare));
                    grips += simulator.ImpactOf(in item).Grips ? 1 : 0;
                    hits++;
                }
                else
                {
                    Assert.Equal(default, simulator.ImpactOf(in item));
                }
            }
        }

        Assert.InRange(grips, hits / 2, hits - 20);
        Against(2, SurfaceMaterial.Concrete, 10, out BallEvent moved);
        Assert.Null(new Simulator(Massive(2, SurfaceMaterial.Concrete)).ImpactOfStationary(in moved));
    }

    [Fact]
    public void A_soft_ball_touches_longer()
    {
        double At(double pressure)
        {
            var simulator = new Simulator(new Dials { Pressure = pressure }.Apply(Massive(double.PositiveInfinity, SurfaceMaterial.Concrete)));
            return Hit(simulator, 15, out _).ContactTime;
        }

        Assert.True(At(0.6) > At(0.8) && At(0.8) > At(1.1));
        Assert.Equal(At(0.8), Against(double.PositiveInfinity, SurfaceMaterial.Concrete, 15, out _).ContactTime);
    }

    private static double Kinetic(Simulator simulator, Vector3d velocity, Vector3d spin) =>
        0.5 * ((simulator.Scene.Ball.Mass * velocity.LengthSquared) + (simulator.Scene.Ball.MomentOfInertia * spin.LengthSquared));

    private static Impact Against(double mass, SurfaceMaterial material, double speed, out BallEvent hit) => Hit(new Simulator(Massive(mass, material)), speed, out hit);

    private static Scene Massive(double mass, SurfaceMaterial material) => s_still with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new FootballPhysics.Shapes.PlaneShape(new Vector3d(0, 0, -2), new Vector3d(0, 0, 1)), Surface = material, Mass = mass }],
    };

    private static Impact Hit(Simulator simulator, double speed, out BallEvent hit)
    {
        BallState ball = simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(0, 0, -speed), new Vector3d(0, 2, 0));
        var log = new StepLog();
        simulator.Run(ref ball, 0.005, 1, StopAt.Impact, log);
        hit = log.Events[log.Events.Count - 1];
        return simulator.ImpactOf(in hit);
    }
}
