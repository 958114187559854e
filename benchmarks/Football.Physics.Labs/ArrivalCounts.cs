namespace FootballPhysics.Labs;

/// <summary>How many kicks are found that are to arrive with a speed, and whether they do when they are played.</summary>
internal sealed class ArrivalCounts
{
    /// <summary>Requests with one aimer.</summary>
    private const int PerAimer = 20;

    /// <summary>An arrival further off than this, m/s, is none.</summary>
    private const double LargestError = 0.1;

    private readonly Lock _lock = new();
    private readonly List<string> _examples = [];

    /// <summary>What the targets are: in the air, low ones for volleys, on the ground.</summary>
    public enum Kind
    {
        Air,
        Volley,
        Ground,
    }

    public int Requests { get; private set; }

    /// <summary>Requests for the arrival of a kick that is known.</summary>
    public int Known { get; private set; }

    /// <summary>Of those, how many have no answer.</summary>
    public int KnownMissed { get; private set; }

    public int Hits { get; private set; }

    public int OutOfReach { get; private set; }

    public int NotConverged { get; private set; }

    /// <summary>Hits that arrive with another speed when they are played.</summary>
    public int Wrong { get; private set; }

    /// <summary>The largest error of a hit, m/s.</summary>
    public double Worst { get; private set; }

    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal).Take(8);

    public static ArrivalCounts Of(int seed, int count, Kind kind)
    {
        var counts = new ArrivalCounts();
        Parallel.For(0, (count + PerAimer - 1) / PerAimer, index => counts.Run(new Random((seed * 100_003) + index), Math.Min(PerAimer, count - (index * PerAimer)), kind));
        return counts;
    }

    private void Run(Random random, int count, Kind kind)
    {
        double Between(double low, double high) => AimSets.Between(random, low, high);
        var simulator = new Simulator();
        var aimer = new Aimer(simulator);
        for (int i = 0; i < count; i++)
        {
            double height = kind switch { Kind.Air => Between(0.5, 2.2), Kind.Volley => Between(0.2, 0.6), _ => 0.11 };
            double away = kind switch { Kind.Air => Between(8, 25), Kind.Volley => Between(4, 9), _ => Between(20, 45) };
            var request = new AimRequest
            {
                From = new Vector3d(0, kind == Kind.Volley ? 1 : 0.11, 0),
                Target = new Vector3d(Between(-3, 3), height, -away),
                Speed = kind == Kind.Volley ? Between(10, 20) : Between(20, 32),
                TopSpin = i % 3 == 0 ? Between(-20, 20) : 0,
                SideSpin = i % 4 == 0 ? Between(-30, 30) : 0,
            };

            // The arrival of a kick that hits, or any speed.
            AimResult witness = aimer.Find(request);
            bool isKnown = i % 2 == 0 && witness.Status == AimStatus.Hit;
            double wanted = isKnown ? Played(simulator, request, in witness) : Between(4, 25);
            AimResult kick = aimer.FindAtSpeed(request with { Speed = 35 }, wanted);
            double error = kick.Status == AimStatus.Hit ? Math.Abs(Played(simulator, request, in kick) - wanted) : 0;
            lock (_lock)
            {
                Requests++;
                Known += isKnown ? 1 : 0;
                KnownMissed += isKnown && kick.Status != AimStatus.Hit ? 1 : 0;
                Hits += kick.Status == AimStatus.Hit ? 1 : 0;
                OutOfReach += kick.Status == AimStatus.OutOfReach ? 1 : 0;
                NotConverged += kick.Status is AimStatus.Hit or AimStatus.OutOfReach ? 0 : 1;
                Wrong += error > LargestError ? 1 : 0;
                Worst = Math.Max(Worst, error);
                if (error > LargestError || (isKnown && kick.Status != AimStatus.Hit))
                {
                    _examples.Add($"{request}, {wanted} m/s: {kick}, {error} m/s off");
                }
            }
        }
    }

    /// <summary>The speed of a kick at its target in short steps; of one that comes down there, before it touches the ground.</summary>
    private static double Played(Simulator simulator, AimRequest request, in AimResult kick)
    {
        BallState ball = simulator.Launch(request.From, kick.Velocity, kick.Spin);
        var log = new StepLog();
        bool touches = simulator.Run(ref ball, 2e-3, Math.Max(kick.Time, 1e-6), kick.Rolls ? StopAt.Time : StopAt.Impact, log);
        return (touches ? log.Events[log.Events.Count - 1].VelocityBefore : ball.Velocity).Length;
    }
}
