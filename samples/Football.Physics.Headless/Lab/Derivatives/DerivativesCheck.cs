using Football.Physics.Yardsticks;

namespace Football.Physics.Headless.Lab.Derivatives;

/// <summary>Random flights of one kind, whose derivatives are compared with central differences of the simulation itself.</summary>
/// <param name="kind">What kind.</param>
/// <param name="timeStep">Length of a step, s.</param>
internal sealed class DerivativesCheck(DerivativesKind kind, double timeStep = 0.01)
{
    public const double Reach = 1e-6;
    private const double Radius = 0.11;

    /// <summary>
    /// The widest change of the launch, m/s; of the spin ten times that in rad/s. It is halved so often: wide differences pass from one course of events
    /// to another, narrow ones magnify rounding. Those two in a row count that agree best.
    /// </summary>
    private const double Widest = 3.2e-3;
    private const int Halvings = 9;

    /// <summary>Two that agree to this share of themselves need no narrower ones.</summary>
    private const double Agreed = 1e-9;

    /// <summary>No flight is judged by differences that are less certain than this share of what is judged.</summary>
    private const double Certain = 0.3;

    private readonly Simulator _simulator = new(DerivativesScenes.Of(kind));
    private readonly StepLog _log = new();

    public DerivativesKind Kind => kind;

    /// <summary>The largest error of each flight, as a share of the largest entry of its block.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>Flights of which the differences themselves are no better than what is judged: at no width do two agree.</summary>
    public int Uncertain { get; private set; }

    /// <summary>Flights on the edge of another course of events: at no two widths in a row do all changed launches go through the same.</summary>
    public int OnEdge { get; private set; }

    /// <summary>Events that the flights went through.</summary>
    public Dictionary<BallEventKind, int> Events { get; } = [];

    /// <summary>Draws a flight and compares.</summary>
    public void Run(SeededRandom random)
    {
        (Vector3d position, Vector3d velocity, Vector3d spin) = DerivativesScenes.Launch(kind, random);
        StopAt stopAt = random.Any(StopAt.Impact, StopAt.Time, StopAt.Rest);
        stopAt = kind == DerivativesKind.Hills ? StopAt.Impact : stopAt;
        double duration = stopAt == StopAt.Time ? random.Uniform(0.5, 4) : 30;
        var derivatives = new LaunchDerivatives(_simulator);
        BallState state = _simulator.Launch(position, velocity, spin);
        bool ended = derivatives.Run(ref state, timeStep, duration, stopAt);
        BallEvent[] events = derivatives.Events.Span.ToArray();
        Vector3d[] found = [.. Columns(derivatives)];
        double[] times = [.. Times(derivatives)];
        double worst = 0;
        double velocityBlock = 0;
        double velocityTimes = 0;
        for (int block = 0; block < 2; block++)
        {
            var wanted = new Vector3d[3];
            var wantedTimes = new double[3];
            double uncertain = 0;
            double uncertainTime = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                if (!Difference(position, velocity, spin, (3 * block) + axis, stopAt, duration, events, out Difference difference))
                {
                    OnEdge++;
                    return;
                }

                wanted[axis] = difference.Place;
                wantedTimes[axis] = difference.Time;
                uncertain = Math.Max(uncertain, difference.PlaceError);
                uncertainTime = Math.Max(uncertainTime, difference.TimeError);
            }

            // What a spin does is measured by a tenth of what its surface speed would do as a velocity, where it does less.
            double largest = Math.Max(wanted.Max(Largest), 0.1 * Radius * velocityBlock);
            double largestTime = Math.Max(wantedTimes.Max(Math.Abs), 0.1 * Radius * velocityTimes);
            (velocityBlock, velocityTimes) = block == 0 ? (largest, largestTime) : (velocityBlock, velocityTimes);
            if (uncertain > Certain * Reach * Math.Max(1e-6, largest) || (ended && uncertainTime > Certain * Reach * Math.Max(1e-6, largestTime)))
            {
                Uncertain++;
                return;
            }

            for (int axis = 0; axis < 3; axis++)
            {
                worst = Math.Max(worst, Largest(wanted[axis] - found[(3 * block) + axis]) / Math.Max(1e-6, largest));
                worst = Math.Max(worst, ended ? Math.Abs(wantedTimes[axis] - times[(3 * block) + axis]) / Math.Max(1e-6, largestTime) : 0);
            }
        }

