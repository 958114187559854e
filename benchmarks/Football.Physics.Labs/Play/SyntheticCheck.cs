namespace FootballPhysics.Labs.Play;

/// <summary>Counts the pieces of simulated minutes that a fit finds, and the share of true values within its uncertainty.</summary>
internal sealed class SyntheticCheck
{
    /// <summary>Shorter flights are not counted, s.</summary>
    private const double Shortest = 0.3;

    /// <summary>A flight is found if the overlap of both intervals exceeds this share of their union. A flight begins up to a frame before its first point.</summary>
    private const double Overlap = 0.8;
    private const double Frame = SyntheticMatch.Interval;

    /// <summary>A hop that rises by no more than this many standard deviations of a point cannot be distinguished from rolling.</summary>
    private const double RiseShare = 5;

    /// <summary>An event is found if its time is within this error, s.</summary>
    private const double EventError = 0.05;

    /// <summary>Six numbers are in a joint 95 % box if each is within this many standard deviations.</summary>
    private const double Box = 2.631;

    private const double One = 1.96;

    /// <summary>Pairs of counts: flights and those found, impacts, launches and those within the uncertainty, numbers of the track's fit and those within 1.96 standard deviations.</summary>
    public LabCounts Counts { get; } = new();

    public double Squares { get; private set; }

    public void Run(SyntheticMatch match)
    {
        MatchFitResult fit = new MatchFit(SyntheticMatch.Known).Find([.. match.Seen], new MatchFitRequest { Crisis = false });
        Squares += fit.Rms * fit.Rms;
        CountFlights(match, fit);
        CountNumbers(match, fit);
    }

    private void CountFlights(SyntheticMatch match, MatchFitResult fit)
    {
        MatchPiece[] flights = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight)];
        double from = 0;
        foreach ((double time, bool impact) in match.Events.Append((match.Truth[^1].Time, false)))
        {
            double first = from;
            from = time;

            // Require a flight that is airborne and visible throughout: a gap or a seam splits it in two.
            bool flies = time - first >= Shortest && match.Truth.Where(ball => ball.Time > first + 1e-9 && ball.Time < time - 1e-9).All(ball => ball.Motion == MotionState.Airborne);
            bool isSeen = !match.Gaps.Exists(gap => gap.From < time && gap.To > first) && !Array.Exists(match.Seams, seam => seam > first && seam < time);
            double rise = match.Truth.Where(ball => ball.Time > first && ball.Time < time).Select(ball => ball.Position.Y).DefaultIfEmpty().Max()
                - Math.Max(match.Truth.Last(ball => ball.Time <= first + 1e-9).Position.Y, match.Truth.Last(ball => ball.Time <= time + 1e-9).Position.Y);
            bool isDistinct = !impact || rise > RiseShare * match.Noise;
            if (!flies || !isSeen || !isDistinct)
            {
                continue;
            }

            Counts.Add("flights");
            MatchPiece? found = Array.Find(flights, piece => Math.Min(piece.EndTime + Frame, time) - Math.Max(piece.StartTime - Frame, first) > Overlap * (Math.Max(piece.EndTime, time) - Math.Min(piece.StartTime, first)));
            Counts.AddIf(found is not null, "flights found");
            if (impact && time < match.Truth[^1].Time)
            {
                Counts.Add("impacts");
                Counts.AddIf(fit.Pieces.Any(piece => piece.Kind == MatchPieceKind.Impact && Math.Abs(piece.StartTime - time) < EventError), "impacts found");
            }

            if (found is not null)
            {
                (Vector3d velocity, Vector3d spin) = TruthAt(match, found.StartTime, first);
                Counts.Add("launches");
                Counts.AddIf(IsWithin(velocity - found.Velocity, found.VelocityDeviation) && IsWithin(spin - found.Spin, found.SpinDeviation), "launches within");
            }
        }
    }

    /// <summary>Returns the true velocity and spin at the start of a found flight. If the fit starts a frame too early, the truth is extrapolated to that time.</summary>
    private static (Vector3d Velocity, Vector3d Spin) TruthAt(SyntheticMatch match, double time, double first)
    {
        int at = match.Truth.FindIndex(ball => ball.Time > Math.Max(time - 1e-6, first));
        BallState next = match.Truth[at];
        BallState second = match.Truth[Math.Min(match.Truth.Count - 1, at + 1)];
        Vector3d acceleration = (second.Velocity - next.Velocity) / SyntheticMatch.Interval;
        return (next.Velocity - ((next.Time - time) * acceleration), next.Spin);
    }

    private void CountNumbers(SyntheticMatch match, MatchFitResult fit)
    {
        for (int i = 0; i < fit.Names.Count; i++)
        {
            double? truth = fit.Names[i] switch
            {
                "wind.x" => match.Wind.X,
                "wind.z" => match.Wind.Z,
                "drag" => match.Drag,
                _ => null,
            };
            if (truth is { } number)
            {
                Counts.Add("numbers");
                Counts.AddIf(Math.Abs(fit.Value(i) - number) <= One * fit.StandardError(i), "numbers within");
            }
        }
    }

    private static bool IsWithin(Vector3d off, Vector3d deviation) =>
        Math.Abs(off.X) <= Box * deviation.X && Math.Abs(off.Y) <= Box * deviation.Y && Math.Abs(off.Z) <= Box * deviation.Z;
}

