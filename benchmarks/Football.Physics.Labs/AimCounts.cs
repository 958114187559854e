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

/// <summary>Aims at targets on and over slopes, and checks that hits pass the target when they are simulated.</summary>
internal static class SlopeCounts
{
    public static readonly string[] Columns = ["requests", "hits", "false hits", "worst, mm"];

    private const int PerScene = 20;

    /// <summary>The error that the chords of the simulated path may add, m.</summary>
    private const double Room = 1e-3;

    private const double TimeStep = 1e-3;

    /// <summary>Aims kicks.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="steepest">The steepest slope, as a share.</param>
    /// <param name="isUneven">True if the ground is a height field.</param>
    public static LabCounts Of(int seed, int count, double steepest, bool isUneven) =>
        LabCounts.Of(count, PerScene, (counts, index, requests) => Run(counts, new Random((seed * 100_003) + index), requests, steepest, isUneven));

    private static Ground GroundOf(Random random, double steepest, bool isUneven)
    {
        double x = random.Between(-steepest, steepest);
        double z = random.Between(-steepest, steepest);
        if (!isUneven)
        {
            return new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(x, 1, z).Normalized() };
        }

        // Long waves with the same steepness.
        return new Ground { Material = SurfaceMaterial.DryTurf, Heights = LabMath.Hills(-40, -40, 2, 40, (i, j) => 5 * ((x * Math.Sin(0.4 * i)) + (z * Math.Cos(0.4 * j)))) };
    }

    private static void Run(LabCounts counts, Random random, int count, double steepest, bool isUneven)
    {
        var simulator = new Simulator(new Scene { Ground = GroundOf(random, steepest, isUneven) });
        var aimer = new Aimer(simulator);
        for (int i = 0; i < count; i++)
        {
            double away = random.Between(5, 28);
            double angle = random.Between(-Math.PI, Math.PI);
            Vector3d from = Lying(simulator, 0, 0);
            Vector3d target = Lying(simulator, away * Math.Cos(angle), away * Math.Sin(angle)) + ((i % 3 == 0 ? random.Between(0, 2) : 0) * Vector3d.Up);
            var request = new AimRequest { From = from, Target = target, Speed = random.Between(10, 28) };
            AimResult kick = i % 5 == 4 ? aimer.FindSlowest(request) : aimer.Find(request);
            double passes = kick.Status == AimStatus.Hit ? Closest(simulator, from, target, in kick) : 0;
            counts.Add("requests");
            counts.AddIf(kick.Status == AimStatus.Hit, "hits");
            counts.Require(passes <= request.Tolerance + Room, "false hits", $"{simulator.Scene.Ground.Normal}: {request}: {kick}, passes {passes} m off");
            counts.Most("worst, mm", 1e3 * passes);
        }
    }

    private static Vector3d Lying(Simulator simulator, double x, double z) => simulator.Launch(new Vector3d(x, -20, z), Vector3d.Zero, Vector3d.Zero).Position;

    /// <summary>Returns the closest distance of the ball on chords of its path.</summary>
    private static double Closest(Simulator simulator, Vector3d from, Vector3d target, in AimResult kick)
    {
        BallState ball = simulator.Launch(from, kick.Velocity, kick.Spin);
        var log = new StepLog();
        double closest = Vector3d.Distance(ball.Position, target);
        while (ball.Time < kick.Time + 0.1)
        {
            Vector3d before = ball.Position;
            log.Clear();
            simulator.Step(ref ball, TimeStep, log);
            Vector3d way = ball.Position - before;
            double share = way.LengthSquared > 0 ? Math.Clamp(Vector3d.Dot(target - before, way) / way.LengthSquared, 0, 1) : 0;
            closest = Math.Min(closest, Vector3d.Distance(before + (share * way), target));
        }

        return closest;
    }
}
