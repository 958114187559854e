using Football.Physics.Yardsticks;

namespace Football.Physics.Headless.Lab.Derivatives;

/// <summary>Random flights of one kind, whose derivatives are compared with central differences of the simulation itself.</summary>
/// <param name="kind">What kind.</param>
/// <param name="timeStep">Length of a step, s.</param>
internal sealed class DerivativesCheck(DerivativesKind kind, double timeStep = 0.01)
{
    public const double Reach = 1e-6;
    private const double Radius = 0.11;

    /// <summary>Change of the launch, m/s; of the spin ten times that in rad/s. Halved until the difference quotients agree with each other.</summary>
    private const double Width = 4e-4;
    private const int Halvings = 4;

    private readonly Simulator _simulator = new(DerivativesScenes.Of(kind));
    private readonly StepLog _log = new();

    public DerivativesKind Kind => kind;

    /// <summary>The largest error of each flight, as a share of the largest entry of its block.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>Flights of which the differences themselves are no better than what is judged, or on the edge of another course of events.</summary>
    public int Undecided { get; private set; }

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
            for (int axis = 0; axis < 3; axis++)
            {
                if (!Difference(position, velocity, spin, (3 * block) + axis, stopAt, duration, events, out wanted[axis], out wantedTimes[axis]))
                {
                    Undecided++;
                    return;
                }
            }

            // What a spin does is measured by a tenth of what its surface speed would do as a velocity, where it does less.
            double largest = Math.Max(wanted.Max(Largest), 0.1 * Radius * velocityBlock);
            double largestTime = Math.Max(wantedTimes.Max(Math.Abs), 0.1 * Radius * velocityTimes);
            (velocityBlock, velocityTimes) = block == 0 ? (largest, largestTime) : (velocityBlock, velocityTimes);
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

    /// <summary>The change of place and time at the end, by differences of fourth order; the finer of two that agree.</summary>
    private bool Difference(
        Vector3d position, Vector3d velocity, Vector3d spin, int column, StopAt stopAt, double duration, BallEvent[] events, out Vector3d change, out double time)
    {
        double width = column < 3 ? Width : 10 * Width;
        change = default;
        time = 0;
        bool had = false;
        for (int i = 0; i < Halvings; i++, width *= 0.5)
        {
            bool same = Quotient(position, velocity, spin, column, width, stopAt, duration, events, out Vector3d narrow, out double narrowTime);
            same &= Quotient(position, velocity, spin, column, 2 * width, stopAt, duration, events, out Vector3d wide, out double wideTime);
            if (!same)
            {
                continue;
            }

            // (4 q(h) − q(2h))/3
            Vector3d better = narrow + ((narrow - wide) / 3);
            double betterTime = narrowTime + ((narrowTime - wideTime) / 3);
            double close = 0.3 * Reach;
            bool agrees = had && Largest(better - change) <= close * Math.Max(1e-2, Largest(better)) && Math.Abs(betterTime - time) <= close * Math.Max(1e-2, Math.Abs(betterTime));
            had = true;
            change = better;
            time = betterTime;
            if (agrees)
            {
                return true;
            }
        }

        return false;
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
