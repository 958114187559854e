namespace Football.Physics.Tests.Support;

/// <summary>Random shots, the same in every run.</summary>
internal sealed class Shots
{
    private readonly Random _random;

    public Shots(int seed) => _random = new Random(seed);

    public double Uniform(double low, double high) => low + ((high - low) * _random.NextDouble());

    /// <summary>A direction, every one as likely as any other.</summary>
    public Vector3d Direction()
    {
        double y = Uniform(-1, 1);
        double angle = Uniform(0, 2 * Math.PI);
        double flat = Math.Sqrt(1 - (y * y));
        return new Vector3d(flat * Math.Cos(angle), y, flat * Math.Sin(angle));
    }

    /// <summary>A velocity of the consistency test: any azimuth, an elevation in degrees.</summary>
    public Vector3d Velocity(double slow, double fast, double low, double high)
    {
        double speed = Uniform(slow, fast);
        double elevation = Uniform(low, high) * Math.PI / 180;
        double azimuth = Uniform(0, 2 * Math.PI);
        return speed * new Vector3d(Math.Cos(elevation) * Math.Cos(azimuth), Math.Sin(elevation), Math.Cos(elevation) * Math.Sin(azimuth));
    }
}
