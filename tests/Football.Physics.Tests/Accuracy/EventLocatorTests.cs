using FootballPhysics.Integration;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>The search for an event within a step, for the event τ = 0.3 L of the function (0.3 L)² − τ².</summary>
public sealed class EventLocatorTests
{
    /// <summary>Newton's corrections converge in a few steps. Without usable corrections, the search bisects.</summary>
    [Theory]
    [InlineData(1, 10, 1.0)]
    [InlineData(1000, 10, 1.0)]
    [InlineData(1, 50, double.NaN)]
    [InlineData(1, 50, 1e9)]
    [InlineData(1, 50, -1e9)]
    [InlineData(1000, 50, double.NaN)]
    public void The_event_is_found(double length, int most, double factor)
    {
        var sweep = new Sweep { Length = length };
        Assert.True(EventLocator.Locate(ref sweep, new Square(length, factor, 1e-13), 0.9 * length));
        Assert.Equal(0.3, sweep.Length / length, 1e-12);
        Assert.InRange(sweep.Evaluations, 2, most);
    }

    /// <summary>A function that never reports its event: the search ends once the bracket is down to the last bits, which takes 50 halvings at any length.</summary>
    [Theory]
    [InlineData(1e-3)]
    [InlineData(1)]
    [InlineData(1e3)]
    public void A_search_without_an_end_stops_at_the_last_bits(double length)
    {
        var sweep = new Sweep { Length = length };
        Assert.False(EventLocator.Locate(ref sweep, new Square(length, double.NaN, -1), 0.5 * length));
        Assert.Equal(0.3, sweep.Length / length, 1e-14);
        Assert.InRange(sweep.Evaluations, 48, 53);
    }

    private readonly struct Square(double length, double factor, double close) : IEventFunction<Sweep>
    {
        public bool Evaluate(ref Sweep sweep, double tau, out double value, out double correction)
        {
            Assert.Equal(tau, sweep.Length);
            double x = tau / length;
            value = 0.09 - (x * x);
            correction = factor * length * value / (2 * x);
            return Math.Abs(value) <= close;
        }
    }

    private struct Sweep : ISweep
    {
        public double Length { get; set; }

        public int Evaluations { get; set; }

        public readonly Vector3d Position => Vector3d.Zero;

        public readonly Vector3d Velocity => Vector3d.Zero;

        public readonly Vector3d StartAcceleration => Vector3d.Zero;

        public void Step(double h)
        {
            Length = h;
            Evaluations++;
        }

        public void Nudge(double dt) => Length += dt;

        public readonly Vector3d EndAcceleration() => Vector3d.Zero;

        public readonly void MoveTo(ref BallState s) => s.Position = Position;
    }
}