        Errors.Add(worst);
        foreach (BallEvent e in events)
        {
            Events[e.Kind] = Events.GetValueOrDefault(e.Kind) + 1;
        }
    }

    private static double Largest(Vector3d v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));

    private static IEnumerable<Vector3d> Columns(LaunchDerivatives of)
    {
        foreach (Matrix3d block in (Matrix3d[])[of.PositionByVelocity, of.PositionBySpin])
        {
            yield return block * new Vector3d(1, 0, 0);
            yield return block * new Vector3d(0, 1, 0);
            yield return block * new Vector3d(0, 0, 1);
        }
    }

    private static IEnumerable<double> Times(LaunchDerivatives of)
    {
        foreach (Vector3d row in (Vector3d[])[of.TimeByVelocity, of.TimeBySpin])
        {
            yield return row.X;
            yield return row.Y;
            yield return row.Z;
        }
    }

    /// <summary>The change of place and time at the end, by differences of fourth order.</summary>
    private bool Difference(
        Vector3d position, Vector3d velocity, Vector3d spin, int column, StopAt stopAt, double duration, BallEvent[] events, out Difference best)
    {
        double width = column < 3 ? Widest : 10 * Widest;
        best = new Difference(default, 0, double.PositiveInfinity, double.PositiveInfinity);
        bool hasWide = false;
        bool hasLast = false;
        (Vector3d Place, double Time) wide = default;
        (Vector3d Place, double Time) last = default;
        for (int i = 0; i < Halvings; i++, width *= 0.5)
        {
            bool same = Quotient(position, velocity, spin, column, width, stopAt, duration, events, out Vector3d narrow, out double narrowTime);
            if (same && hasWide)
            {
                // (4 q(h) − q(2h))/3
                Vector3d place = narrow + ((narrow - wide.Place) / 3);
                double time = narrowTime + ((narrowTime - wide.Time) / 3);
                double error = Largest(place - last.Place);
                double timeError = Math.Abs(time - last.Time);
                if (hasLast && error < best.PlaceError)
                {
                    best = new Difference(place, time, error, timeError);
                }

                last = (place, time);
                hasLast = true;
                if (best.PlaceError <= Agreed * Largest(place) && best.TimeError <= Agreed * Math.Abs(time))
                {
                    return true;
                }
            }

            wide = (narrow, narrowTime);
            hasLast &= same;
            hasWide = same;
        }

        return best.PlaceError < double.PositiveInfinity;
    }

    private bool Quotient(
        Vector3d position, Vector3d velocity, Vector3d spin, int column, double width, StopAt stopAt, double duration, BallEvent[] events, out Vector3d change, out double time)
    {
        change = default;
        time = 0;
        Vector3d by = width * new Vector3d(column % 3 == 0 ? 1 : 0, column % 3 == 1 ? 1 : 0, column % 3 == 2 ? 1 : 0);
        Vector3d velocityBy = column < 3 ? by : Vector3d.Zero;
        Vector3d spinBy = column < 3 ? Vector3d.Zero : by;
        if (!End(position, velocity + velocityBy, spin + spinBy, stopAt, duration, events, out Vector3d high, out double later)
            || !End(position, velocity - velocityBy, spin - spinBy, stopAt, duration, events, out Vector3d low, out double sooner))
        {
            return false;
        }

        change = (high - low) / (2 * width);
        time = (later - sooner) / (2 * width);
        return true;
    }

    /// <summary>Plays a shot; the same things must happen to it.</summary>
    private bool End(
        Vector3d position, Vector3d velocity, Vector3d spin, StopAt stopAt, double duration, BallEvent[] events, out Vector3d place, out double time)
    {
        _log.Clear();
        BallState state = _simulator.Launch(position, velocity, spin);
        _simulator.Run(ref state, timeStep, duration, stopAt, _log);
        place = state.Position;
        time = state.Time;
        bool same = _log.Events.Count == events.Length;
        for (int i = 0; same && i < events.Length; i++)
        {
            same = _log.Events[i].Kind == events[i].Kind && _log.Events[i].Thing == events[i].Thing;
        }

        return same;
    }
}
