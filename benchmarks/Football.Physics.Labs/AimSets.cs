namespace FootballPhysics.Labs;

/// <summary>The seeded requests of the thesis' experiments with predictors, and of the table of targets. Kicks go along x; the goal line is at x = 0.</summary>
internal static class AimSets
{
    private const double Radius = 0.11;

    /// <summary>Scene of the studio's comparison: constant coefficients.</summary>
    public static Scene StudioScene { get; } = Scene.Published with { Forces = ForceSet.Constant };

    /// <summary>Integrator of the studio's comparison.</summary>
    public static SolverSettings StudioSettings { get; } = new() { Integrator = Integrator.SemiImplicitEuler };

    /// <summary>Step of the studio's comparison, s.</summary>
    public static double StudioStep => 1.0 / 60.0;

    /// <summary>4.1.3: 25 m/s, spin (20, 10), 15 to 25 m before a point in the goal, at most 30°, within 1 cm.</summary>
    public static AimRequest[] Thesis(int seed, int count)
    {
        var random = new Random(seed);
        return Make(count, () => Before(random, InGoal(random), random.Between(15, 25)) with { Speed = 25, TopSpin = 20, SideSpin = 10, MaximumElevationDegrees = 30 });
    }

    /// <summary>4.1.3, limits: the same kick from increasing distances, at most 45°.</summary>
    public static AimRequest[] Farther(double nearest, double farthest, int count) => [.. Enumerable.Range(0, count).Select(i => new AimRequest
    {
        From = new Vector3d(-(nearest + ((farthest - nearest) * i / (count - 1))), Radius, 0),
        Target = new Vector3d(0, 1, 0),
        Speed = 25,
        TopSpin = 20,
        SideSpin = 10,
        MaximumElevationDegrees = 45,
    })];

    /// <summary>4.1.3, the studio's comparison: 20 to 30 m/s, spins within ±20, points in the goal. The thesis does not state the distance; here it is 14 to 20 m.</summary>
    public static AimRequest[] Studio(int seed, int count)
    {
        var random = new Random(seed);
        return Make(count, () => Before(random, InGoal(random), random.Between(14, 20)) with
        {
            Speed = random.Between(20, 30),
            TopSpin = random.Between(-20, 20),
            SideSpin = random.Between(-20, 20),
            MaximumElevationDegrees = 30,
        });
    }

    /// <summary>4.3.2, first: around the left of a wall into the top left corner, from 25 m, 20 to 40 m/s.</summary>
    public static AimRequest[] AroundTheWall(int count) => FreeKick(new Vector3d(-15.85, 1.9, -2), new Vector3d(0, 2.2, -3.3), count);

    /// <summary>4.3.2, second: just over the middle of a wall into the bottom left corner, from 25 m, 20 to 40 m/s.</summary>
    public static AimRequest[] OverTheWall(int count) => FreeKick(new Vector3d(-15.85, 2.2, -0.9), new Vector3d(0, 0.4, -3.3), count);

    /// <summary>Two points of a random kick with spins well within their limits: 20 to 32 m/s, 18 to 35 m.</summary>
    public static AimRequest[] TwoPoint(int seed, int count)
    {
        var random = new Random(seed);
        var simulator = new Simulator(Scene.Published);
        var path = new Trajectory();
        return Make(count, () => Along(random, simulator, path));
    }

    /// <summary>Targets that are 4 to 15 % too far for the kick's speed, 12 to 45 m away.</summary>
    public static AimRequest[] TooFar(int seed, int count)
    {
        var random = new Random(seed);
        var aimer = new Aimer(Scene.Published);
        return Make(count, () =>
        {
            AimRequest request = Before(random, InGoal(random), random.Between(12, 45)) with
            {
                Speed = 60,
                TopSpin = random.Between(-20, 20),
                SideSpin = random.Between(-20, 20),
            };
            return request with { Speed = aimer.FindSlowest(request).Velocity.Length / random.Between(1.04, 1.15) };
        });
    }

    private static AimRequest[] Make(int count, Func<AimRequest> next) => [.. Enumerable.Range(0, count).Select(_ => next())];

    private static Vector3d InGoal(Random random) => new(0, random.Between(0.2, 2.2), random.Between(-3.3, 3.3));

    private static AimRequest Before(Random random, Vector3d target, double distance)
    {
        (double sin, double cos) = Math.SinCos(random.Between(-0.7, 0.7));
        return new AimRequest { From = new Vector3d(target.X - (distance * cos), Radius, target.Z + (distance * sin)), Target = target };
    }

    private static AimRequest[] FreeKick(Vector3d through, Vector3d target, int count) => [.. Enumerable.Range(0, count).Select(i => new AimRequest
    {
        From = new Vector3d(-25, Radius, 0),
        Waypoint = through,
        Target = target,
        Speed = 20 + (20.0 * i / (count - 1)),
    })];

    private static AimRequest Along(Random random, Simulator simulator, Trajectory path)
    {
        while (true)
        {
            double speed = random.Between(20, 32);
            (double up, double along) = Math.SinCos(random.Between(8, 22) * Math.PI / 180);
            var velocity = new Vector3d(speed * along, speed * up, 0);
            Vector3d spin = KickVectors.Spin(velocity, random.Between(-30, 30), random.Between(-30, 30));
            simulator.LookAhead(simulator.Launch(new Vector3d(0, Radius, 0), velocity, spin), new LookAheadRequest { TimeStep = 0.01, StopAt = StopAt.Impact }, path);
            double distance = random.Between(18, 35);
            double way = distance * random.Between(0.35, 0.65);
            if (path.TryGetCrossing(new Plane3d(new Vector3d(distance, 0, 0), new Vector3d(1, 0, 0)), out PathPoint target)
                && path.TryGetCrossing(new Plane3d(new Vector3d(way, 0, 0), new Vector3d(1, 0, 0)), out PathPoint through)
                && target.Position.Y > 0.2)
            {
                return new AimRequest { From = new Vector3d(0, Radius, 0), Waypoint = through.Position, Target = target.Position, Speed = speed };
            }
        }
    }
}
