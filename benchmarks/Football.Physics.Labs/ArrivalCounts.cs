namespace FootballPhysics.Labs;

/// <summary>Counts the kicks found for a requested arrival speed, and those that arrive with it when simulated.</summary>
internal static class ArrivalCounts
{
    public static readonly string[] Columns = ["requests", "hits", "out of reach", "not converged", "known kicks", "not found again", "hits at another speed", "worst, m/s"];

    /// <summary>The number of requests per aimer.</summary>
    private const int PerAimer = 20;

    /// <summary>A kick whose arrival speed is off by more than this, m/s, does not count.</summary>
    private const double LargestError = 0.1;

    /// <summary>The kinds of targets: in the air, low for volleys, on the ground.</summary>
    public enum Kind
    {
        Air,
        Volley,
        Ground,
    }

    public static LabCounts Of(int seed, int count, Kind kind) =>
        LabCounts.Of(count, PerAimer, (counts, index, requests) => Run(counts, new Random((seed * 100_003) + index), requests, kind));

    private static void Run(LabCounts counts, Random random, int count, Kind kind)
    {
        var simulator = new Simulator();
        var aimer = new Aimer(simulator);
        for (int i = 0; i < count; i++)
        {
            double height = kind switch { Kind.Air => random.Between(0.5, 2.2), Kind.Volley => random.Between(0.2, 0.6), _ => 0.11 };
            double away = kind switch { Kind.Air => random.Between(8, 25), Kind.Volley => random.Between(4, 9), _ => random.Between(20, 45) };
            var request = new AimRequest
            {
                From = new Vector3d(0, kind == Kind.Volley ? 1 : 0.11, 0),
                Target = new Vector3d(random.Between(-3, 3), height, -away),
                Speed = kind == Kind.Volley ? random.Between(10, 20) : random.Between(20, 32),
                TopSpin = i % 3 == 0 ? random.Between(-20, 20) : 0,
                SideSpin = i % 4 == 0 ? random.Between(-30, 30) : 0,
            };

            // Request the arrival speed of a kick that hits, or any speed.
            AimResult witness = aimer.Find(request);
            bool isKnown = i % 2 == 0 && witness.Status == AimStatus.Hit;
            double wanted = isKnown ? Played(simulator, request, in witness) : random.Between(4, 25);
            AimResult kick = aimer.FindAtSpeed(request with { Speed = 35 }, wanted);
            double error = kick.Status == AimStatus.Hit ? Math.Abs(Played(simulator, request, in kick) - wanted) : 0;
            FormattableString example = $"{request}, {wanted} m/s: {kick}, {error} m/s off";
            counts.Add("requests");
            counts.AddIf(isKnown, "known kicks");
            counts.Require(!isKnown || kick.Status == AimStatus.Hit, "not found again", example);
            counts.AddIf(kick.Status == AimStatus.Hit, "hits");
            counts.AddIf(kick.Status == AimStatus.OutOfReach, "out of reach");
            counts.AddIf(kick.Status is not (AimStatus.Hit or AimStatus.OutOfReach), "not converged");
            counts.Require(error <= LargestError, "hits at another speed", example);
            counts.Most("worst, m/s", error);
        }
    }

    /// <summary>Returns the speed of a kick at its target, simulated in short steps. For a kick that comes down there, it is the speed before it touches the ground.</summary>
    private static double Played(Simulator simulator, AimRequest request, in AimResult kick)
    {
        BallState ball = simulator.Launch(request.From, kick.Velocity, kick.Spin);
        var log = new StepLog();
        bool touches = simulator.Run(ref ball, 2e-3, Math.Max(kick.Time, 1e-6), kick.Rolls ? StopAt.Time : StopAt.Impact, log);
        return (touches ? log.Events[log.Events.Count - 1].VelocityBefore : ball.Velocity).Length;
    }
}
