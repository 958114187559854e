using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>Factors of drag and lift against coefficients that have them already.</summary>
public sealed class ScaledAirTests
{
    /// <summary>A force that is none: beside it a scaled air is taken as a force like any other.</summary>
    private static readonly IForce s_nothing = IForce.From(_ => Vector3d.Zero);

    private static Vector3d Land(Scene scene)
    {
        var simulator = new Simulator(scene, new SolverSettings { Integrator = Integrator.Rk4 });
        BallState ball = simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(22, 6, 3), new Vector3d(5, 40, -12));
        var log = new StepLog();
        for (int i = 0; i < 80; i++)
        {
            simulator.Step(ref ball, 0.01, log);
        }

        return ball.Position;
    }

    [Theory]
    [InlineData(1.6, 1)]
    [InlineData(1, 0.4)]
    [InlineData(0.5, -0.8)]
    public void Constant_coefficients_times_factors_are_those_coefficients(double drag, double lift)
    {
        Scene plain = new() { Forces = ForceSet.Constant with { DragCoefficient = 0.25, MagnusCoefficient = 0.5 }, Air = new Air { Wind = new Vector3d(3, 0, -4) } };
        Vector3d expected = Land(plain with { Forces = plain.Forces with { DragCoefficient = 0.25 * drag, MagnusCoefficient = 0.5 * lift } });
        var scaled = new ScaledAir(plain, drag, lift);
        Assert.Equal((drag, lift), (scaled.Drag, scaled.Lift));
        Vector3d alone = Land(plain with { Forces = plain.Forces with { CustomForces = [scaled] } });
        Vector3d beside = Land(plain with { Forces = plain.Forces with { CustomForces = [scaled, s_nothing] } });
        Assert.InRange(Vector3d.Distance(expected, alone), 0, 1e-9);
        Assert.InRange(Vector3d.Distance(expected, beside), 0, 1e-6);
        Assert.InRange(Vector3d.Distance(expected, Land(plain)), 0.1, 20);
    }

    /// <summary>Laws of which one jumps: alone and beside another force the same.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Measured)]
    public void Alone_and_beside_another_force_it_does_the_same(AerodynamicModel form)
    {
        Scene plain = new() { Forces = ForceSet.Published with { Coefficients = form } };
        var scaled = new ScaledAir(plain, 1.3, 0.6);
        Vector3d alone = Land(plain with { Forces = plain.Forces with { CustomForces = [scaled] } });
        Vector3d beside = Land(plain with { Forces = plain.Forces with { CustomForces = [scaled, s_nothing] } });
        Assert.InRange(Vector3d.Distance(alone, beside), 0, 1e-5);
    }

    /// <summary>Of another ball's laws the factors are of that ball's forces.</summary>
    [Fact]
    public void Made_for_another_scene_it_adds_that_scenes_forces()
    {
        Scene plain = new() { Forces = ForceSet.Constant with { DragCoefficient = 0.25, MagnusCoefficient = 0 } };
        Scene lighter = plain with { Ball = plain.Ball with { Mass = 0.5 * plain.Ball.Mass } };
        var scaled = new ScaledAir(lighter, 1.6, 1);

        // Its force is that of 0.6 times the drag, and does not depend on the mass.
        Vector3d expected = Land(plain with { Forces = plain.Forces with { DragCoefficient = 0.25 * 1.6 } });
        Assert.InRange(Vector3d.Distance(expected, Land(plain with { Forces = plain.Forces with { CustomForces = [scaled] } })), 0, 1e-6);
    }

    /// <summary>Scaled laws are the laws times the factors, by the spin vector and by its axis, inside and outside the tables.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    [InlineData(AerodynamicModel.Measured)]
    public void Scaled_laws_are_the_laws_times_their_factors(AerodynamicModel form)
    {
        var scene = new Scene { Forces = ForceSet.Published with { Coefficients = form } };
        var laws = AirLaws.Of(scene);
        var scaled = AirLaws.Of(scene, 1.3, 0.6);
        int lifts = 0;
        foreach (double speed in new[] { 0.5, 9, 25, 500 })
        {
            foreach (double spin in new[] { 0, 3, 60, 900 })
            {
                double u = speed * speed;
                laws.Factors(u, spin, 0.9 * u, DragBranch.Spinning, out double drag, out double lift, out double decay);
                scaled.Factors(u, spin, 0.9 * u, DragBranch.Spinning, out double d, out double l, out double q);
                Assert.Equal((1.3 * drag, 0.6 * lift, decay), (d, l, q));
                laws.FactorsPerSpin(u, spin * spin, 0.9 * u * spin * spin, DragBranch.Spinning, out drag, out lift, out decay);
                scaled.FactorsPerSpin(u, spin * spin, 0.9 * u * spin * spin, DragBranch.Spinning, out d, out l, out q);
                Assert.Equal((1.3 * drag, 0.6 * lift, decay), (d, l, q));
                lifts += lift > 0 ? 1 : 0;
            }
        }

        Assert.InRange(lifts, 6, 16);
    }

    [Fact]
    public void A_negative_factor_of_the_drag_is_refused() =>
        Assert.Contains("drag", Assert.Throws<ArgumentOutOfRangeException>(() => new ScaledAir(new Scene(), -0.1, 1)).Message, StringComparison.Ordinal);
}
