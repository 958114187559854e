using FootballPhysics.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Numerics;

public sealed class LinearTests
{
    [Fact]
    public void A_solution_solves_its_system()
    {
        var random = new Shots(6);
        for (int n = 1; n <= 5; n++)
        {
            for (int run = 0; run < 50; run++)
            {
                double[] system = [.. Enumerable.Range(0, n * (n + 1)).Select(_ => random.Uniform(-1, 1))];
                double[] copy = [.. system];
                var x = new double[n];
                Assert.True(Linear.Solve(copy, x, n));
                for (int row = 0; row < n; row++)
                {
                    double left = Enumerable.Range(0, n).Sum(column => system[(row * (n + 1)) + column] * x[column]);
                    Assert.Equal(system[(row * (n + 1)) + n], left, 1e-12 * (1 + x.Max(Math.Abs)));
                }
            }
        }
    }

    [Fact]
    public void A_zero_on_the_diagonal_is_no_obstacle_but_a_singular_system_is()
    {
        var x = new double[2];
        Assert.True(Linear.Solve([0, 1, 3, 2, 0, 4], x, 2));
        Assert.Equal([2, 3], x);
        Assert.False(Linear.Solve([1, 2, 3, 1, 2, 4], x, 2));
    }
}
