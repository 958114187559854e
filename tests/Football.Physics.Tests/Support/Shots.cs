using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Support;

/// <summary>Random shots, the same in every run: drawn from the numbers that these tests have always had.</summary>
internal sealed class Shots(int seed) : SeededRandom(seed)
{
    private readonly Random _numbers = new(seed);

    public override double Next() => _numbers.NextDouble();
}
