namespace FootballPhysics.Labs;

/// <summary>Counts the simulated kicks that are found again, by every query that has a solution then.</summary>
internal static class KnownKickCounts
{
    public static readonly string[] Columns =
        ["kicks", "low arc", "high arc", "at their time", "no slower one", "below 45°", "two points below 45°", "false hits", "most simulations"];

    /// <summary>The number of kicks per scene.</summary>
    private const int PerScene = 10;

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the kicks.</param>
    /// <param name="count">The number of kicks.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">The number of different balls to use.</param>
    public static LabCounts Of(int seed, int count, double wind, int balls) =>
        LabCounts.Of(count, PerScene, (counts, index, kicks) => Run(counts, seed, index, kicks, wind, balls));

    private static void Run(LabCounts counts, int seed, int index, int count, double wind, int balls)
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
            double more = random.Between(1, 1.3);
            AimResult low = aimer.Find(request);
            AimResult high = aimer.Find(request with { Arc = AimArc.High });
            AimResult timed = aimer.FindAtTime(request with { Speed = more * request.Speed }, kick.Time);
            AimResult exact = aimer.FindAtTime(request, kick.Time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = more * request.Speed });
            AimResult two = aimer.Find(kick.TwoPoint);
            bool passes = two.Miss <= request.Tolerance && two.WaypointMiss <= request.WaypointTolerance;
            bool flat = kick.Elevation <= 45;
            counts.Add("kicks");
            counts.AddIf(flat, "below 45°");
            Require(low.Status == AimStatus.Hit, "low arc", "low", in low);
            Require(high.Status == AimStatus.Hit && high.Time >= low.Time - 0.01, "high arc", "high", in high);
            Require(timed.Status == AimStatus.Hit && exact.Status == AimStatus.Hit, "at their time", "timed", timed.Status == AimStatus.Hit ? exact : timed);
            Require(slowest.Status == AimStatus.Hit && slowest.Velocity.Length <= 1.001 * request.Speed, "no slower one", "slowest", in slowest);
            Require(passes, flat ? "two points below 45°" : "two points above 45°", flat ? "two points, flat" : "two points, steep", in two);
            RequireTruth(request, in low);
            RequireTruth(request, in high);
            RequireTruth(request, in slowest);
            RequireTruth(kick.TwoPoint, in two);
            counts.Most("most iterations", (long)Math.Max(low.Iterations, Math.Max(high.Iterations, two.Iterations)));
            counts.Most("most simulations", (long)Math.Max(low.Simulations, Math.Max(high.Simulations, two.Simulations)));

            void RequireTruth(AimRequest aim, in AimResult result) => Require(
                !result.HitsTarget || truth.Of(aim, result.Velocity, result.Spin) <= TrueMiss.Rounding * aim.Tolerance, "false hits", "false hit", in result);

            void Require(bool found, string column, string question, in AimResult result) => counts.Require(
                found,
                column,
                $"{question} {index}: {result.Status}, miss {result.Miss:0.000000} m; at {kick.Time} s, {kick.Elevation:0.00}°, through {kick.Between}; {scene.Ball.Mass} kg, wind {scene.Air.Wind}; {kick.Request}");
        }
    }
}
