namespace FootballPhysics.Labs;

/// <summary>Counts the simulated passes along the ground that are found again: at their time, and no faster than they were.</summary>
internal static class GroundPassCounts
{
    public static readonly string[] Columns = ["passes", "found", "at their time", "no slower one", "false hits"];

    private const int PerScene = 10;

    /// <summary>Aims passes, on all processors.</summary>
    /// <param name="seed">Seed of the passes.</param>
    /// <param name="count">The number of passes.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">The number of different balls to use.</param>
    public static LabCounts Of(int seed, int count, double wind, int balls) =>
        LabCounts.Of(count, PerScene, (counts, index, passes) => Run(counts, seed, index, passes, wind, balls));

    private static void Run(LabCounts counts, int seed, int index, int count, double wind, int balls)
    {
        var random = new Random((seed * 100_019) + index);
        Scene scene = KnownKick.Scene(random, index % balls, wind);
        var simulator = new Simulator(scene);
        var aimer = new Aimer(scene);
        var truth = new TrueMiss(scene);
        var path = new Trajectory(16384);
        for (int i = 0; i < count; i++)
        {
            (AimRequest request, double time) = Draw(random, simulator, path);
            AimResult found = aimer.Find(request);
            AimResult timed = aimer.FindAtTime(request with { Speed = random.Between(1, 1.3) * request.Speed }, time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = 30, MaximumElevationDegrees = 45 });
            counts.Add("passes");
            Require(found.Status == AimStatus.Hit, "found", "pass", in found);
            Require(timed.Status == AimStatus.Hit, "at their time", "timed", in timed);
            Require(slowest.Status == AimStatus.Hit && slowest.Speed <= 1.001 * request.Speed, "no slower one", "slowest", in slowest);
            foreach (AimResult result in (AimResult[])[found, slowest])
            {
                bool isFalse = result.HitsTarget && truth.Of(request, result.Velocity, result.Spin) > TrueMiss.Rounding * request.Tolerance;
                Require(!isFalse, "false hits", "false hit", in result);
            }

            void Require(bool holds, string column, string question, in AimResult result) => counts.Require(
                holds, column, $"ground, {question} {index}: {result.Status}, {result.Speed:0.000} m/s, miss {result.Miss:0.000000} m; at {time} s; {request}");
        }
    }

    /// <summary>Draws a pass, and a point on its path with the time.</summary>
    private static (AimRequest Request, double Time) Draw(Random random, Simulator simulator, Trajectory path)
    {
        while (true)
        {
            double azimuth = random.Between(0, 2 * Math.PI);
            double speed = random.Between(3, 28);
            double top = random.Next(2) == 0 ? 0 : random.Between(-30, 30);
            double side = random.Next(2) == 0 ? 0 : random.Between(-30, 30);
            Vector3d direction = new(Math.Cos(azimuth), 0, Math.Sin(azimuth));
            BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), speed * direction, KickVectors.Spin(direction, top, side));
            simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 0.01, Duration = 10, StopAt = StopAt.Impact }, path);
            double time = random.Between(0.1, 0.9) * path.EndTime;
            Vector3d target = path.PositionAt(time);
            if (!path.IsComplete || target.Horizontal.Length < 1 || target.Y > simulator.ContactHeight)
            {
                continue;
            }

            var request = new AimRequest
            {
                From = new Vector3d(0, simulator.ContactHeight, 0),
                Target = target,
                Speed = speed,
                TopSpin = top,
                SideSpin = side,
                MaximumElevationDegrees = random.Next(2) == 0 ? 0 : 45,
            };
            return (request, time);
        }
    }
}

/// <summary>Counts the hits of batch aims that miss when they are simulated: low drives with backspin, which the ground blocks, and any kick.</summary>
internal static class BatchHitCounts
{
    public static readonly string[] Columns = ["requests", "hits", "false hits", "worst, mm"];

    private const int PerScene = 400;

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="drives">True for low drives with backspin.</param>
    public static LabCounts Of(int seed, int count, double wind, bool drives) =>
        LabCounts.Of(count, PerScene, (counts, index, requests) => Run(counts, seed, index, requests, wind, drives));

    private static void Run(LabCounts counts, int seed, int index, int count, double wind, bool drives)
    {
        var random = new Random((seed * 100_043) + index);
        Scene scene = KnownKick.Scene(random, index % KnownKick.Balls.Length, wind);
        double contact = scene.Ball.Radius;
        var aims = new BatchAims(count) { MaximumElevationDegrees = 60, Tolerance = 1e-3 };
        for (int i = 0; i < count; i++)
        {
            double distance = random.Between(5, 30);
            double angle = random.Between(0, 2 * Math.PI);
            double height = contact + (drives ? random.Between(0, 0.5) : random.Between(0, 3));
            var from = new Vector3d(0, contact + (drives || random.Next(2) == 0 ? 0 : random.Between(0, 2)), 0);
            double top = drives ? random.Between(-60, -20) : random.Between(-60, 60);
            aims.Set(i, from, new Vector3d(distance * Math.Cos(angle), height, distance * Math.Sin(angle)), random.Between(15, 35), top, random.Between(-30, 30));
        }

        var kicks = new BatchKicks(count);
        new BatchAimer(scene).Find(aims, kicks, count);
        var truth = new TrueMiss(scene);
        for (int i = 0; i < count; i++)
        {
            bool hit = kicks.Status[i] == AimStatus.Hit;
            double miss = hit ? truth.Of(new AimRequest { From = aims.From[i], Target = aims.Target[i] }, kicks.Velocity[i], kicks.Spin[i]) : 0;
            counts.Add("requests");
            counts.AddIf(hit, "hits");
            counts.AddIf(miss > TrueMiss.Rounding * aims.Tolerance, "false hits");
            counts.Most("worst, mm", 1e3 * miss);
        }
    }
}
