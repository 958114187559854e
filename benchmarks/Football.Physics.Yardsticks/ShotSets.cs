namespace Football.Physics.Yardsticks;

/// <summary>The seeded shots that every timing and every error is measured with.</summary>
public static class ShotSets
{
    /// <summary>Shots in a set.</summary>
    public const int Count = 64;

    /// <summary>Step of the timed flights, s.</summary>
    public const double TimeStep = 0.01;

    /// <summary>Steps of a timed flight: 1.2 s, over which no fast shot leaves the drag law's branch.</summary>
    public const int Steps = 120;

    /// <summary>Height, m, from which a timed flight does not reach the ground.</summary>
    public const double HighUp = 100;

    /// <summary>Duration of a look-ahead, s.</summary>
    public const double LookAhead = 3.0;

    /// <summary>24 m/s, 20 to 30 rad/s: all on the drag law's branch with spin.</summary>
    public static IReadOnlyList<Shot> Fast { get; } = Make(1, 24, 24, 20, 30);

    /// <summary>12 to 27 m/s, 0 to 25 rad/s: both branches of the drag law, and some shots that change it.</summary>
    public static IReadOnlyList<Shot> Mixed { get; } = Make(2, 12, 27, 0, 25);

    /// <summary>12 to 27 m/s without spin.</summary>
    public static IReadOnlyList<Shot> WithoutSpin { get; } = Make(3, 12, 27, 0, 0);

    /// <summary>18 to 25 m/s along the ground without spin: slides for longer than a timed flight.</summary>
    public static IReadOnlyList<Shot> Sliding { get; } = Make(4, 18, 25, 0, 0, 0, 0);

    /// <summary>4 to 12 m/s along the ground in pure rolling.</summary>
    public static IReadOnlyList<Shot> Rolling { get; } = [.. Make(5, 4, 12, 0, 0, 0, 0).Select(Rolls)];

    /// <summary>Balls 1 to 9 cm above the ground that come down at 10 to 15 m/s: an impact inside the next 10 ms.</summary>
    public static IReadOnlyList<Shot> AboutToBounce { get; } = MakeBounces(6);

    /// <summary>Uniform speed, spin about a uniformly random axis, any azimuth, from the ground.</summary>
    /// <param name="seed">Seed of the generator.</param>
    /// <param name="slowest">Least speed, m/s.</param>
    /// <param name="fastest">Greatest speed, m/s.</param>
    /// <param name="leastSpin">Least spin, rad/s.</param>
    /// <param name="mostSpin">Greatest spin, rad/s.</param>
    /// <param name="flattest">Least elevation, degrees.</param>
    /// <param name="steepest">Greatest elevation, degrees.</param>
    /// <param name="count">How many shots.</param>
    public static Shot[] Make(
        int seed, double slowest, double fastest, double leastSpin, double mostSpin, double flattest = 5, double steepest = 35, int count = Count)
    {
        var random = new Random(seed);
        var shots = new Shot[count];
        for (int i = 0; i < count; i++)
        {
            double speed = Between(random, slowest, fastest);
            double elevation = Between(random, flattest, steepest) * (Math.PI / 180.0);
            double azimuth = Between(random, 0, 2.0 * Math.PI);
            double spin = Between(random, leastSpin, mostSpin);
            double up = Between(random, -1, 1);
            double around = Between(random, 0, 2.0 * Math.PI);
            double across = Math.Sqrt(1.0 - (up * up));
            shots[i] = new Shot(
                new Vector3d(0, BallProperties.Football.Radius, 0),
                speed * new Vector3d(Math.Cos(elevation) * Math.Sin(azimuth), Math.Sin(elevation), -Math.Cos(elevation) * Math.Cos(azimuth)),
                spin * new Vector3d(across * Math.Cos(around), up, across * Math.Sin(around)));
        }

        return shots;
    }

    private static Shot[] MakeBounces(int seed)
    {
        var random = new Random(seed);
        Shot[] shots = Make(seed, 10, 25, 0, 25, 0, 0);
        for (int i = 0; i < shots.Length; i++)
        {
            Shot shot = shots[i].From(BallProperties.Football.Radius + Between(random, 0.01, 0.09));
            shots[i] = shot with { Velocity = shot.Velocity + new Vector3d(0, -Between(random, 10, 15), 0) };
        }

        return shots;
    }

    // ω_h = ŷ × v / r
    private static Shot Rolls(Shot shot) =>
        shot with { Spin = new Vector3d(shot.Velocity.Z, 0, -shot.Velocity.X) / BallProperties.Football.Radius };

    private static double Between(Random random, double low, double high) => low + ((high - low) * random.NextDouble());
}
