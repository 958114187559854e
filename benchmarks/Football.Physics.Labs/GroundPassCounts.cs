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
