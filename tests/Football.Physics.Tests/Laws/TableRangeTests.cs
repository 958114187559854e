namespace FootballPhysics.Tests.Laws;

/// <summary>When a step keeps to the tables of the laws: against the worst that gravity, drag and lift can do within it.</summary>
public sealed class TableRangeTests
{
    private const double Slowest = 1.5;
    private const double Fastest = 100;
    private static readonly RateBound s_forces = new(0.02, 0.01, 0);

    [Theory]
    [InlineData(9.81)]
    [InlineData(0.5)]
    [InlineData(60)]
    public void A_step_holds_where_its_forces_and_its_fall_are_small(double gravity)
    {
        var scene = new Scene { Gravity = gravity, Forces = ForceSet.Measured with { Buoyancy = false } };
        const double FastestSpin = 300;
        var range = new TableRange(scene, in s_forces, FastestSpin, Slowest, Fastest);
        var random = new Random(5);
        int held = 0;
        int refused = 0;
        for (int i = 0; i < 50_000; i++)
        {
            double speed = 0.5 * Math.Exp(random.NextDouble() * Math.Log(300));
            double spin = FastestSpin * random.NextDouble() * random.NextDouble();
            double h = 1e-4 * Math.Exp(random.NextDouble() * Math.Log(3e4));
            bool holds = range.Holds(speed * speed, spin, 0, h);
            bool isGentle = (h * 0.02 * speed) + (h * 0.01 * spin) < 0.25;
            double fall = h * gravity;
            bool fastEnough = speed > 8.0 / 7.0 * (Slowest + fall);
            bool slowEnough = speed < Fastest - fall;
            string what = $"{speed} m/s, {spin} rad/s, {h} s";
            if (holds)
            {
                held++;
                Assert.True(isGentle && fastEnough && slowEnough, what);
            }
            else
            {
                // A short step is refused by what the longest of the short ones may do.
                refused++;
                double longest = Math.Max(h, Math.Min(Math.Min(0.125 / (0.02 * Fastest), 0.125 / (0.01 * FastestSpin)), 0.5 / Math.Max(1, gravity)));
                bool well = (h * 0.02 * speed) + (h * 0.01 * spin) < 0.2499 && 3072 * fall * fall < 399 * speed * speed
                    && speed > 1.0001 / 0.74 * (Slowest + (longest * gravity)) && speed < 0.9999 * (Fastest - (longest * gravity));
                Assert.False(well, what);
            }
        }

        Assert.InRange(held, 5000, 45_000);
        Assert.InRange(refused, 5000, 45_000);
    }

    [Fact]
    public void No_step_holds_in_which_gravity_alone_leaves_the_tables()
    {
        var range = new TableRange(new Scene { Gravity = 250, Forces = ForceSet.Measured with { Buoyancy = false } }, in s_forces, 300, Slowest, Fastest);
        for (double speed = 0.5; speed < 1000; speed *= 1.1)
        {
            Assert.False(range.Holds(speed * speed, 0, 0, 0.5), $"{speed} m/s");
            Assert.Equal(speed is > 8.0 / 7.0 * (Slowest + 0.5) and < Fastest - 0.5, range.Holds(speed * speed, 0, 0, 0.002));
        }
    }

    [Theory]
    [InlineData(10, 0.01)]
    [InlineData(3, 0.05)]
    [InlineData(30, 0.3)]
    public void The_spin_parameter_begins_below_its_largest_and_stays_below_the_tables_end(double speed, double h)
    {
        var range = new TableRange(new Scene { Forces = ForceSet.Measured with { Buoyancy = false } }, in s_forces, 300, Slowest, Fastest);
        double fall = h * 9.81;
        bool met = false;
        for (double surface = 0.01 * speed; surface < 40 * speed; surface *= 1.01)
        {
            bool holds = range.Holds(speed * speed, 0, surface * surface, h);

            // The slowest that the ball may be: 0.74 of its speed, less the fall. The spin only decays.
            double slowest = (0.74 * speed) - fall;
            if (holds)
            {
                met = true;
                Assert.True(surface / speed < 20);
                Assert.InRange(slowest > 0 ? surface / slowest : double.PositiveInfinity, 0, 32);
            }
            else
            {
                // Refused is little that would keep within: what the fall takes counts for more than it does.
                Assert.True(surface > 0.999 * 20 * speed || surface > 227 || (surface * surface) + (3100 * fall * fall) > 400 * speed * speed);
            }
        }

        Assert.True(met);
    }
}
