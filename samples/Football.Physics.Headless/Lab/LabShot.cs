namespace Football.Physics.Headless.Lab;

/// <summary>A kick of an experiment, from the ground of the default scene.</summary>
internal readonly record struct LabShot(Vector3d Velocity, Vector3d Spin)
{
    /// <summary>Where every kick is made.</summary>
    public static Vector3d From { get; } = new(0, BallProperties.Football.Radius, 0);

    /// <summary>Uniform speed, elevation 5 to 35°, any azimuth, spin of a uniform size about a uniformly random axis.</summary>
    public static LabShot[] Make(long seed, int count, double slow, double fast, double leastSpin, double mostSpin)
    {
        var random = new LabRandom(LabRandom.Mix(seed, (long)(1000 * slow)));
        return [.. Enumerable.Range(0, count).Select(_ => new LabShot(random.Velocity(slow, fast, 5, 35), random.Uniform(leastSpin, mostSpin) * random.Direction()))];
    }

    /// <summary>The shots of the consistency test: 15 to 35 m/s, 2 to 60 rad/s.</summary>
    public static LabShot[] Usual(long seed, int count) => Make(seed, count, 15, 35, 2, 60);

    /// <summary>The slow set, where most shots cross the drag law's jump: 12.5 to 22 m/s, 5 to 25 rad/s.</summary>
    public static LabShot[] Slow(long seed, int count) => Make(seed, count, 12.5, 22, 5, 25);
}
