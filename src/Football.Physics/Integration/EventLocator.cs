namespace FootballPhysics.Integration;

/// <summary>Finds events within a step with the accuracy of the integrator, by Newton's method within a bracket.</summary>
/// <remarks>It repeats the step from its start with other lengths, until the event is at the end of the step.</remarks>
internal static class EventLocator
{
    /// <summary>The maximum number of steps: enough to bisect any step to its last bits.</summary>
    public const int MostSteps = 60;

    /// <summary>The correction, in s, below which a linear one is exact up to rounding, if the acceleration is negligible.</summary>
    public const double Negligible = 1e-6;

    /// <summary>The largest contribution of the acceleration to a linear correction, in m.</summary>
    public const double NegligibleBend = 1e-10;

    /// <summary>Shortens a step to the zero of an event function.</summary>
    /// <param name="sweep">The step.</param>
    /// <param name="sought">The event function; positive at the start of the step, and not positive at its end.</param>
    /// <param name="tau">The first guess, in s.</param>
    /// <returns>False if the search ended without the event: the step then has the length of the last evaluation.</returns>
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

            // The function is positive before the event, so this length replaces the end of the bracket on its side.
            if (value > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            // Use Newton or the secant while the result stays in the bracket; otherwise, bisect.
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

/// <summary>A function of the end of a step that falls to zero at an event. A struct, so that a search is specialized for it and does not allocate.</summary>
internal interface IEventFunction<TSweep>
    where TSweep : struct, ISweep
{
    /// <summary>Evaluates the function at the end of a step.</summary>
    /// <param name="sweep">The step as last taken. Its end may be nudged if a linear correction is exact.</param>
    /// <param name="tau">The length of the step, in s.</param>
    /// <param name="value">The value; positive before the event.</param>
    /// <param name="correction">The correction of the length by Newton's method or a secant, in s; NaN if the function does not fall: the search then bisects.</param>
    /// <returns>True if the search ends: at the event, or if no other length would be closer.</returns>
    bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction);
}
