namespace FootballPhysics.Labs.Hostile;

/// <summary>SplitMix64 from a scrambled seed. The scenes are a function of it: what it draws, and in which order, must not change.</summary>
internal sealed class HostileRandom
{
    private ulong _state;

    public HostileRandom(ulong seed)
    {
        ulong z = seed + 0x632BE59BD9B4E019UL;
        z = (z ^ (z >> 33)) * 0xFF51AFD7ED558CCDUL;
        z = (z ^ (z >> 33)) * 0xC4CEB9FE1A85EC53UL;
        z ^= z >> 33;
        _state = z;
        _state = Next() ^ (z << 1);
        Next();
    }

    public ulong Next()
    {
        _state += 0x9E3779B97F4A7C15UL;
        ulong z = _state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
        return z ^ (z >> 31);
    }

    /// <summary>0 … 1, 1 excluded.</summary>
    public double Share() => (Next() >> 11) * (1.0 / (1UL << 53));

    public double Uniform(double low, double high) => low + ((high - low) * Share());

    /// <summary>Every decade as likely as any other.</summary>
    public double Log(double low, double high) => Math.Exp(Uniform(Math.Log(low), Math.Log(high)));

    /// <summary>0 … count − 1.</summary>
    public int Below(int count) => (int)(Next() % (ulong)count);

    public bool Chance(double share) => Share() < share;

    public T Any<T>(params ReadOnlySpan<T> choices) => choices[Below(choices.Length)];

    /// <summary>A unit vector, every direction as likely as any other.</summary>
    public Vector3d Direction()
    {
        while (true)
        {
            double x = Uniform(-1, 1);
            double y = Uniform(-1, 1);
            double z = Uniform(-1, 1);
            double length = Math.Sqrt((x * x) + (y * y) + (z * z));
            if (length is > 1e-3 and <= 1)
            {
                return new Vector3d(x / length, y / length, z / length);
            }
        }
    }

    /// <summary>A horizontal unit vector.</summary>
    public Vector3d Heading()
    {
        double angle = Uniform(0, 2 * Math.PI);
        return new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
    }
}
