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

    private struct Runaway : IMotionSystem
    {
        public readonly void Rates(double time, in FootballPhysics.Motion at, out MotionRates rates) =>
            rates = new MotionRates(new Vector3d(at.Velocity.X * at.Velocity.X, 0, 0), Vector3d.Zero);

        public readonly double LongestPart(in FootballPhysics.Motion at) => 0.1 / at.Velocity.X;

        public readonly void Move(ref BallState s, in FootballPhysics.Motion from, in MotionStep step) => s.Position = step.End.Position;
    }
}
