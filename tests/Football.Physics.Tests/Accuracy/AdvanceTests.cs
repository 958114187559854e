using FootballPhysics.Integration;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>One step of each method for rates that are polynomials in time, of the highest degree for which the method is exact.</summary>
public sealed class AdvanceTests
{
    private const double Time = 0.3;
    private const double H = 0.4;

    // Rates at the start, and their factors of t and t², from the start on.
    private static readonly Vector3d s_at = new(3, -2, 1);
    private static readonly FootballPhysics.Motion s_from = new(new(1, 2, 3), new(4, -5, 6), new(0.1, 0.2, -0.3), 7);

    [Fact]
    public void Euler_is_exact_for_constant_positions_and_constant_rates_of_velocity()
    {
        MotionStep step = Take<ExplicitEuler>(0);
        Holds(in step, 0);
        Near(s_from.Position + (H * s_from.Velocity), step.End.Position);
        Near((H * s_from.Spin) + Turned(in step), step.Rotation);
        step = Take<SemiImplicitEuler>(0);
        Holds(in step, 0);
        Near(s_from.Position + (H * step.End.Velocity), step.End.Position);
        Near((H * step.End.Spin) + Turned(in step), step.Rotation);
    }

    [Fact]
    public void Midpoint_is_exact_for_linear_rates()
    {
        MotionStep step = Take<MidpointRungeKutta>(1);
        Holds(in step, 1);
        step = Take<MidpointRungeKutta>(0);
        Near(s_from.Position + (H * s_from.Velocity) + (0.5 * H * H * s_at), step.End.Position);
    }

    [Fact]
    public void Classical_is_exact_for_quadratic_rates()
    {
        MotionStep step = Take<ClassicalRungeKutta>(2);
        Holds(in step, 2);
        Near(s_from.Position + (H * s_from.Velocity) + (H * H * ((0.5 * s_at) + (H / 6 * s_at) + (H * H / 12 * s_at))), step.End.Position);
    }

    private static MotionStep Take<TMethod>(int degree)
        where TMethod : struct, IIntegrator
    {
        var system = new Polynomial(degree);
        system.Rates(Time, in s_from, out MotionRates start);
        default(TMethod).Advance(ref system, Time, in s_from, in start, H, out MotionStep step);
        Assert.Equal(start, step.StartRates);
        return step;
    }

    /// <summary>Velocity, spin and distance through the air are integrals of the rates.</summary>
    private static void Holds(in MotionStep step, int degree)
    {
        double integral = Enumerable.Range(1, degree + 1).Sum(n => Math.Pow(H, n) / n);
        Near(s_from.Velocity + (integral * s_at), step.End.Velocity);
        Near(s_from.Spin + (0.5 * integral * s_at), step.End.Spin);
        Assert.Equal(s_from.AirDistance + (5 * integral), step.End.AirDistance, 1e-12);
    }

    /// <summary>The second term of Magnus' series for a spin that is linear in time.</summary>
    private static Vector3d Turned(in MotionStep step) => H * H / 12 * Vector3d.Cross(step.End.Spin, s_from.Spin);

    private static void Near(Vector3d expected, Vector3d actual) => Assert.InRange((expected - actual).Length, 0, 1e-12);

    private struct Polynomial(int degree) : IMotionSystem
    {
        public unsafe ForceTrace* Trace { get; set; }

        public readonly void Rates(double time, in FootballPhysics.Motion at, out MotionRates rates)
        {
            double t = time - Time;
            double share = 1 + (degree > 0 ? t : 0) + (degree > 1 ? t * t : 0);
            rates = new MotionRates(share * s_at, 0.5 * share * s_at, 5 * share);
        }

        public readonly double LongestPart(in FootballPhysics.Motion at, in FootballPhysics.MotionRates rates) => double.PositiveInfinity;

        public readonly void Move(ref BallState s, in FootballPhysics.Motion from, in MotionStep step) => s.Position = step.End.Position;
    }
}
