namespace FootballPhysics.Friction;

/// <summary>A slip that friction slows along a line: ds/dt = −λ (1 + a e^(−s/b)), where λ is the deceleration by μ₀.</summary>
/// <remarks>E = e^(s/b) obeys dE/dt = −(λ/b) (E + a), so E(t) = (E₀ + a) e^(−λ t/b) − a.</remarks>
internal sealed class SlipLaw(double a, double b)
{
    /// <summary>Returns the slip after a time, m/s.</summary>
    public double After(double start, double lambda, double time) =>
        b * Math.Log(((Math.Exp(start / b) + a) * Math.Exp(-lambda * time / b)) - a);

    /// <summary>Returns the time at which the slip ends, s.</summary>
    public double EndOf(double start, double lambda) => b / lambda * Math.Log((Math.Exp(start / b) + a) / (1.0 + a));

    /// <summary>Returns the integral of the slip from 0 to a time, m, by Simpson's rule.</summary>
    public double Way(double start, double lambda, double time)
    {
        const int Parts = 2000;
        double h = time / Parts;
        double sum = start + After(start, lambda, time);
        for (int i = 1; i < Parts; i++)
        {
            sum += (i % 2 == 1 ? 4 : 2) * After(start, lambda, i * h);
        }

        return sum * h / 3.0;
    }
}
