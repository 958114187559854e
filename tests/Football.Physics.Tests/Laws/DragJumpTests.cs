using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>The surfaces of the published drag law's jump along a step, against surfaces whose zeros are known and against fine sampling.</summary>
public sealed class DragJumpTests
{
    private const double H = 0.02;

    /// <summary>A function that goes straight from one number to another within the step.</summary>
    private static DragJump Of(double speed, double spin) =>

        // G = |u|² − v_c², S = 400 (r|ω|)² − |u|²
        DragJump.At(speed + (12.19 * 12.19), (spin + speed + (12.19 * 12.19)) / 400);

    private static DragJump Rate(double speed, double spin) => DragJump.Rate(speed, (spin + speed) / 400);

    [Theory]
    [InlineData(12.20, 0.0501, true)]
    [InlineData(12.18, 0.0501, false)]
    [InlineData(12.20, 0.0499, false)]
    [InlineData(12.19, 0.2, false)]
    [InlineData(30, 0.2, true)]
    [InlineData(5, 0.01, false)]
    public void The_law_with_spin_holds_above_both_critical_numbers(double speed, double spinParameter, bool spins)
    {
        var at = DragJump.At(speed * speed, spinParameter * spinParameter * speed * speed);
        Assert.Equal(spins ? DragBranch.Spinning : DragBranch.NoSpin, at.Branch);
        Assert.Equal(speed > 12.19, at.Speed > 0);
        Assert.Equal(spinParameter > 0.05, at.Spin > 0);
        Assert.Equal(Math.Min(at.Speed, at.Spin), at.Least);
        Assert.Equal(Math.Abs(at.Speed) < Math.Abs(at.Spin), at.NearerToSpeed);
    }

    [Fact]
    public void The_rates_are_those_of_the_motion_and_none_is_above_their_scale()
    {
        var random = new Random(7);
        double largest = 0;
        for (int i = 0; i < 2000; i++)
        {
            Vector3d Any(double size) => new(size * (random.NextDouble() - 0.5), size * (random.NextDouble() - 0.5), size * (random.NextDouble() - 0.5));
            Vector3d wind = Any(20);
            Vector3d v = Any(60);
            Vector3d w = Any(200);
            Vector3d a = Any(40);
            Vector3d b = Any(30);
            const double Radius = 0.11;
            const double Dt = 1e-6;
            DragJump At(double t) => DragJump.At(new FootballPhysics.Motion(Vector3d.Zero, v + (t * a), w + (t * b)), in wind, Radius);
            var motion = new FootballPhysics.Motion(Vector3d.Zero, in v, in w);
            var rates = new MotionRates(in a, in b);
            var rate = DragJump.Rate(in motion, in rates, in wind, Radius);
            Assert.Equal((At(Dt).Speed - At(-Dt).Speed) / (2 * Dt), rate.Speed, 1e-3);
            Assert.Equal((At(Dt).Spin - At(-Dt).Spin) / (2 * Dt), rate.Spin, 1);

            // A bound that is met where all are parallel.
            double scale = DragJump.RateScale(in motion, in rates, in wind, Radius);
            Assert.InRange(Math.Max(Math.Abs(rate.Speed), Math.Abs(rate.Spin)), 0, scale * (1 + 1e-12));
            largest = Math.Max(largest, Math.Abs(rate.Spin) / scale);
        }

        Assert.InRange(largest, 0.6, 1);
        var along = new FootballPhysics.Motion(Vector3d.Zero, new Vector3d(10, 0, 0), new Vector3d(0, 30, 0));
        Assert.Equal(
            (2 * 10 * 4) + (2 * 0.11 * 0.11 * 30 * 5 * 400),
            DragJump.RateScale(in along, new MotionRates(new Vector3d(-4, 0, 0), new Vector3d(0, 5, 0)), Vector3d.Zero, 0.11),
            1e-9);
    }

