using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>A gap along a path. It is open until the event that <see cref="TimeOfImpact"/> finds.</summary>
internal interface IGap
{
    /// <summary>Evaluates the gap at a time.</summary>
    /// <param name="t">The time, s.</param>
    /// <param name="step">If the event is not now: the time for which the gap surely stays open, s; infinite if it never closes.</param>
    /// <returns>True if the event is now.</returns>
    bool IsClosed(double t, out double step);

    /// <summary>Advances the time by a step.</summary>
    /// <returns>False beyond the end of the search.</returns>
    bool Advance(ref double t, double step);
}

/// <summary>Finds the first time at which a gap closes, by conservative advancement.</summary>
/// <remarks>
/// A gap f with rate f' and second derivative of at most M stays open until f + f' s − ½ M s² is zero. Near a contact this is Newton's method, which
/// never oversteps the contact.
/// </remarks>
internal static class TimeOfImpact
{
    /// <summary>The second derivative of the gap to a concave surface is bounded only up to this gap, as a share of the radius.</summary>
    public const double NearHollow = 0.1;

    /// <summary>Returns the time of the event; infinite if there is none.</summary>
    /// <param name="gap">The gap.</param>
    /// <param name="from">Start of the search, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double First<TGap>(ref TGap gap, double from = 0)
        where TGap : struct, IGap
    {
        double t = from;
        return Finds(ref gap, ref t) ? t : double.PositiveInfinity;
    }

    /// <summary>Advances the time to the event.</summary>
    /// <param name="gap">The gap.</param>
    /// <param name="t">The start of the search, s; on return, the time of the event, or a time beyond the end.</param>
    /// <returns>False if there is no event.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Finds<TGap>(ref TGap gap, ref double t)
        where TGap : struct, IGap
    {
        while (!gap.IsClosed(t, out double step))
        {
            if (!gap.Advance(ref t, step))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if the gap is closed and shrinks: the usual event.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Closes(double gap, double rate) => gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching;

    /// <summary>Returns a safe step if the gap does not close now.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Step(double gap, double rate, double bend) => gap > ContactTolerances.Touching ? Safe(gap, rate, bend) : Along(rate, bend);

    /// <summary>Returns a safe step for a closed gap that does not shrink: until it may shrink, or by the contact tolerance, ½ M
    /// s².</summary>
    public static double Along(double rate, double bend) =>
        bend > 0 ? Math.Max(rate / bend, Math.Sqrt(2.0 * ContactTolerances.Touching / bend)) : double.PositiveInfinity;

    /// <summary>Returns the positive root of f + f' s − ½ M s², without cancellation.</summary>
    public static double Safe(double gap, double rate, double bend)
    {
        // s = (f' + √(f'² + 2 M f))/M; for f' < 0 this is 2 f/(√(…) − f').
        double root = Math.Sqrt((rate * rate) + (2.0 * bend * gap));
        return rate < 0 ? 2.0 * gap / (root - rate) : bend > 0 ? (rate + root) / bend : double.PositiveInfinity;
    }
}

/// <summary>The span of a search along a path.</summary>
internal readonly struct SearchSpan
{
    /// <summary>End of the search, s from the start of the path.</summary>
    public readonly double Until;

    /// <summary>Minimum step, s, so that every search ends.</summary>
    public readonly double Shortest;

    public SearchSpan(in PathCubic path, double until)
    {
        Until = until;
        Shortest = Math.Max(ContactTolerances.ShortestShare * path.Length, ContactTolerances.ShortestStep);
    }

    /// <summary>Advances along the path. A step that was lengthened to the minimum stops at the end of the path.</summary>
    /// <returns>False beyond the end.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Advance(ref double t, double step)
    {
        double next = t + Math.Max(step, Shortest);

        // A lengthened step must not skip the end of the path, because the gap may have closed there.
        next = next > Until && t + step <= Until && t < Until ? Until : next;
        t = next;
        return next <= Until;
    }

    /// <summary>Advances along the path. A lengthened step may pass the end: the next piece finds an event there.</summary>
    /// <returns>False beyond the end.</returns>
    public bool AdvanceFreely(ref double t, double step)
    {
        t += Math.Max(step, Shortest);
        return t <= Until;
    }
}
