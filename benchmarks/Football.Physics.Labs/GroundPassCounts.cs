namespace FootballPhysics.Labs;

/// <summary>How many passes along the ground that were rolled are found again: at their time, and no faster than they were.</summary>
internal sealed class GroundPassCounts
{
    private const int PerScene = 10;

    private readonly Lock _lock = new();
    private readonly List<string> _examples = [];

    public int Passes { get; private set; }

    public int Missed { get; private set; }

    public int TimedMissed { get; private set; }

    public int SlowestMissed { get; private set; }

    /// <summary>Answers that are called a hit and miss when they are played.</summary>
    public int FalseHits { get; private set; }

    /// <summary>The first few that were not found.</summary>
    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal);

    /// <summary>Asks for passes, on all processors.</summary>
    /// <param name="seed">Seed of the passes.</param>
    /// <param name="count">How many.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">With how many of the balls.</param>
    public static GroundPassCounts Of(int seed, int count, double wind, int balls)
    {
        var counts = new GroundPassCounts();
        Parallel.For(0, (count + PerScene - 1) / PerScene, index => counts.Run(seed, index, Math.Min(PerScene, count - (index * PerScene)), wind, balls));
        return counts;
    }

    private void Run(int seed, int index, int count, double wind, int balls)
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
            AimResult timed = aimer.FindAtTime(request with { Speed = AimSets.Between(random, 1, 1.3) * request.Speed }, time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = 30, MaximumElevationDegrees = 45 });
            lock (_lock)
            {
                Passes++;
                Missed += Note(found.Status == AimStatus.Hit, "pass", index, request, time, in found);
                TimedMissed += Note(timed.Status == AimStatus.Hit, "timed", index, request, time, in timed);
                SlowestMissed += Note(slowest.Status == AimStatus.Hit && slowest.Speed <= 1.001 * request.Speed, "slowest", index, request, time, in slowest);
                foreach (AimResult result in (AimResult[])[found, slowest])
                {
                    bool isFalse = result.HitsTarget && truth.Of(request, result.Velocity, result.Spin) > TrueMiss.Rounding * request.Tolerance;
                    FalseHits += Note(!isFalse, "false hit", index, request, time, in result);
                }
            }
        }
    }

    /// <summary>A pass, and a point that it rolls over at a time.</summary>
    private static (AimRequest Request, double Time) Draw(Random random, Simulator simulator, Trajectory path)
    {
        while (true)
        {
            double azimuth = AimSets.Between(random, 0, 2 * Math.PI);
            double speed = AimSets.Between(random, 3, 28);
            double top = random.Next(2) == 0 ? 0 : AimSets.Between(random, -30, 30);
            double side = random.Next(2) == 0 ? 0 : AimSets.Between(random, -30, 30);
            Vector3d direction = new(Math.Cos(azimuth), 0, Math.Sin(azimuth));
            BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), speed * direction, KickVectors.Spin(direction, top, side));
            simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 0.01, Duration = 10, StopAt = StopAt.Impact }, path);
            double time = AimSets.Between(random, 0.1, 0.9) * path.EndTime;
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

    private int Note(bool found, string question, int index, AimRequest request, double time, in AimResult result)
    {
        if (!found)
        {
            _examples.Add(FormattableString.Invariant(
                $"ground, {question} {index}: {result.Status}, {result.Speed:0.000} m/s, miss {result.Miss:0.000000} m; at {time} s; {request}"));
        }

        return found ? 0 : 1;
    }
}
