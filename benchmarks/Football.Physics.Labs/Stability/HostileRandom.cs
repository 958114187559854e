using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Stability;

/// <summary>The random numbers of the hostile scenes. The scenes depend on their order and their bits, so neither may change.</summary>
internal sealed class HostileRandom(ulong seed) : SeededRandom(Start(seed))
{
    public override double Log(double low, double high) => Math.Exp(Uniform(Math.Log(low), Math.Log(high)));

    public override int Below(int count) => (int)(Bits() % (ulong)count);

    public override Vector3d Direction()
    {
        while (true)
        {
            var v = new Vector3d(Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1));
            double length = Math.Sqrt((v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z));
            if (length is > 1e-3 and <= 1)
            {
                return new Vector3d(v.X / length, v.Y / length, v.Z / length);
            }
        }
    }

    private static ulong Start(ulong seed)
    {
        unchecked
        {
            ulong z = seed + 0x632BE59BD9B4E019UL;
            z = (z ^ (z >> 33)) * 0xFF51AFD7ED558CCDUL;
            z = (z ^ (z >> 33)) * 0xC4CEB9FE1A85EC53UL;
            z ^= z >> 33;
            return (Mixed(z + Step) ^ (z << 1)) + Step;
        }
    }
}
