using Football.Physics.Yardsticks;

namespace Football.Physics.Benchmarks;

/// <summary>The rows of kicks after bounces and off things, to 1 mm: to where random kicks came that had met just these.</summary>
internal static class BankShotRows
{
    private const int Count = 16;

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = Surface.Board }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = Surface.MeasuredFrame, HasNet = false }],
    };

    public static IReadOnlyList<TargetRow> All { get; } =
    [
        Row("over a bounce", -12, 12, "ground"),
        Row("off a wall", 20, 70, "wall"),
        Row("off a wall, and a bounce", 20, 70, "wall", "ground"),
        Row("off a post", 13, 18, "right post"),
        Row("off the bar, and a bounce", -12, 12, "crossbar", "ground"),
    ];

    private static TargetRow Row(string name, double least, double most, params string[] after)
    {
        var results = new Lazy<AimResult[]>(() => [.. Draw(least, most, after).Select(request => new BankShotAimer(Scene).Find(request, after))]);
        return new TargetRow($"aim {name}, to 1 mm, of a 3 s look-ahead of 80 ms", () => Aims(Draw(least, most, after), after), QueryRows.LookAhead)
        {
            Error = () => results.Value.Average(found => found.Miss),
            Note = () => FormattableString.Invariant(
                $"{results.Value.Count(found => found.Status == AimStatus.Hit)} of {Count} hit, {results.Value.Average(found => (double)found.Simulations):0.0} simulations, at most {results.Value.Max(found => found.Simulations)}"),
        };
    }

    private static Workload Aims(AimRequest[] requests, string[] after)
    {
        var aimer = new BankShotAimer(Scene);
        return new Workload(
            () =>
            {
                double sum = 0;
                foreach (AimRequest request in requests)
                {
                    sum += aimer.Find(request, after).Miss;
                }

                return sum;
            },
            Count);
    }

    /// <summary>Requests that have an answer: for a place between what a random kick meets last and what comes next.</summary>
    private static AimRequest[] Draw(double least, double most, string[] after)
    {
        var random = new SeededRandom(17L);
        var simulator = new Simulator(Scene);
        var path = new Trajectory(1024);
        var requests = new List<AimRequest>();
        while (requests.Count < Count)
        {
            double azimuth = random.Uniform(least, most) * Math.PI / 180;
            double elevation = random.Uniform(4, 32) * Math.PI / 180;
            var velocity = random.Uniform(15, 26) * new Vector3d(-Math.Sin(azimuth) * Math.Cos(elevation), Math.Sin(elevation), -Math.Cos(azimuth) * Math.Cos(elevation));
            (double top, double side) = (random.Uniform(-20, 20), random.Uniform(-20, 20));
            BallState kick = simulator.Launch(Shot.Spot, velocity, KickSpin.Vector(velocity, top, side));
            simulator.LookAhead(in kick, new LookAheadRequest { Duration = 5, TimeStep = 0.01, StopAt = StopAt.Time }, path);
            BallEvent[] impacts = [.. path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
            if (impacts.Length > after.Length && impacts.Take(after.Length).Select(e => simulator.NameOf(e.Thing)).SequenceEqual(after))
            {
                double begin = impacts[after.Length - 1].Time;
                Vector3d target = path.PositionAt(begin + (random.Uniform(0.2, 0.9) * (impacts[after.Length].Time - begin)));
                requests.Add(new AimRequest { From = Shot.Spot, Target = target, Speed = velocity.Length, TopSpin = top, SideSpin = side, Tolerance = 0.001 });
            }
        }

        return [.. requests];
    }
}
