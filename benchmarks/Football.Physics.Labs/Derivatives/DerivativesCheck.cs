using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Derivatives;

/// <summary>Compares the derivatives of random flights of one kind with central differences of the simulation itself.</summary>
/// <param name="kind">The kind of flights.</param>
/// <param name="timeStep">Length of a step, s.</param>
internal sealed class DerivativesCheck(DerivativesKind kind, double timeStep = 0.01)
{
    public const double Reach = 1e-6;
    private const double Radius = 0.11;

    /// <summary>
    /// The largest change of the launch, m/s; for the spin ten times as much in rad/s. It is halved repeatedly. Wide differences cross from one sequence of
    /// events to another, narrow ones magnify rounding. The difference that agrees best with its next wider and next narrower neighbour counts.
    /// </summary>
    private const double Widest = 3.2e-3;
    private const int Halvings = 15;

    /// <summary>Differences that agree to this share of their size need no narrower ones.</summary>
    private const double Agreed = 1e-9;

    /// <summary>A flight is not judged if its differences are less certain than this share of the allowed error.</summary>
    private const double Certain = 0.3;

    private readonly Simulator _simulator = new(DerivativesScenes.Of(kind));
    private readonly StepLog _log = new();

    public DerivativesKind Kind => kind;

    /// <summary>The largest error of each flight, as a share of the largest entry of its block.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>The number of flights whose differences do not agree at any width, so that they are no better than the derivatives under test.</summary>
    public int Uncertain { get; private set; }

    /// <summary>The number of flights at the edge of another sequence of events: no four adjacent widths give the same sequence for all changed launches.</summary>
    public int OnEdge { get; private set; }

    /// <summary>The events of all flights.</summary>
    public Dictionary<BallEventKind, int> Events { get; } = [];

    /// <summary>Draws a flight and compares its derivatives.</summary>
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
        End(position, velocity, spin, stopAt, duration, out _, out _);
        long pieces = _log.Steps;
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
                // Another number of pieces shifts the end by the error of a step, which is not part of the derivative. Use those differences only if there are no others.
                int column = (3 * block) + axis;
                if (!Difference(position, velocity, spin, column, stopAt, duration, events, pieces, out Difference difference)
                    && !Difference(position, velocity, spin, column, stopAt, duration, events, null, out difference))
                {
                    OnEdge++;
                    return;
                }

                wanted[axis] = difference.Place;
                wantedTimes[axis] = difference.Time;
                uncertain = Math.Max(uncertain, difference.PlaceError);
                uncertainTime = Math.Max(uncertainTime, difference.TimeError);
            }

            // Compare the effect of a spin with at least a tenth of the effect of its surface speed as a velocity.
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

    /// <summary>Computes the change of position and time at the end, by differences of fourth order. Position and time each use the widths that agree best.</summary>
    private bool Difference(
        Vector3d position, Vector3d velocity, Vector3d spin, int column, StopAt stopAt, double duration, BallEvent[] events, long? pieces, out Difference best)
    {
        double width = column < 3 ? Widest : 10 * Widest;
        var found = new Difference(default, 0, double.PositiveInfinity, double.PositiveInfinity);
        var quotients = new (Vector3d Place, double Time)[3];
        var extrapolated = new (Vector3d Place, double Time)[3];
        int inARow = 0;
        for (int i = 0; i < Halvings && !IsCertain(in found); i++, width *= 0.5)
        {
            inARow = Quotient(position, velocity, spin, column, width, stopAt, duration, events, pieces, out Vector3d place, out double time) ? inARow + 1 : 0;
            quotients.AsSpan(1).CopyTo(quotients);
            quotients[2] = (place, time);
            if (inARow < 2)
            {
                continue;
            }

            // (4 q(h) − q(2h))/3
            extrapolated.AsSpan(1).CopyTo(extrapolated);
            extrapolated[2] = (place + ((place - quotients[1].Place) / 3), time + ((time - quotients[1].Time) / 3));
            if (inARow < 4)
            {
                continue;
            }

            (Vector3d middle, double middleTime) = extrapolated[1];
            double error = Math.Max(Largest(middle - extrapolated[0].Place), Largest(middle - extrapolated[2].Place));
            double timeError = Math.Max(Math.Abs(middleTime - extrapolated[0].Time), Math.Abs(middleTime - extrapolated[2].Time));
            found = error < found.PlaceError ? found with { Place = middle, PlaceError = error } : found;
            found = timeError < found.TimeError ? found with { Time = middleTime, TimeError = timeError } : found;
        }

        best = found;
        return best.PlaceError < double.PositiveInfinity;
    }

    private static bool IsCertain(in Difference difference) =>
        difference.PlaceError <= Agreed * Largest(difference.Place) && difference.TimeError <= Agreed * Math.Abs(difference.Time);

    private bool Quotient(
        Vector3d position, Vector3d velocity, Vector3d spin, int column, double width, StopAt stopAt, double duration, BallEvent[] events, long? pieces, out Vector3d change, out double time)
    {
        change = default;
        time = 0;
        Vector3d by = width * new Vector3d(column % 3 == 0 ? 1 : 0, column % 3 == 1 ? 1 : 0, column % 3 == 2 ? 1 : 0);
        Vector3d velocityBy = column < 3 ? by : Vector3d.Zero;
        Vector3d spinBy = column < 3 ? Vector3d.Zero : by;
        End(position, velocity + velocityBy, spin + spinBy, stopAt, duration, out Vector3d high, out double later);
        if (!IsSame(events, pieces))
        {
            return false;
        }

        End(position, velocity - velocityBy, spin - spinBy, stopAt, duration, out Vector3d low, out double sooner);
        if (!IsSame(events, pieces))
        {
            return false;
        }

        change = (high - low) / (2 * width);
        time = (later - sooner) / (2 * width);
        return true;
    }

    /// <summary>Simulates a shot.</summary>
    private void End(Vector3d position, Vector3d velocity, Vector3d spin, StopAt stopAt, double duration, out Vector3d place, out double time)
    {
        _log.Clear();
        BallState state = _simulator.Launch(position, velocity, spin);
        _simulator.Run(ref state, timeStep, duration, stopAt, _log);
        place = state.Position;
        time = state.Time;
    }

    /// <summary>True if the last shot had the same events and, if a number of pieces is given, the same number of pieces.</summary>
    private bool IsSame(BallEvent[] events, long? pieces)
    {
        bool same = (pieces is null || _log.Steps == pieces) && _log.Events.Count == events.Length;
        for (int i = 0; same && i < events.Length; i++)
        {
            same = _log.Events[i].Kind == events[i].Kind && _log.Events[i].ColliderIndex == events[i].ColliderIndex;
        }

        return same;
    }
}

/// <summary>A difference quotient of the end of a flight.</summary>
/// <param name="Place">The change of the position at the end.</param>
/// <param name="Time">The change of the time at the end.</param>
/// <param name="PlaceError">The uncertainty of the position's change: the largest component of its difference from the quotients of twice and half the width.</param>
/// <param name="TimeError">The uncertainty of the time's change.</param>
internal readonly record struct Difference(Vector3d Place, double Time, double PlaceError, double TimeError);