/// <summary>A simulated minute of a match, and the track that a tracker would have recorded.</summary>
internal sealed class SyntheticMatch(SeededRandom random)
{
    public const double Interval = 0.02;
    private const double Length = 60;

    /// <summary>Half the size of the pitch, m.</summary>
    private const double HalfLength = 50;
    private const double HalfWidth = 32;

    /// <summary>The wind, m/s, the factor of the drag, and the height of the ground, m.</summary>
    public Vector3d Wind { get; private set; }

    public double Drag { get; private set; }

    public double GroundHeight { get; private set; }

    /// <summary>Standard deviation of each coordinate, m.</summary>
    public double Noise { get; private init; }

    /// <summary>The initial scene of a fit: the ball without the factor, no wind.</summary>
    public static Scene Known { get; } = new() { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };

    /// <summary>The true ball at every sample.</summary>
    public List<BallState> Truth { get; } = [];

    /// <summary>The times at which a player touched the ball or it hit the ground, in order, s.</summary>
    public List<(double Time, bool Impact)> Events { get; } = [];

    /// <summary>The points that the tracker recorded.</summary>
    public List<TrackPoint> Seen { get; } = [];

    /// <summary>The times without a track, s.</summary>
    public List<(double From, double To)> Gaps { get; } = [];

    /// <summary>Simulates a minute and records its track.</summary>
    /// <param name="random">The random numbers.</param>
    /// <param name="noise">Standard deviation of each coordinate, m.</param>
    public static SyntheticMatch Play(SeededRandom random, double noise)
    {
        var match = new SyntheticMatch(random) { Noise = noise };
        match.Play();
        match.See(noise);
        return match;
    }

