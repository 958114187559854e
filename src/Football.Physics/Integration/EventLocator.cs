namespace FootballPhysics;

/// <summary>
/// Finds events inside a step to the accuracy of the integrator: the step itself is taken again, from its start and with other lengths, until the
/// event is at its end. Newton's method inside a bracket.
/// </summary>
internal static class EventLocator
{
    /// <summary>Steps at most: enough to halve any step down to its last bits.</summary>
    private const int MostSteps = 60;

    /// <summary>Below this correction, s, a linear one is exact to rounding, where the motion does not bend in it.</summary>
    public const double Negligible = 1e-6;

    /// <summary>Largest share of the acceleration in a linear correction, m.</summary>
    private const double NegligibleBend = 1e-10;

    /// <summary>True when a step's end may be moved by a correction along its velocity, and need not be taken again.</summary>
    /// <param name="sweep">The step.</param>
    /// <param name="correction">The correction, s.</param>
    public static bool IsLinear<TSweep>(ref TSweep sweep, double correction)
        where TSweep : struct, ISweep =>
        Math.Abs(correction) <= Negligible && sweep.StartAcceleration.Length * correction * correction <= NegligibleBend;

    /// <summary>Shortens a step to where its event function is zero.</summary>
    /// <param name="sweep">The step.</param>
    /// <param name="sought">The event function; positive at the step's start, and not at its end.</param>
    /// <param name="tau">The first guess, s.</param>
    /// <returns>False where the search ended without it: then the step has the length at which it was evaluated last.</returns>
    public static bool Locate<TSweep, TEvent>(ref TSweep sweep, in TEvent sought, double tau)
        where TSweep : struct, ISweep
        where TEvent : struct, IEventFunction<TSweep>
    {
        double low = 0;
        double length = sweep.Length;
        double high = length;
        for (int i = 0; i < MostSteps; i++)
        {
            sweep.Step(tau);
            if (sought.Evaluate(ref sweep, tau, out double value, out double correction))
            {
                return true;
            }

            // Positive is before the event: the bracket closes from that side, or from the other.
            if (value > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            // Newton or the secant as long as they stay in the bracket, else its middle.
            double next = tau + correction;
            tau = next > low && next < high ? next : 0.5 * (low + high);
            if (high - low <= 1e-15 * length)
            {
                break;
            }
        }

        return false;
    }
}

/// <summary>A function of a step's end that falls to zero where an event is. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface IEventFunction<TSweep>
    where TSweep : struct, ISweep
{
    /// <summary>Evaluates it at the end of a step.</summary>
    /// <param name="sweep">The step as it was last taken; its end may be nudged where a linear correction is exact.</param>
    /// <param name="tau">Its length, s.</param>
    /// <param name="value">The function there; positive before the event.</param>
    /// <param name="correction">What Newton's method, or a secant, adds to the length, s; not a number where the function does not fall: then the bracket is halved.</param>
    /// <returns>True where the search ends: at the event, or where no other length would be nearer to it.</returns>
    bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction);
}

/// <summary>The rate at a step's end, from its start and its mean.</summary>
internal static class Extrapolate
{
    /// <summary>Below this length, s, the difference of the ends is mostly rounding.</summary>
    private const double Shortest = 1e-6;

    /// <summary>2 (f₁ − f₀)/h − f₀'.</summary>
    public static double Rate(double from, double to, double startRate, double h) =>
        h > Shortest ? ((2.0 * (to - from)) / h) - startRate : startRate;

    /// <inheritdoc cref="Rate(double, double, double, double)"/>
    public static Vector3d Rate(in Vector3d from, in Vector3d to, in Vector3d startRate, double h) =>
        h > Shortest ? ((2.0 / h) * (to - from)) - startRate : startRate;
}
