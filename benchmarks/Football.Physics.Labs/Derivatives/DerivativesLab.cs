using System.CommandLine;

namespace FootballPhysics.Labs.Derivatives;

/// <summary>football lab derivatives: compares derivatives of random flights by the launch with central differences of the simulation.</summary>
internal static class DerivativesLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "derivatives",
            "Derivatives of the end position and time by the launch, compared with central differences: random flights with bounces, posts, nets and slopes.",
            ["football lab derivatives", "football lab derivatives --flights 2 --seed 7"]);
        Option<long> flights = lab.Whole("--flights", "Flights of each kind.", 1, 1_000_000, 3);
        Option<long> step = lab.Whole("--step", "Time step in ms.", 1, 20, 10);
        return lab.Plays(run => Run(run, run.Int(flights), 0.001 * run.Get(step)));
    }

    private static void Run(LabRun run, int flights, double timeStep)
    {
        LabTable table = run.Table(
            FormattableString.Invariant($"Derivatives by the launch: error of the largest entry of a block, at RK4 {1000 * timeStep:0} ms"),
            "kind", "flights", "on edge", "uncertain", "impacts", "slides", "nets", "median", "90 %", "worst", "within 1e-6, %", "within 1e-5, %", "verdict");
        foreach (DerivativesKind kind in Enum.GetValues<DerivativesKind>())
        {
            var check = new DerivativesCheck(kind, timeStep);
            for (int i = 0; i < flights; i++)
            {
                run.Progress.Report(((int)kind * flights) + i, 5 * flights, () => kind.ToString());
                check.Run(run.Random(((int)kind * 1_000_003) + i));
            }

            double[] errors = [.. check.Errors.Order()];
            double At(double share) => errors.Length == 0 ? double.NaN : errors[Math.Min(errors.Length - 1, (int)(share * errors.Length))];
            double within = 100.0 * errors.Count(error => error <= DerivativesCheck.Reach) / Math.Max(1, errors.Length);
            double close = 100.0 * check.Errors.Count(error => error <= 10 * DerivativesCheck.Reach) / Math.Max(1, errors.Length);
            table.Add(
                [kind, errors.Length, .. check.Counts.Cells("on edge", "uncertain", "Impact", "Slide", "Net"), At(0.5), At(0.9), At(1), within, close, Verdict.Of(within >= 99)]);
        }

        run.Notes.Add("Not judged are flights on edge (a launch that differs by 2 µm/s, or 20 µrad/s, goes through other events) and uncertain ones (at no width do differences agree with the next wider and narrower to 3e-7). Reached: 99 % are within 1e-6.");
    }
}

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

    private static readonly Vector3d[] s_axes = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];

    private readonly Simulator _simulator = new(DerivativesScenes.Of(kind));
    private readonly StepLog _log = new();

    /// <summary>The largest error of each flight, as a share of the largest entry of its block.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>
    /// The events of all flights, by kind. "uncertain": the flights whose differences do not agree at any width, so that they are no better than the
    /// derivatives under test. "on edge": the flights at the edge of another sequence of events, because no four adjacent widths give the same sequence.
    /// </summary>
    public LabCounts Counts { get; } = new();

    /// <summary>Draws a flight and compares its derivatives.</summary>
    public void Run(SeededRandom random)
    {
        (Vector3d position, Vector3d velocity, Vector3d spin) = DerivativesScenes.Launch(kind, random);
        StopAt stopAt = random.Any(StopAt.Impact, StopAt.Time, StopAt.Rest);
        stopAt = kind == DerivativesKind.Hills ? StopAt.Impact : stopAt;
        var flight = new Flight(position, velocity, spin, stopAt, stopAt == StopAt.Time ? random.Uniform(0.5, 4) : 30);
        var derivatives = new LaunchDerivatives(_simulator);
        BallState state = _simulator.Launch(position, velocity, spin);
        bool ended = derivatives.Run(ref state, timeStep, flight.Duration, stopAt);
        BallEvent[] events = derivatives.Events.Span.ToArray();
        End(flight);
        long pieces = _log.Steps;
        Vector3d[] found = [.. s_axes.Select(axis => derivatives.PositionByVelocity * axis), .. s_axes.Select(axis => derivatives.PositionBySpin * axis)];
        Vector3d[] times = [derivatives.TimeByVelocity, derivatives.TimeBySpin];
        double worst = 0;
        double velocityBlock = 0;
        double velocityTimes = 0;
        for (int block = 0; block < 2; block++)
        {
            var wanted = new Difference[3];
            for (int axis = 0; axis < 3; axis++)
            {
                // Another number of pieces shifts the end by the error of a step, which is not part of the derivative. Use those differences only if there are no others.
                int column = (3 * block) + axis;
                if (!Differ(flight, column, events, pieces, out wanted[axis]) && !Differ(flight, column, events, null, out wanted[axis]))
                {
                    Counts.Add("on edge");
                    return;
                }
            }

            // Compare the effect of a spin with at least a tenth of the effect of its surface speed as a velocity.
            double largest = Math.Max(wanted.Max(item => Largest(item.Place)), 0.1 * Radius * velocityBlock);
            double largestTime = Math.Max(wanted.Max(item => Math.Abs(item.Time)), 0.1 * Radius * velocityTimes);
            (velocityBlock, velocityTimes) = block == 0 ? (largest, largestTime) : (velocityBlock, velocityTimes);
            if (wanted.Max(item => item.PlaceError) > Certain * Reach * Math.Max(1e-6, largest)
                || (ended && wanted.Max(item => item.TimeError) > Certain * Reach * Math.Max(1e-6, largestTime)))
            {
                Counts.Add("uncertain");
                return;
            }

            for (int axis = 0; axis < 3; axis++)
            {
                worst = Math.Max(worst, Largest(wanted[axis].Place - found[(3 * block) + axis]) / Math.Max(1e-6, largest));
                worst = Math.Max(worst, ended ? Math.Abs(wanted[axis].Time - Vector3d.Dot(times[block], s_axes[axis])) / Math.Max(1e-6, largestTime) : 0);
            }
        }

        Errors.Add(worst);
        foreach (BallEvent e in events)
        {
            Counts.Add(e.Kind.ToString());
        }
    }

    private static double Largest(Vector3d v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));

    /// <summary>Computes the change of position and time at the end, by differences of fourth order. Position and time each use the widths that agree best.</summary>
    private bool Differ(Flight flight, int column, BallEvent[] events, long? pieces, out Difference best)
    {
        double width = column < 3 ? Widest : 10 * Widest;
        best = new Difference(default, 0, double.PositiveInfinity, double.PositiveInfinity);
        var quotients = new (Vector3d Place, double Time)[3];
        var extrapolated = new (Vector3d Place, double Time)[3];
        int inARow = 0;
        for (int i = 0; i < Halvings && !IsCertain(in best); i++, width *= 0.5)
        {
            (Vector3d Place, double Time)? quotient = Quotient(flight, column, width, events, pieces);
            inARow = quotient is not null ? inARow + 1 : 0;
            quotients.AsSpan(1).CopyTo(quotients);
            (Vector3d place, double time) = quotients[2] = quotient ?? default;
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
            best = error < best.PlaceError ? best with { Place = middle, PlaceError = error } : best;
            best = timeError < best.TimeError ? best with { Time = middleTime, TimeError = timeError } : best;
        }

        return best.PlaceError < double.PositiveInfinity;
    }

    private static bool IsCertain(in Difference difference) =>
        difference.PlaceError <= Agreed * Largest(difference.Place) && difference.TimeError <= Agreed * Math.Abs(difference.Time);

    /// <summary>Returns a difference quotient; null if a changed launch has other events or another number of pieces.</summary>
    private (Vector3d Place, double Time)? Quotient(Flight flight, int column, double width, BallEvent[] events, long? pieces)
    {
        Vector3d by = width * s_axes[column % 3];
        (Vector3d velocityBy, Vector3d spinBy) = column < 3 ? (by, Vector3d.Zero) : (Vector3d.Zero, by);
        (Vector3d high, double later) = End(flight with { Velocity = flight.Velocity + velocityBy, Spin = flight.Spin + spinBy });
        if (!IsSame(events, pieces))
        {
            return null;
        }

        (Vector3d low, double sooner) = End(flight with { Velocity = flight.Velocity - velocityBy, Spin = flight.Spin - spinBy });
        return IsSame(events, pieces) ? ((high - low) / (2 * width), (later - sooner) / (2 * width)) : null;
    }

    /// <summary>Simulates a flight and returns its end.</summary>
    private (Vector3d Place, double Time) End(Flight flight)
    {
        _log.Clear();
        BallState state = _simulator.Fly(flight.Position, flight.Velocity, flight.Spin, timeStep, flight.Duration, flight.StopAt, _log);
        return (state.Position, state.Time);
    }

    /// <summary>True if the last flight had the same events and, if a number of pieces is given, the same number of pieces.</summary>
    private bool IsSame(BallEvent[] events, long? pieces) => (pieces is null || _log.Steps == pieces)
        && _log.Events.Span.ToArray().Select(item => (item.Kind, item.ColliderIndex)).SequenceEqual(events.Select(item => (item.Kind, item.ColliderIndex)));

    private sealed record Flight(Vector3d Position, Vector3d Velocity, Vector3d Spin, StopAt StopAt, double Duration);

    /// <summary>A difference quotient of the end of a flight.</summary>
    /// <param name="Place">The change of the position at the end.</param>
    /// <param name="Time">The change of the time at the end.</param>
    /// <param name="PlaceError">The uncertainty of the position's change: the largest component of its difference from the quotients of twice and half the width.</param>
    /// <param name="TimeError">The uncertainty of the time's change.</param>
    private readonly record struct Difference(Vector3d Place, double Time, double PlaceError, double TimeError);
}