    private void Play()
    {
        // 1. Kick a ball at rest. 2. It flies, bounces and rolls until a player touches it: in the air, at a bounce, or on the ground. 3. Repeat, towards the middle of the pitch.
        Wind = new Vector3d(Normal(0, 1.5), 0, Normal(0, 1.5));
        Drag = Normal(1, 0.12);
        GroundHeight = random.Uniform(-0.1, 0.1);
        Scene scene = Known with
        {
            Air = Known.Air with { Wind = Wind },
            Ground = Known.Ground with
            {
                Material = Known.Ground.Material with
                {
                    NormalRestitution = random.Uniform(0.56, 0.68),
                    ImpactFriction = random.Uniform(0.3, 0.6),
                },
                Height = GroundHeight,
            },
        };
        scene = scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, Drag, 1)] } };
        var simulator = new Simulator(scene);
        var log = new StepLog();
        var middle = new Vector3d(random.Uniform(-HalfLength, HalfLength), simulator.ContactHeight, random.Uniform(-HalfWidth, HalfWidth));
        BallState ball = simulator.Launch(middle, Vector3d.Zero, Vector3d.Zero);
        double next = random.Uniform(0.5, 1.5);
        for (int i = 0; i * Interval < Length; i++)
        {
            double end = i * Interval;
            if (next < end)
            {
                Step(simulator, ref ball, next - ball.Time, log);
                Touch(simulator, ref ball);
                Events.Add((next, false));
                next += Wait();
            }

            Step(simulator, ref ball, end - ball.Time, log);
            Truth.Add(ball);
        }
    }

    private void Step(Simulator simulator, ref BallState ball, double dt, StepLog log)
    {
        if (!(dt > 0))
        {
            return;
        }

        log.Clear();
        simulator.Step(ref ball, dt, log);
        Events.AddRange(log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Impact).Select(item => (item.Time, true)));
    }

    private double Wait() => random.Chance(0.25) ? random.Uniform(0.5, 1.2) : random.Uniform(1.5, 6);

    /// <summary>Applies a kick or a header, never along the ball's own direction at its own speed.</summary>
    private void Touch(Simulator simulator, ref BallState ball)
    {
        Vector3d velocity;
        do
        {
            double speed = random.Chance(0.3) ? random.Uniform(4, 10) : random.Uniform(10, 28);
            double elevation = random.Uniform(0, ball.Position.Y > 1 ? 40 : 45) * Math.PI / 180;
            Vector3d home = new Vector3d(random.Uniform(-0.7, 0.7) * HalfLength, 0, random.Uniform(-0.7, 0.7) * HalfWidth) - ball.Position;
            double heading = Math.Atan2(home.Z, home.X) + random.Uniform(-0.4, 0.4);
            velocity = new Vector3d(speed * Math.Cos(elevation) * Math.Cos(heading), speed * Math.Sin(elevation), speed * Math.Cos(elevation) * Math.Sin(heading));
        }
        while ((velocity - ball.Velocity).Length < 3);
        simulator.Kick(ref ball, velocity, random.Uniform(0, 60) * random.Direction());
    }

    private void See(double noise)
    {
        // Add noise, a height error near the ground, up to two gaps, a seam, and outliers.
        int gaps = random.Below(3);
        for (int i = 0; i < gaps; i++)
        {
            double from = random.Uniform(2, Length - 3);
            Gaps.Add((from, from + random.Uniform(0.2, 1)));
        }

        double seam = random.Chance(0.5) ? random.Uniform(2, Length - 2) : Length;
        Vector3d offset = random.Uniform(0.02, 0.1) * random.Direction();
        double seamEnd = seam + random.Uniform(0.5, 4);
        double wrong = random.Uniform(-0.08, 0.08);
        foreach (BallState ball in Truth)
        {
            if (Gaps.Exists(gap => ball.Time > gap.From && ball.Time < gap.To))
            {
                continue;
            }

            double height = ball.Position.Y - GroundHeight - 0.11;
            Vector3d place = ball.Position + new Vector3d(Normal(0, noise), Normal(0, noise) + (wrong * Math.Exp(-height / 0.15)), Normal(0, noise));
            place += ball.Time > seam && ball.Time < seamEnd ? offset : Vector3d.Zero;
            place += random.Chance(0.001) ? random.Uniform(0.5, 3) * random.Direction() : Vector3d.Zero;
            Seen.Add(new TrackPoint(ball.Time, place, 1e-4));
        }

        Seams = [seam, seamEnd];
    }

    /// <summary>The times at which a seam began and ended, s.</summary>
    public double[] Seams { get; private set; } = [];

    private double Normal(double mean, double deviation)
    {
        double sum = -6;
        for (int i = 0; i < 12; i++)
        {
            sum += random.Next();
        }

        return mean + (deviation * sum);
    }
}
