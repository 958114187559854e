using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>The landing point must not depend on the step (thesis 3.4.2): gaps between step sizes over 250 random shots.</summary>
public sealed class ConsistencyTests
{
    private const double Millimetre = 1e-3;

    [Theory]
    [InlineData(Integrator.Rk2, 0.45, 1.8, 2.2)]
    [InlineData(Integrator.Rk4, 1e-5, 1e-4, 1e-4)]
    public void Landing_points_of_different_steps_agree(Integrator integrator, double fine, double coarse, double both)
    {
        (Errors a, Errors b, Errors c) = Gaps(integrator, 15, 35, 2, 60);
        a.Hold(mean: fine * Millimetre);
        b.Hold(mean: coarse * Millimetre);
        c.Hold(mean: both * Millimetre);
    }

    [Fact]
    public void Landing_points_of_slow_shots_agree_too_though_most_cross_the_jump()
    {
        (Errors a, Errors b, Errors c) = Gaps(Integrator.Rk4, 12.5, 22, 5, 25);
        a.Hold(p95: 1e-5 * Millimetre, mean: 0.03 * Millimetre);
        b.Hold(p95: 1e-4 * Millimetre, mean: 0.03 * Millimetre);
        c.Hold(p95: 1e-4 * Millimetre, mean: 0.03 * Millimetre);
    }

    /// <summary>One step of 20 ms or two of 10 ms, half-way through any life of a ball: the same within the method's error.</summary>
    [Theory]
    [InlineData(Integrator.Euler, 0.3)]
    [InlineData(Integrator.SemiImplicitEuler, 0.3)]
    [InlineData(Integrator.Rk2, 2e-3)]
    [InlineData(Integrator.Rk4, 1e-6)]
    public void Splitting_every_step_changes_a_flight_within_the_error_of_the_method(Integrator integrator, double tolerance)
    {
        var random = new Shots(20);
        var errors = new Errors("split steps");
        for (int i = 0; i < 50; i++)
        {
            Vector3d velocity = random.Velocity(10, 30, 5, 40);
            Vector3d spin = random.Uniform(0, 60) * random.Direction();
            BallState Play(double step) => Flight.Play(
                Scene.Published, Flight.With(integrator), step, 0.8, StopAt.Time, new Vector3d(0, 2, 0), velocity, spin, out _);
            errors.Add($"{velocity}, {spin}", Vector3d.Distance(Play(0.02).Position, Play(0.01).Position));
        }

        errors.Hold(p95: tolerance);
        Assert.True(errors.Mean > 0, "steps of different lengths cannot be the same to the last bit");
    }

    [Fact]
    public void Unequal_steps_lead_to_the_same_place_and_events()
    {
        var random = new Shots(21);
        for (int i = 0; i < 20; i++)
        {
            var simulator = new Simulator(Scene.Published);
            BallState even = simulator.Launch(new Vector3d(0, 0.5, 0), random.Velocity(5, 20, 0, 40), random.Uniform(0, 40) * random.Direction());
            BallState uneven = even;
            var evenLog = new StepLog();
            var unevenLog = new StepLog();
            simulator.Run(ref even, 0.01, 12, StopAt.Time, evenLog);
            while (uneven.Time < 12)
            {
                simulator.Step(ref uneven, Math.Min(random.Uniform(0, 0.025), 12 - uneven.Time), unevenLog);
            }

            Assert.Equal(Flight.Kinds(evenLog), Flight.Kinds(unevenLog));
            Assert.InRange(Vector3d.Distance(even.Position, uneven.Position), 0, 1e-5);
            Assert.Equal(even.Motion, uneven.Motion);
        }
    }

    private static (Errors Fine, Errors Coarse, Errors Both) Gaps(Integrator integrator, double slow, double fast, double leastSpin, double mostSpin)
    {
        var random = new Shots(342);
        (Errors Fine, Errors Coarse, Errors Both) gaps = (new Errors("10–20 ms"), new Errors("20–40 ms"), new Errors("10–40 ms"));
        for (int i = 0; i < 250; i++)
        {
            Vector3d velocity = random.Velocity(slow, fast, 5, 35);
            Vector3d spin = random.Uniform(leastSpin, mostSpin) * random.Direction();
            Vector3d Land(double step) => Flight.ToImpact(Scene.Published, integrator, step, new Vector3d(0, 0.11, 0), velocity, spin).Position;
            (Vector3d a, Vector3d b, Vector3d c) = (Land(0.01), Land(0.02), Land(0.04));
            string name = $"{velocity}, {spin}";
            gaps.Fine.Add(name, Vector3d.Distance(a, b));
            gaps.Coarse.Add(name, Vector3d.Distance(b, c));
            gaps.Both.Add(name, Vector3d.Distance(a, c));
        }

        return gaps;
    }
}
