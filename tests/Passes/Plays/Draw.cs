namespace FootballPhysics.Passes.Plays;

/// <summary>Random numbers of a seed.</summary>
internal sealed class Draw(int seed)
{
    private readonly Random _random = new(seed);

    public double Between(double low, double high) => low + ((high - low) * _random.NextDouble());

    public int Below(int count) => _random.Next(count);

    public bool Chance(double share) => _random.NextDouble() < share;

    public T Any<T>(params T[] items) => items[_random.Next(items.Length)];

    /// <summary>A vector with components in ± <paramref name="most"/>.</summary>
    public Vector3d Vector(double most) => new(Between(-most, most), Between(-most, most), Between(-most, most));

    /// <summary>A horizontal vector of length 1.</summary>
    public Vector3d Heading()
    {
        double angle = Between(0, Math.Tau);
        return new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
    }

    /// <summary>A kick between a tap and a shot, with or without spin.</summary>
    public (Vector3d Velocity, Vector3d Spin) Kick() =>
        ((Between(0.3, 30) * Heading()) + new Vector3d(0, Chance(0.5) ? Between(0, 12) : 0, 0), Chance(0.5) ? default : Vector(Chance(0.5) ? 10 : 80));
}
