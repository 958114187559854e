namespace FootballPhysics.Yardsticks;

/// <summary>The seeded shots for every timing and every error.</summary>
public static class ShotSets
{
    /// <summary>The number of shots in a set.</summary>
    public const int Count = 64;

    /// <summary>The time step of the timed flights, s.</summary>
    public const double TimeStep = 0.01;

    /// <summary>The number of steps of a timed flight: 1.2 s, over which no fast shot leaves its branch of the drag law.</summary>
    public const int Steps = 120;

    /// <summary>A height, m, from which a timed flight does not reach the ground.</summary>
    public const double HighUp = 100;

    /// <summary>The duration of a look-ahead, s.</summary>
    public const double LookAhead = 3.0;

    /// <summary>24 m/s, 20 to 30 rad/s: all on the drag law's branch with spin.</summary>
    public static IReadOnlyList<Shot> Fast { get; } = Make(1, 24, 24, 20, 30);

    /// <summary>12 to 27 m/s, 0 to 25 rad/s: both branches of the drag law, and some shots that change it.</summary>
    public static IReadOnlyList<Shot> Mixed { get; } = Make(2, 12, 27, 0, 25);

    /// <summary>12 to 27 m/s without spin.</summary>
    public static IReadOnlyList<Shot> WithoutSpin { get; } = Make(3, 12, 27, 0, 0);

    /// <summary>18 to 25 m/s along the ground without spin: these shots slide for longer than a timed flight.</summary>
    public static IReadOnlyList<Shot> Sliding { get; } = Make(4, 18, 25, 0, 0, 0, 0);

    /// <summary>4 to 12 m/s along the ground in pure rolling.</summary>
    public static IReadOnlyList<Shot> Rolling { get; } = [.. Make(5, 4, 12, 0, 0, 0, 0).Select(Rolls)];

    /// <summary>Balls 1 to 9 cm above the ground that come down at 10 to 15 m/s: an impact inside the next 10 ms.</summary>
    public static IReadOnlyList<Shot> AboutToBounce { get; } = MakeBounces(6);

    /// <summary>The shots of the consistency test: 15 to 35 m/s, 2 to 60 rad/s.</summary>
    public static Shot[] Usual(long seed, int count) => Make(seed, 15, 35, 2, 60, count: count);

    /// <summary>The slow set, where most shots cross the drag law's jump: 12.5 to 22 m/s, 5 to 25 rad/s.</summary>
    public static Shot[] Slow(long seed, int count) => Make(seed, 12.5, 22, 5, 25, count: count);

    /// <summary>Draws shots from the ground: uniform speed and elevation, any azimuth, spin of a uniform size about a uniformly random axis.</summary>
    /// <param name="seed">Seed of the generator.</param>
    /// <param name="slowest">Least speed, m/s.</param>
    /// <param name="fastest">Greatest speed, m/s.</param>
    /// <param name="leastSpin">Least spin, rad/s.</param>
    /// <param name="mostSpin">Greatest spin, rad/s.</param>
    /// <param name="flattest">Least elevation, degrees.</param>
    /// <param name="steepest">Greatest elevation, degrees.</param>
    /// <param name="count">The number of shots.</param>
    public static Shot[] Make(
        long seed, double slowest, double fastest, double leastSpin, double mostSpin, double flattest = 5, double steepest = 35, int count = Count)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, (long)(1000 * slowest)));
        var shots = new Shot[count];
        for (int i = 0; i < count; i++)
        {
            Vector3d velocity = random.Velocity(slowest, fastest, flattest, steepest);
            shots[i] = new Shot(Shot.Spot, velocity, random.Uniform(leastSpin, mostSpin) * random.Direction());
        }

        return shots;
    }

    private static Shot[] MakeBounces(long seed)
    {
        var random = new SeededRandom(seed);
        Shot[] shots = Make(seed, 10, 25, 0, 25, 0, 0);
        for (int i = 0; i < shots.Length; i++)
        {
            Shot shot = shots[i].From(BallProperties.Tunnel.Radius + random.Uniform(0.01, 0.09));
            shots[i] = shot with { Velocity = shot.Velocity + new Vector3d(0, -random.Uniform(10, 15), 0) };
        }

        return shots;
    }

    // ω_h = ŷ × v / r
    private static Shot Rolls(Shot shot) =>
        shot with { Spin = new Vector3d(shot.Velocity.Z, 0, -shot.Velocity.X) / BallProperties.Tunnel.Radius };
}
