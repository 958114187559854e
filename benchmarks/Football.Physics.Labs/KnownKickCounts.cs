namespace FootballPhysics.Labs;

/// <summary>How many kicks that were flown are found again, by every question that has an answer then.</summary>
internal sealed class KnownKickCounts
{
    /// <summary>Kicks with one scene.</summary>
    private const int PerScene = 10;

    private readonly Lock _lock = new();
    private readonly List<string> _examples = [];

    /// <summary>Kicks that were asked for.</summary>
    public int Kicks { get; private set; }

    /// <summary>Kicks that are no steeper than 45°.</summary>
    public int Flat { get; private set; }

    public int LowMissed { get; private set; }

    public int HighMissed { get; private set; }

    public int TimedMissed { get; private set; }

    public int SlowestMissed { get; private set; }

    public int TwoPointMissed { get; private set; }

    public int FlatTwoPointMissed { get; private set; }

    /// <summary>Answers that are called a hit and miss when they are flown.</summary>
    public int FalseHits { get; private set; }

    public int MostIterations { get; private set; }

    public int MostSimulations { get; private set; }

    public double MeanSimulations { get; private set; }

    /// <summary>The first few that were not found.</summary>
    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal);

    /// <summary>Asks for kicks, on all processors.</summary>
    /// <param name="seed">Seed of the kicks.</param>
    /// <param name="count">How many.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">With how many of the balls.</param>
    public static KnownKickCounts Of(int seed, int count, double wind, int balls)
    {
        var counts = new KnownKickCounts();
        Parallel.For(0, (count + PerScene - 1) / PerScene, index => counts.Run(seed, index, Math.Min(PerScene, count - (index * PerScene)), wind, balls));
        return counts;
    }

    private void Run(int seed, int index, int count, double wind, int balls)
    {
        var random = new Random((seed * 100_003) + index);
        Scene scene = KnownKick.Scene(random, index % balls, wind);
        var simulator = new Simulator(scene);
        var aimer = new Aimer(scene);
        var path = new Trajectory(16384);
        var truth = new TrueMiss(scene);
        for (int i = 0; i < count; i++)
        {
            KnownKick kick = KnownKick.Draw(random, simulator, path);
            AimRequest request = kick.Request;
            double more = AimSets.Between(random, 1, 1.3);
            AimResult low = aimer.Find(request);
            AimResult high = aimer.Find(request with { Arc = AimArc.High });
            AimResult timed = aimer.FindAtTime(request with { Speed = more * request.Speed }, kick.Time);
            AimResult exact = aimer.FindAtTime(request, kick.Time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = more * request.Speed });
            AimResult two = aimer.Find(kick.TwoPoint);
            bool passes = two.Miss <= request.Tolerance && two.WaypointMiss <= request.WaypointTolerance;
            int falseHits = FalseHit(truth, request, in low, index, kick, scene) + FalseHit(truth, request, in high, index, kick, scene)
                + FalseHit(truth, request, in slowest, index, kick, scene) + FalseHit(truth, kick.TwoPoint, in two, index, kick, scene);
            lock (_lock)
            {
                Kicks++;
                FalseHits += falseHits;
                bool flat = kick.Elevation <= 45;
                Flat += flat ? 1 : 0;
                LowMissed += Missed(low.Status == AimStatus.Hit, "low", index, kick, scene, in low);
                HighMissed += Missed(high.Status == AimStatus.Hit && high.Time >= low.Time - 0.01, "high", index, kick, scene, in high);
                bool timely = timed.Status == AimStatus.Hit && exact.Status == AimStatus.Hit;
                TimedMissed += Missed(timely, "timed", index, kick, scene, timed.Status == AimStatus.Hit ? exact : timed);
                SlowestMissed += Missed(slowest.Status == AimStatus.Hit && slowest.Velocity.Length <= 1.001 * request.Speed, "slowest", index, kick, scene, in slowest);
                int missed = Missed(passes, flat ? "two points, flat" : "two points, steep", index, kick, scene, in two);
                TwoPointMissed += missed;
                FlatTwoPointMissed += flat ? missed : 0;
                MostIterations = Math.Max(MostIterations, Math.Max(low.Iterations, Math.Max(high.Iterations, two.Iterations)));
                MostSimulations = Math.Max(MostSimulations, Math.Max(low.Simulations, Math.Max(high.Simulations, two.Simulations)));
                MeanSimulations += low.Simulations;
            }
        }
    }

    private int FalseHit(TrueMiss truth, AimRequest request, in AimResult result, int index, KnownKick kick, Scene scene)
    {
        if (!result.HitsTarget || truth.Of(request, result.Velocity, result.Spin) <= TrueMiss.Rounding * request.Tolerance)
        {
            return 0;
        }

        lock (_lock)
        {
            return Missed(false, "false hit", index, kick, scene, in result);
        }
    }

    private int Missed(bool found, string question, int index, KnownKick kick, Scene scene, in AimResult result)
    {
        if (!found)
        {
            _examples.Add(FormattableString.Invariant(
                $"{question} {index}: {result.Status}, miss {result.Miss:0.000000} m; at {kick.Time} s, {kick.Elevation:0.00}°, through {kick.Between}; {scene.Ball.Mass} kg, wind {scene.Air.Wind}; {kick.Request}"));
        }

        return found ? 0 : 1;
    }
}
