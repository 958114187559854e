using FootballPhysics.Integration;

namespace FootballPhysics.Tests.Stability;

/// <summary>Steps in parts end, whatever the forces do.</summary>
public sealed class SubstepsTests
{
    /// <summary>v̇ = v²/L reaches infinity at the time L/v, 0.1 s: the parts become ever shorter, and then are not numbers.</summary>
    [Theory]
    [InlineData(0.05)]
    [InlineData(0.1)]
    [InlineData(0.2)]
    [InlineData(10)]
    public void A_motion_that_runs_away_ends_its_step(double h)
    {
        var system = new Runaway();
        var from = new FootballPhysics.Motion(Vector3d.Zero, new Vector3d(10, 0, 0), Vector3d.Zero, 0);
        system.Rates(0, in from, out MotionRates start);
        Substeps method = default;
        method.Advance(ref system, 0, in from, in start, h, out MotionStep step);
        Assert.InRange(method.Stages, 1, 4096);
        if (h < 0.1)
        {
            // v = v₀/(1 − v₀ t/L).
            Assert.Equal(10 / (1 - (10 * h)), step.End.Velocity.X, 1e-6);
        }
    }

    /// <summary>x'' = −20² x, y'' = 6 t and ω̇ = 3 along z, in parts of 20 ms or less: the end is the closed form, also if a repeated step resumes within the last one.</summary>
    [Fact]
    public void A_repeated_step_resumes_and_ends_at_the_closed_form()
    {
        var system = new Oscillator();
        var from = new FootballPhysics.Motion(new Vector3d(1, 0, 0), Vector3d.Zero, new Vector3d(0, 0, 2), 0);
        system.Rates(0, in from, out MotionRates start);
        Substeps method = default;
        method.Advance(ref system, 0, in from, in start, 0.5, out _);
        int first = method.Stages;
        foreach (double h in (double[])[0.495, 0.51, 0.505, 0.3, 0.47])
        {
            method.Advance(ref system, 0, in from, in start, h, out MotionStep step);
            Assert.InRange(method.Stages, 1, h > 0.49 ? first / 3 : first);
            Assert.Equal(Math.Cos(20 * h), step.End.Position.X, 1e-8);
            Assert.Equal(-20 * Math.Sin(20 * h), step.End.Velocity.X, 2e-7);
            Assert.Equal(h * h * h, step.End.Position.Y, 1e-12);
            Assert.Equal(2 + (3 * h), step.End.Spin.Z, 1e-12);
            Assert.Equal((2 * h) + (1.5 * h * h), step.Rotation.Z, 1e-12);
            Assert.Equal(5 * h, step.End.AirDistance, 1e-12);
            Assert.Equal(start, step.StartRates);

            Substeps other = default;
            other.Advance(ref system, 0, in from, in start, h, out MotionStep fresh);
            Assert.Equal(fresh, step);
        }
    }

    /// <summary>x'' = −20² x in one step of each method: half the step leaves an error smaller by at least 2⁷ or 2⁹, the order plus one.</summary>
    [Theory]
    [InlineData(6, 0.05)]
    [InlineData(8, 0.1)]
    public void A_method_of_high_order_has_its_order(int order, double h)
    {
        HighOrder method = order == 6 ? HighOrder.Sixth : HighOrder.Eighth;
        var system = new Oscillator();
        var from = new FootballPhysics.Motion(new Vector3d(1, 0, 0), new Vector3d(7, 0, 0), Vector3d.Zero, 0);
        system.Rates(0, in from, out MotionRates start);
        double ErrorOf(double length)
        {
            method.Advance(ref system, 0, in from, in start, length, turnsByStages: order == 8, out MotionStep step);
            return Math.Abs(Math.Cos(20 * length) + (0.35 * Math.Sin(20 * length)) - step.End.Position.X);
        }

        Assert.InRange(Math.Log2(ErrorOf(h) / ErrorOf(0.5 * h)), order + 0.5, order + 6);
    }

    /// <summary>Low shots with sidespin into a goal, in steps of 10 ms: a step took up to 322 pieces when each followed the turn of the slip.</summary>
    [Theory]
    [InlineData(Integrator.Rk2)]
    [InlineData(Integrator.Rk4)]
    public void A_step_in_a_net_takes_few_pieces(Integrator integrator)
    {
        var simulator = new Simulator(new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) }] }, new SolverSettings { Integrator = integrator });
        int slides = 0;
        for (int i = 0; i < 24; i++)
        {
            BallState s = simulator.Launch(new Vector3d(0, 0.11, -10), new Vector3d(-3 + (0.25 * i), 0.05 * i, -6 - (0.5 * i)), new Vector3d(20 - (2 * i), 30 - (3 * i), 5 * (i % 5)));
            while (s.Time < 4 && s.Motion != MotionState.Rest)
            {
                var log = new StepLog();
                slides += s.Nets != 0 && s.Motion == MotionState.Sliding ? 1 : 0;
                bool isIn = s.Nets != 0;
                simulator.Step(ref s, 0.01, log);
                Assert.InRange(log.Steps, 0, isIn ? 12 : 64);
            }
        }

        Assert.InRange(slides, 50, int.MaxValue);
    }

    private struct Oscillator : IMotionSystem
    {
        public unsafe ForceTrace* Trace { get; set; }

        public readonly void Rates(double time, in FootballPhysics.Motion at, out MotionRates rates) =>
            rates = new MotionRates(new Vector3d(-400 * at.Position.X, 6 * time, 0), new Vector3d(0, 0, 3), 5);

        public readonly double LongestPart(in FootballPhysics.Motion at, in FootballPhysics.MotionRates rates) => 0.02 / (1 + at.Position.Y);

        public readonly void Move(ref BallState s, in FootballPhysics.Motion from, in MotionStep step) => s.Position = step.End.Position;
    }

    private struct Runaway : IMotionSystem
    {
        public unsafe ForceTrace* Trace { get; set; }

        public readonly void Rates(double time, in FootballPhysics.Motion at, out MotionRates rates) =>
            rates = new MotionRates(new Vector3d(at.Velocity.X * at.Velocity.X, 0, 0), Vector3d.Zero);

        public readonly double LongestPart(in FootballPhysics.Motion at, in FootballPhysics.MotionRates rates) => 0.1 / at.Velocity.X;

        public readonly void Move(ref BallState s, in FootballPhysics.Motion from, in MotionStep step) => s.Position = step.End.Position;
    }
}
