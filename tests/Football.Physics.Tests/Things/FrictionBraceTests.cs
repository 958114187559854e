using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The change along a line that brings the forces of two contacts into their friction cones, against all changes on a grid.</summary>
public sealed unsafe class FrictionBraceTests
{
    private const int Grid = 2000;
    private const double Most = 40;

    [Fact]
    public void The_change_is_the_least_that_fits_both_cones()
    {
        var random = new Random(31);
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        int moved = 0;
        int inVain = 0;
        double[] x = new double[6];
        double[] z = new double[6];
        double[] sliding = new double[2];
        for (int draw = 0; draw < 1000; draw++)
        {
            for (int i = 0; i < 6; i++)
            {
                x[i] = i % 3 == 0 ? Any(0.1, draw % 2 == 0 ? 1 : 8) : Any(-3, 3) / (1 + (draw % 3));
                z[i] = i % 3 == 0 ? Any(-0.5, 1) : Any(-0.7, 0.7);
                sliding[i / 3] = Any(0.1, 1.5);
            }

            double share;
            fixed (double* first = x, change = z)
            {
                share = FrictionBrace.Share(first, change, sliding[0], first + 3, change + 3, sliding[1]);
            }

            if (Fits(0))
            {
                Assert.Equal(0, share);
                continue;
            }

            // The nearest change on the grid that fits, and a bisection to the border.
            double inside = double.PositiveInfinity;
            for (int i = 0; i <= Grid; i++)
            {
                double at = Most * ((2.0 * i / Grid) - 1);
                inside = Math.Abs(at) < Math.Abs(inside) && Fits(at) ? at : inside;
            }

            if (double.IsInfinity(inside))
            {
                // Between two points of the grid there may be a narrow range. A change beyond which a contact would pull opens it later.
                bool pulls = x[0] + (share * z[0]) < 0 || x[3] + (share * z[3]) < 0;
                Assert.True(share == 0 || Fits(share * (1 + 1e-9)) || pulls || Math.Abs(share) > Most, $"draw {draw}: {share}");
                inVain += share == 0 ? 1 : 0;
                continue;
            }

            double outside = 0;
            for (int i = 0; i < 60; i++)
            {
                double middle = 0.5 * (inside + outside);
                (inside, outside) = Fits(middle) ? (middle, outside) : (inside, middle);
            }

            Assert.True(Math.Abs(share - inside) <= 1e-5 * (1 + Math.Abs(inside)), $"draw {draw}: {share} instead of {inside}");
            moved++;
        }

        Assert.True(moved > 100 && inVain > 100, $"{moved} moved, {inVain} in vain");

        bool Fits(double change) => IsWithin(0, change) && IsWithin(1, change);

        bool IsWithin(int contact, double change)
        {
            int i = 3 * contact;
            double load = x[i] + (change * z[i]);
            return load >= 0 && Math.Sqrt(Math.Pow(x[i + 1] + (change * z[i + 1]), 2) + Math.Pow(x[i + 2] + (change * z[i + 2]), 2)) <= sliding[contact] * load * (1 + 1e-12);
        }
    }
}