/// <summary>The scenes and launches of the flights whose derivatives are compared.</summary>
internal static class DerivativesScenes
{
    public static Scene Of(DerivativesKind kind) => kind switch
    {
        DerivativesKind.Published => Scene.Published with { Air = new Air { Wind = new Vector3d(1, 0, -2) } },
        DerivativesKind.Measured => Scene.Measured with { Air = new Air { Wind = new Vector3d(1, 0, -2) } },
        DerivativesKind.Goal => Scene.Measured with { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1), Surface = SurfaceMaterial.GoalFrame }] },
        DerivativesKind.Slope => Scene.Published with
        {
            Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { TangentialRestitution = 0.5 }, Normal = new Vector3d(0.02, 1, 0.01) },
            Obstacles =
            [
                new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -14), new Vector3d(0, 0, 1)), Surface = SurfaceMaterial.PublishedGoalFrame },
                new Obstacle { Name = "player", Shape = new CapsuleShape(new Vector3d(-2, 0, -8), new Vector3d(-2, 1.6, -8), 0.25), Surface = SurfaceMaterial.PublishedGoalFrame, Velocity = new Vector3d(2, 0, 0) },
            ],
        },
        DerivativesKind.Hills => Scene.Measured with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Heights = LabMath.Hills(-60, -60, 4, 31, (i, j) => 0.15 * Math.Sin(0.9 * i) * Math.Cos(0.7 * j)) } },
        _ => throw new ArgumentOutOfRangeException(nameof(kind)),
    };

    /// <summary>Draws a launch from the ground, or just above it.</summary>
    public static (Vector3d Position, Vector3d Velocity, Vector3d Spin) Launch(DerivativesKind kind, SeededRandom random)
    {
        Vector3d spin = random.Uniform(3, 60) * random.Direction();
        if (kind is DerivativesKind.Published or DerivativesKind.Measured)
        {
            return (new Vector3d(0, 0.11, 0), random.Velocity(5, 32, 3, 50), spin);
        }

        // Aim at the goal, the wall or the player.
        double speed = random.Uniform(8, 30);
        var target = new Vector3d(random.Uniform(-4.2, 4.2), random.Uniform(0, 2.7), kind == DerivativesKind.Slope ? -8 : -12);
        var from = new Vector3d(0, 0.5, 0);
        Vector3d way = target - from;
        double time = way.Length / speed;
        return (from, (way / time) + new Vector3d(0, 4.9 * time, 0), spin);
    }
}

/// <summary>The kinds of flights whose derivatives are compared.</summary>
internal enum DerivativesKind
{
    /// <summary>Air and level ground; the published profile.</summary>
    Published,

    /// <summary>Air and level ground; the measured profile.</summary>
    Measured,

    /// <summary>A goal with posts, bar and nets; the measured profile.</summary>
    Goal,

    /// <summary>A slope with standing and moving objects; the published profile.</summary>
    Slope,

    /// <summary>Hills; the measured profile.</summary>
    Hills,
}
