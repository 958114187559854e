namespace FootballPhysics.Yardsticks;

/// <summary>Seeded random numbers: the same in every run and on every machine, except for the last bit of logarithms.</summary>
public class SeededRandom(ulong seed)
{
    /// <summary>The increment of the state per draw.</summary>
    protected const ulong Step = 0x9E3779B97F4A7C15UL;

    private ulong _state = seed;

    /// <summary>Creates a sequence from a small seed.</summary>
    public SeededRandom(long seed)
        : this(Mix(seed, 0))
    {
    }

    /// <summary>Returns a seed from two numbers.</summary>
    public static ulong Mix(long seed, long index) => unchecked(((ulong)seed * 0x9E3779B97F4A7C15UL) ^ ((ulong)index * 0xD1B54A32D192ED03UL));

    /// <summary>Returns a number in 0 … 1, 1 excluded.</summary>
    public virtual double Next() => (Bits() >> 11) * (1.0 / (1UL << 53));

    public double Uniform(double low, double high) => low + ((high - low) * Next());

    /// <summary>Returns a number that is uniform in the logarithm.</summary>
    public virtual double Log(double low, double high) => low * Math.Pow(high / low, Next());

    public bool Chance(double share) => Next() < share;

    public virtual int Below(int count) => (int)(Next() * count);

    public T Any<T>(params ReadOnlySpan<T> values) => values[Below(values.Length)];

    /// <summary>Returns a direction, uniform over the sphere.</summary>
    public virtual Vector3d Direction()
    {
        double y = Uniform(-1, 1);
        double angle = Uniform(0, 2 * Math.PI);
        double flat = Math.Sqrt(1 - (y * y));
        return new Vector3d(flat * Math.Cos(angle), y, flat * Math.Sin(angle));
    }

    /// <summary>Returns a direction along the ground.</summary>
    public Vector3d Heading()
    {
        double angle = Uniform(0, 2 * Math.PI);
        return new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
    }

    /// <summary>Returns a velocity from the ground: any azimuth, an elevation in degrees.</summary>
    public Vector3d Velocity(double slow, double fast, double low, double high)
    {
        double speed = Uniform(slow, fast);
        double elevation = Uniform(low, high) * Math.PI / 180;
        return speed * ((Math.Cos(elevation) * Heading()) + new Vector3d(0, Math.Sin(elevation), 0));
    }

    /// <summary>Returns the next 64 bits of SplitMix64.</summary>
    protected ulong Bits()
    {
        unchecked
        {
            _state += Step;
        }

        return Mixed(_state);
    }

    /// <summary>Returns the bits of a state.</summary>
    protected static ulong Mixed(ulong z)
    {
        unchecked
        {
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
        }

        return z ^ (z >> 31);
    }
}
