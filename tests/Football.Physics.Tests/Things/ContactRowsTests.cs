using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The linear systems of contacts against a second solution: Gram–Schmidt's method, which shares nothing with elimination.</summary>
public sealed unsafe class ContactRowsTests
{
    [Fact]
    public void A_system_with_one_solution_is_solved()
    {
        var random = new Random(71);
        for (int i = 0; i < 300; i++)
        {
            int size = 1 + (i % 9);
            double[] g = Shuffled(random, Matrix(random, size, size), size);
            double[] x = Vector(random, size);
            double[] b = Times(g, x);
            double[] before = [.. g];
            Assert.True(Solve(g, b));
            Assert.Equal(before, g);
            Assert.InRange(Distance(b, x), 0, 1e-6);
        }
    }

    /// <summary>G = A B with fewer columns of A than unknowns: the least x has no part that G maps to zero.</summary>
    [Fact]
    public void A_system_with_many_solutions_gives_the_least_one()
    {
        var random = new Random(72);
        for (int i = 0; i < 300; i++)
        {
            int size = 2 + (i % 8);
            int rank = 1 + (i % (size - 1));
            double[] rows = Matrix(random, rank, size);
            double[] g = Product(Matrix(random, size, rank), rows, size, rank);
            double scale = Math.Pow(10, random.Next(-3, 4));
            g = [.. g.Select(at => scale * at)];

            // x is a combination of the rows, so it is the least of all solutions of G x = b.
            double[] x = new double[size];
            double[] shares = Vector(random, rank);
            for (int row = 0; row < rank; row++)
            {
                for (int k = 0; k < size; k++)
                {
                    x[k] += shares[row] * rows[(row * size) + k];
                }
            }

            double[] b = Times(g, x);
            Assert.False(Solve(g, b));
            Assert.InRange(Distance(Times(g, b), Times(g, x)), 0, 1e-5 * scale * size);
            double[] off = [.. b.Zip(x, (at, exact) => at - exact)];
            Assert.InRange(Distance(Beyond(off, rows, rank), new double[size]), 0, 1e-9);
        }
    }

    [Fact]
    public void A_braced_system_gives_the_least_solution_and_the_force_without_effect()
    {
        var random = new Random(73);
        for (int i = 0; i < 200; i++)
        {
            int size = 2 + (i % 8);

            // G has one vector y with yᵀ G = 0 and one z with G z = 0.
            double[] y = Unit(random, size);
            double[] z = Unit(random, size);
            double[] g = Matrix(random, size, size);
            g = Without(g, y, size, isLeft: true);
            g = Without(g, z, size, isLeft: false);
            double[] exact = [.. Vector(random, size)];
            double along = exact.Zip(z, (a, b) => a * b).Sum();
            exact = [.. exact.Zip(z, (a, b) => a - (along * b))];
            double[] b = Times(g, exact);
            double[] to = [.. y];
            fixed (double* matrix = (double[])[.. g], right = b, force = to)
            {
                Assert.True(ContactRows.SolveBraced(matrix, right, force, size));
            }

            double length = Math.Sqrt(to.Sum(at => at * at));
            double same = to.Zip(z, (a, c) => a * c).Sum() / length;
            Assert.Equal(1, Math.Abs(same), 1e-6);
            Assert.InRange(Distance(b, exact), 0, 1e-4);
        }
    }

    private static bool Solve(double[] g, double[] b)
    {
        fixed (double* matrix = g, right = b)
        {
            return ContactRows.Solve(matrix, right, b.Length);
        }
    }

    private static double[] Vector(Random random, int size) => [.. Enumerable.Range(0, size).Select(_ => (2 * random.NextDouble()) - 1)];

    private static double[] Matrix(Random random, int rows, int columns)
    {
        // Strong diagonals keep the condition of the matrix small.
        double[] all = Vector(random, rows * columns);
        for (int i = 0; i < Math.Min(rows, columns); i++)
        {
            all[(i * columns) + i] += 3;
        }

        return all;
    }

    /// <summary>The rows in another order, with zeros, so that the first entry of a column may be zero.</summary>
    private static double[] Shuffled(Random random, double[] g, int size)
    {
        int[] order = [.. Enumerable.Range(0, size)];
        random.Shuffle(order);
        return [.. order.SelectMany(row => Enumerable.Range(0, size).Select(k => row == k || random.Next(3) > 0 ? g[(row * size) + k] : 0))];
    }

    private static double[] Unit(Random random, int size)
    {
        double[] v = Vector(random, size);
        double length = Math.Sqrt(v.Sum(at => at * at));
        return [.. v.Select(at => at / length)];
    }

    private static double[] Product(double[] a, double[] b, int size, int inner)
    {
        var product = new double[size * size];
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < size; j++)
            {
                for (int k = 0; k < inner; k++)
                {
                    product[(i * size) + j] += a[(i * inner) + k] * b[(k * size) + j];
                }
            }
        }

        return product;
    }

    private static double[] Times(double[] g, double[] x) => [.. x.Select((_, i) => x.Select((at, k) => g[(i * x.Length) + k] * at).Sum())];

    private static double Distance(double[] a, double[] b) => Math.Sqrt(a.Zip(b, (x, y) => (x - y) * (x - y)).Sum());

    /// <summary>The matrix without its part along a unit vector, on one side.</summary>
    private static double[] Without(double[] g, double[] unit, int size, bool isLeft)
    {
        var left = new double[size * size];
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < size; j++)
            {
                double part = Enumerable.Range(0, size).Sum(k => isLeft ? unit[i] * unit[k] * g[(k * size) + j] : g[(i * size) + k] * unit[k] * unit[j]);
                left[(i * size) + j] = g[(i * size) + j] - part;
            }
        }

        return left;
    }

    /// <summary>The part of a vector that is perpendicular to all rows, by Gram–Schmidt's method.</summary>
    private static double[] Beyond(double[] v, double[] rows, int rank)
    {
        int size = v.Length;
        var axes = new List<double[]>();
        for (int row = 0; row < rank; row++)
        {
            double[] axis = rows[(row * size)..((row + 1) * size)];
            axis = Perpendicular(Perpendicular(axis));
            double length = Math.Sqrt(axis.Sum(at => at * at));
            axes.Add([.. axis.Select(at => at / length)]);
        }

        return Perpendicular(Perpendicular(v));

        double[] Perpendicular(double[] of)
        {
            foreach (double[] axis in axes)
            {
                double along = of.Zip(axis, (a, b) => a * b).Sum();
                of = [.. of.Zip(axis, (a, b) => a - (along * b))];
            }

            return of;
        }
    }
}
