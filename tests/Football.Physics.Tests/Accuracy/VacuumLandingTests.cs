using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>Fifty shots without air, whose landing point is known (thesis 3.4.1).</summary>
public sealed class VacuumLandingTests
{
    private const double Gravity = 9.81;

    [Theory]
    [InlineData(Integrator.Euler, 0.01, +1)]
    [InlineData(Integrator.Euler, 0.02, +1)]
    [InlineData(Integrator.Euler, 0.04, +1)]
    [InlineData(Integrator.SemiImplicitEuler, 0.01, -1)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, -1)]
    [InlineData(Integrator.SemiImplicitEuler, 0.04, -1)]
    public void First_order_methods_land_one_step_of_way_too_far_or_too_near(Integrator integrator, double timeStep, int sign)
    {
        foreach ((double vx, double vy) in Shots())
        {
            double error = Landing(integrator, timeStep, vx, vy) - (2 * vx * vy / Gravity);
            Assert.InRange(sign * error / (vx * timeStep), 0.989, 1.011);
        }
    }

    [Theory]
    [InlineData(Integrator.Rk2, 0.01)]
    [InlineData(Integrator.Rk2, 0.02)]
    [InlineData(Integrator.Rk2, 0.04)]
    [InlineData(Integrator.Rk2, 1.0)]
    [InlineData(Integrator.Rk4, 0.01)]
    [InlineData(Integrator.Rk4, 0.02)]
    [InlineData(Integrator.Rk4, 0.04)]
    [InlineData(Integrator.Rk4, 1.0)]
    public void Runge_Kutta_lands_exactly_at_every_step_size(Integrator integrator, double timeStep)
    {
        var errors = new Errors("landing");
        foreach ((double vx, double vy) in Shots())
        {
            errors.Add($"({vx}, {vy})", Math.Abs(Landing(integrator, timeStep, vx, vy) - (2 * vx * vy / Gravity)));
        }

        errors.Hold(worst: 1e-10);
    }

    private static double Landing(Integrator integrator, double timeStep, double vx, double vy)
    {
        BallEvent impact = Flight.ToImpact(
            Scene.Vacuum with { Gravity = Gravity }, integrator, timeStep, new Vector3d(0, Flight.Radius, 0), new Vector3d(vx, vy, 0), Vector3d.Zero);
        Assert.Equal(Flight.Radius, impact.Position.Y, 1e-13);
        return impact.Position.X;
    }

    private static IEnumerable<(double Vx, double Vy)> Shots()
    {
        var random = new Shots(341);
        return [.. Enumerable.Range(0, 50).Select(_ => (random.Uniform(5, 20), random.Uniform(5, 20)))];
    }
}
