namespace Football.Physics;

/// <summary>The spin that is left at the end of a flight along a constant axis.</summary>
internal readonly struct SpinLeft<TIntegrator> : IEventFunction<FlightSweep<TIntegrator>>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A spin of less than this, rad/s, is none.</summary>
    private const double Vanishing = 1e-300;

    private readonly double _start;

    /// <param name="start">The spin at the start, rad/s.</param>
    public SpinLeft(double start) => _start = start;

    public bool Evaluate(ref FlightSweep<TIntegrator> sweep, double tau, out double value, out double correction)
    {
        value = sweep.Taken.SpinRate;

        // The secant from the step's start: its spin falls about linearly.
        correction = value * tau / (_start - value);
        return Math.Abs(value) <= (1e-14 * _start) + Vanishing || !(tau > 0);
    }
}
