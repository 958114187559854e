namespace FootballPhysics.Benchmarks;

/// <summary>The rows of kicks after bounces and off objects, to 1 mm. The targets are points that random kicks reached after just these contacts.</summary>
internal static class BankShotRows
{
    private const int Count = 16;

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.Board }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = SurfaceMaterial.GoalFrame, HasNet = false }],
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

    private static AimRequest[] Draw(double least, double most, string[] after)
    {
        var random = new SeededRandom(17L);
        var set = new BankShotSet(new Simulator(Scene), after) { Azimuth = (least, most), Elevation = (4, 32) };
        return [.. Enumerable.Range(0, Count).Select(_ => set.Draw(random))];
    }
}
