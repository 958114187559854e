using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>A gap along a path. It is open until the event that <see cref="TimeOfImpact"/> finds.</summary>
internal interface IGap
{
    /// <summary>Evaluates the gap at a time.</summary>
    /// <param name="t">The time, s.</param>
    /// <param name="step">If the event is not now: the time for which the gap surely stays open, s; infinite if it never closes.</param>
    /// <returns>True if the event is now.</returns>
    bool IsClosed(double t, out double step);
}

/// <summary>Finds the first time at which a gap closes, by conservative advancement.</summary>
/// <remarks>
/// A gap f with rate f' and second derivative of at most M stays open until f + f' s − ½ M s² is zero. Near a contact this is Newton's method, which
/// never oversteps the contact.
/// </remarks>
internal static class TimeOfImpact
{
    /// <summary>The largest <see cref="NearHollow"/>, and its largest share of the free distance to the centre of curvature.</summary>
    private const double Nearest = 0.1;
    private const double ShareOfRoom = 0.5;

    /// <summary>The number of evaluations after which the steps of a search grow by this factor each.</summary>
    /// <remarks>
    /// Above: a ball that touches a turning object without closing takes thousands of steps. Below: a search may skip a contact that it could reach.
    /// </remarks>
    private const int MostEvaluations = 512;
    private const double Growth = 1.25;

    /// <summary>Returns the gap up to which the second derivative of the gap to a concave surface is bounded, as a share of the radius.</summary>
    /// <remarks>The bound, κ/(1 − κ d), has a pole at the centre of curvature, which is close to the centre of a ball that hardly fits.</remarks>
    public static double NearHollow(double radius, double hollow) =>
        Math.Min(Nearest, ShareOfRoom * ((1.0 / (radius * hollow)) - 1.0));

    /// <summary>Returns the time of the event; infinite if there is none.</summary>
    /// <param name="gap">The gap.</param>
    /// <param name="span">The span of the search.</param>
    /// <param name="evaluations">Counts the evaluations of the gap.</param>
    /// <param name="from">Start of the search, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double First<TGap>(ref TGap gap, in SearchSpan span, ref long evaluations, double from = 0)
        where TGap : struct, IGap
    {
        double t = from;
        double stretch = 1.0;
        int count = 1;
        for (; !gap.IsClosed(t, out double step); count++)
        {
            // A contact that a stretched step passes is found late, but then located on the piece.
            stretch = Stretch(stretch, count);

            // A step that was lengthened to the minimum must not skip the end of the path, because the gap may have closed there.
            double next = t + Math.Max(stretch * step, span.Shortest);
            t = next > span.Until && t + step <= span.Until && t < span.Until ? span.Until : next;
            if (!(t <= span.Until))
            {
                t = double.PositiveInfinity;
                break;
            }
        }

        evaluations += count;
        return t;
    }

    /// <summary>Returns the factor of the next step of a search: it grows in a search that is long already.</summary>
    /// <param name="stretch">The factor of the last step.</param>
    /// <param name="count">The number of evaluations so far.</param>
    /// <param name="most">The number from which on it grows.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Stretch(double stretch, int count, int most = MostEvaluations) => count > most ? Growth * stretch : stretch;

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
        // The gap f with the rate f' and the bound M of f'': s = (f' + √(f'² + 2 M f))/M; for f' < 0 this is 2 f/(√(…) − f').
        double root = Math.Sqrt((rate * rate) + (2.0 * bend * gap));
        return rate < 0 ? 2.0 * gap / (root - rate) : bend > 0 ? (rate + root) / bend : double.PositiveInfinity;
    }
}

/// <summary>The span of a search along a path.</summary>
/// <param name="length">Length of the path, s.</param>
/// <param name="until">The time after which the search may end, s from the start of the path.</param>
internal readonly struct SearchSpan(double length, double until)
{
    /// <summary>End of the search, s from the start of the path.</summary>
    public readonly double Until = Math.Min(until, length);

    /// <summary>Minimum step, s, so that every search ends. Default: a small share of the path.</summary>
    public double Shortest { get; init; } = Math.Max(ContactTolerances.ShortestShare * length, ContactTolerances.ShortestStep);
}
