namespace FootballPhysics.Benchmarks;

/// <summary>Balls that lie on each other or in a row.</summary>
/// <param name="Group">The group.</param>
/// <param name="States">The balls.</param>
/// <param name="Half">The distance of the walls from the middle, m; infinite without walls.</param>
internal sealed record Heap(BallGroup Group, BallState[] States, double Half)
{
    /// <summary>The length of a step, s.</summary>
    public const double Frame = 1.0 / 60;

    /// <summary>The radius of the balls, m.</summary>
    public const double Radius = 0.11;

    /// <summary>Returns layers of balls above a box, with small offsets.</summary>
    public static Heap InBox(Integrator integrator, int balls, double half)
    {
        Obstacle[] walls =
        [
            .. new[] { new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0), new Vector3d(0, 0, 1), new Vector3d(0, 0, -1) }
                .Select(normal => new Obstacle { Name = "wall", Shape = new PlaneShape(-half * normal, normal), Surface = SurfaceMaterial.Board }),
        ];
        var group = new BallGroup(new Simulator(new Scene { Obstacles = walls }, new SolverSettings { Integrator = integrator }), balls);
        var random = new SeededRandom(60L);
        int side = Math.Max(1, (int)((2 * half) / 0.27));
        double gap = 2 * half / side;
        return new Heap(
            group,
            [
                .. Enumerable.Range(0, balls).Select(i =>
                {
                    int layer = i / (side * side);
                    int inLayer = i % (side * side);
                    var place = new Vector3d(
                        (((inLayer % side) + 0.5) * gap) - half + random.Uniform(-0.015, 0.015),
                        0.4 + (0.3 * layer),
                        (((inLayer / side) + 0.5) * gap) - half + random.Uniform(-0.015, 0.015));
                    return group.SimulatorOf(i).Launch(place, Vector3d.Zero, Vector3d.Zero);
                }),
            ],
            half);
    }

    /// <summary>Returns balls that touch each other and roll in a row, the heavier behind: air and rolling friction slow the lighter ones more.</summary>
    public static Heap InRow(Integrator integrator, int balls)
    {
        var scene = new Scene();
        BallProperties[] kinds = [.. Enumerable.Range(0, balls).Select(i => scene.Ball with { Radius = Radius, Mass = 0.3 + (0.1 * i) })];
        var group = new BallGroup(scene, kinds, new SolverSettings { Integrator = integrator });
        return new Heap(
            group,
            [
                .. Enumerable.Range(0, balls).Select(
                    i => group.SimulatorOf(i).Launch(new Vector3d(-2 * Radius * i, Radius, 0), new Vector3d(3, 0, 0), new Vector3d(0, 0, -3 / Radius))),
            ],
            double.PositiveInfinity);
    }
}
