using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Numbers that often expose errors in programs.</summary>
internal static class FuzzNumbers
{
    private static readonly double[] s_edges =
    [
        0, double.Epsilon, 1e-310, 1e-300, 1e-200, 1e-153, 1e-100, 1e-16, 1e-12, 1e-9, 1e-6, 1e-4, 0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 3, 9.81, 10, 12.19,
        100, 1000, 1e4, 1e6, 1e9, 1e12, 1e15, 1e17, 1e30, 1e35, 1e45, 1e60, 1e75, 1e100, 1e153, 1e200, 1e300, double.MaxValue,
    ];

    /// <summary>Returns one of the numbers, a neighbour of one, or any number.</summary>
    public static double Any(SeededRandom random)
    {
        double number = random.Below(8) switch
        {
            0 => random.Log(1e-12, 1e12),
            1 => random.Uniform(-3, 3),
            2 => Math.BitDecrement(random.Any<double>(s_edges)),
            3 => Math.BitIncrement(random.Any<double>(s_edges)),
            _ => random.Any<double>(s_edges),
        };
        number = Math.Min(number, double.MaxValue);
        return random.Chance(0.3) ? -number : number;
    }

    /// <summary>Returns such a number, or a number with random bits.</summary>
    public static double AnyBits(SeededRandom random) => random.Chance(0.2)
        ? random.Any(double.NaN, double.PositiveInfinity, double.NegativeInfinity, BitConverter.UInt64BitsToDouble(SeededRandom.Mix(random.Below(int.MaxValue), 3)))
        : Any(random);
}