    /// <summary>Both functions straight in time: the law with spin holds between the later of the zeros of what rises and the earlier of what falls.</summary>
    [Fact]
    public void Straight_surfaces_are_crossed_where_they_are_zero_however_short_the_visit()
    {
        var random = new Random(3);
        int crossed = 0;
        int visits = 0;
        int quiet = 0;
        for (int i = 0; i < 20_000; i++)
        {
            double g0 = (random.NextDouble() - 0.5) * 4;
            double s0 = (random.NextDouble() - 0.5) * 4;

            // Often next to one another, so that visits are short.
            double g1 = random.Next(3) == 0 ? -g0 * 0.9 : (random.NextDouble() - 0.5) * 4;
            double s1 = random.Next(3) == 0 ? -s0 : (random.NextDouble() - 0.5) * 4;
            var from = Of(g0, s0);
            var to = Of(g1, s1);
            var rate = Rate((g1 - g0) / H, (s1 - s0) / H);
            bool inside = from.Branch == DragBranch.Spinning;
            double begins = Math.Max(g0 > 0 ? 0 : g1 > 0 ? g0 / (g0 - g1) : 2, s0 > 0 ? 0 : s1 > 0 ? s0 / (s0 - s1) : 2);
            double ends = Math.Min(g1 > 0 ? 1.5 : g0 > 0 ? g0 / (g0 - g1) : -1, s1 > 0 ? 1.5 : s0 > 0 ? s0 / (s0 - s1) : -1);
            double expected = inside ? (ends <= 1 ? ends : 2) : begins < ends ? begins : 2;
            double found = DragJump.FirstCrossing(from.Branch, in from, in rate, in to, in rate, H, out bool bySpeed);
            Assert.Equal(expected, found, 1e-9);
            bool mayCross = DragJump.MayCross(from.Branch, in from, in rate, in to, H);
            Assert.True(mayCross || expected > 1, $"{g0} to {g1}, {s0} to {s1}");
            quiet += !mayCross ? 1 : 0;
            if (expected > 1)
            {
                continue;
            }

            crossed++;
            visits += !inside && ends < 1 ? 1 : 0;
            double g = g0 + (expected * (g1 - g0));
            double s = s0 + (expected * (s1 - s0));
            Assert.Equal(Math.Abs(g) < Math.Abs(s), bySpeed);
        }

        // Many steps are told at once that they cross nothing: half of those that do not.
        Assert.InRange(crossed, 5000, 12_000);
        Assert.InRange(visits, 100, 5000);
        Assert.InRange(quiet, (20_000 - crossed) / 2, 20_000 - crossed);
    }

    /// <summary>Bent surfaces: what fine sampling of the cubics sees first, where it lasts for a sample of the search.</summary>
    [Fact]
    public void Bent_surfaces_are_crossed_where_sampling_sees_it()
    {
        var random = new Random(11);
        int crossed = 0;
        const int Samples = 4096;
        for (int i = 0; i < 1500; i++)
        {
            double[] y = [.. Enumerable.Range(0, 8).Select(k => (random.NextDouble() - 0.5) * 4)];
            var from = Of(y[0], y[1]);
            var to = Of(y[2], y[3]);
            var fromRate = Rate(y[4] / H, y[5] / H);
            var toRate = Rate(y[6] / H, y[7] / H);
            bool inside = from.Branch == DragBranch.Spinning;
            bool Inside(double x) => Hermite(y[0], y[4], y[2], y[6], x) > 0 && Hermite(y[1], y[5], y[3], y[7], x) > 0;
            int first = Enumerable.Range(1, Samples).FirstOrDefault(k => Inside((double)k / Samples) != inside);
            double found = DragJump.FirstCrossing(from.Branch, in from, in fromRate, in to, in toRate, H, out _);
            if (found <= 1)
            {
                // Never where nothing is, and the change is there.
                Assert.NotEqual(inside, Inside(found + 1e-9));
                Assert.InRange(first, 0, Math.Ceiling(found * Samples) + 1);
            }

            int last = first == 0 ? 0 : Enumerable.Range(first, Samples + 1 - first).TakeWhile(k => Inside((double)k / Samples) != inside).Last();
            if (first > 0 && (last - first) > Samples / 16)
            {
                crossed++;
                Assert.InRange(found, (first - 1.0) / Samples, (double)first / Samples);
            }
        }

        Assert.InRange(crossed, 300, 1500);

        // y = y₀ (1 − 3 x² + 2 x³) + y₁ (3 x² − 2 x³) + m₀ (x − 2 x² + x³) + m₁ (x³ − x²)
        static double Hermite(double y0, double m0, double y1, double m1, double x) =>
            (y0 * (1 - (3 * x * x) + (2 * x * x * x))) + (y1 * ((3 * x * x) - (2 * x * x * x))) + (m0 * (x - (2 * x * x) + (x * x * x))) + (m1 * ((x * x * x) - (x * x)));
    }

    /// <summary>A step that starts and ends in the law with spin may have left it in between, if a surface falls fast at the start.</summary>
    [Fact]
    public void A_step_that_crosses_and_returns_may_cross()
    {
        DragJump inside = Of(1, 1);
        Assert.False(DragJump.MayCross(DragBranch.Spinning, in inside, Rate(0, 0), in inside, H));
        Assert.False(DragJump.MayCross(DragBranch.Spinning, in inside, Rate(-0.5 / H, -0.5 / H), in inside, H));
        Assert.True(DragJump.MayCross(DragBranch.Spinning, in inside, Rate(-2 / H, 0), in inside, H));
        Assert.True(DragJump.MayCross(DragBranch.Spinning, in inside, Rate(0, -2 / H), in inside, H));

        // From outside, one surface rises above zero and returns.
        DragJump slow = Of(-1, 1);
        DragJump dull = Of(1, -1);
        Assert.False(DragJump.MayCross(DragBranch.NoSpin, in slow, Rate(0.5 / H, 0), in slow, H));
        Assert.True(DragJump.MayCross(DragBranch.NoSpin, in slow, Rate(2 / H, 0), in slow, H));
        Assert.False(DragJump.MayCross(DragBranch.NoSpin, in dull, Rate(0, 0.5 / H), in dull, H));
        Assert.True(DragJump.MayCross(DragBranch.NoSpin, in dull, Rate(0, 2 / H), in dull, H));
    }
}
