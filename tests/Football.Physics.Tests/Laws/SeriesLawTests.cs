using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Laws;

/// <summary>The published laws as series about a step's start against the laws one by one, as far from the start as they are asked for.</summary>
public sealed class SeriesLawTests
{
    private const double Farthest = 1.0 / 32;
    private const double FarthestSpin = 1.0 / 1024;

    private static readonly double[] s_shares = [-1, -0.7, -0.3, -0.05, 0, 0.05, 0.3, 0.7, 1];

    /// <summary>Exponents of |u|² of the drag, of both parts of the lift, and of the decay.</summary>
    private static readonly double[] s_powers = [0.5 * (1 - 0.3056), 0.5 * (1 - 0.83), 0.5 * (1 - 0.83 - 0.3056), 0.9];

    [Fact]
    public void All_series_are_the_laws() => Compare<Present, EmpiricalDrag, Present, EmpiricalMagnus, Present, EmpiricalSpinDecay>();

    [Fact]
    public void Series_without_decay_are_the_laws() => Compare<Present, EmpiricalDrag, Present, EmpiricalMagnus, Absent, NoAirLaw>();

    [Fact]
    public void Series_of_drag_alone_are_the_law() => Compare<Present, EmpiricalDrag, Absent, NoAirLaw, Absent, NoAirLaw>();

    [Fact]
    public void Series_of_drag_and_decay_are_the_laws() => Compare<Present, EmpiricalDrag, Absent, NoAirLaw, Present, EmpiricalSpinDecay>();

    [Fact]
    public void Series_of_lift_alone_are_the_law() => Compare<Absent, NoAirLaw, Present, EmpiricalMagnus, Absent, NoAirLaw>();

    [Fact]
    public void Series_of_lift_and_decay_are_the_laws() => Compare<Absent, NoAirLaw, Present, EmpiricalMagnus, Present, EmpiricalSpinDecay>();

    /// <summary>The last coefficients hardly show in a value: so each is held to the binomial that it is.</summary>
    [Fact]
    public void Every_coefficient_is_its_binomial()
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        foreach ((double speed, double spin) in Starts(air))
        {
            AirStep step = Start(ref air, speed * speed, spin);
            Assert.True(air.Expand(in step, 0, 0, out AirSeries series));
            double lift = step.StartLift;
            double byDrag = step.StartLiftByDrag;
            Same(
                1e-12,
                (step.StartDrag, series.Drag.A, step.StartDrag),
                (step.StartDrag, series.Drag.B, step.StartDrag * Binomial(s_powers[0], 1)),
                (step.StartDrag, series.Drag.C, step.StartDrag * Binomial(s_powers[0], 2)),
                (step.StartDrag, series.Drag.D, step.StartDrag * Binomial(s_powers[0], 3)),
                (step.StartDrag, series.Drag.E, step.StartDrag * Binomial(s_powers[0], 4)),
                (lift, series.Lift.A, lift - byDrag),
                (lift, series.Lift.B, (lift * Binomial(s_powers[1], 1)) - (byDrag * Binomial(s_powers[2], 1))),
                (lift, series.Lift.C, (lift * Binomial(s_powers[1], 2)) - (byDrag * Binomial(s_powers[2], 2))),
                (lift, series.Lift.D, (lift * Binomial(s_powers[1], 3)) - (byDrag * Binomial(s_powers[2], 3))),
                (lift, series.Lift.E, (lift * Binomial(s_powers[1], 4)) - (byDrag * Binomial(s_powers[2], 4))),
                (byDrag, series.LiftByDrag0, byDrag),
                (byDrag, series.LiftByDrag1, byDrag * Binomial(s_powers[2], 1)),
                (byDrag, series.LiftByDrag2, byDrag * Binomial(s_powers[2], 2)));

            // |u|^1.8 G(X), X = X₀ (1 + δ)²/(1 + ε): the slope X G′ stands for all of G's change, so that it goes as 1/(1 + ε).
            double whole = step.StartDecay * PlateSum(step.StartRatio);
            double slope = step.StartDecay * step.StartRatio * PlateSlope(step.StartRatio);
            Same(
                1e-9 + (0.008 * Math.Pow(step.StartRatio, 5)), // The slope's polynomial ends before X⁵.
                (whole, series.Decay0, whole),
                (whole, series.Decay1, (whole * Binomial(s_powers[3], 1)) - slope),
                (whole, series.Decay2, (whole * Binomial(s_powers[3], 2)) + (slope * (1 - Binomial(s_powers[3], 1)))),
                (whole, series.Decay3, (whole * Binomial(s_powers[3], 3)) - (slope * (1 - Binomial(s_powers[3], 1) + Binomial(s_powers[3], 2)))),
                (whole, series.DecayBySpin, 2 * slope));
        }
    }

    /// <summary>Likewise the powers of the spin, which within a step hardly changes: asked for a tenth of it they are still these sums.</summary>
    [Theory]
    [InlineData(-0.1)]
    [InlineData(0.1)]
    public void Every_power_of_the_spin_is_its_binomial_sum(double change)
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        foreach ((double speed, double spin) in Starts(air))
        {
            double square = speed * speed;
            AirStep step = Start(ref air, square, spin);
            Assert.True(air.Expand(in step, 0, 0, out AirSeries series));
            double lift = step.StartLift;
            double byDrag = step.StartLiftByDrag;
            double onDrag = Sum(0.3056, change, 2);
            air.EvaluateNear(in series, square, spin * (1 + change), out double nearDrag, out double nearLift, out double nearDecay);
            Same(
                1e-12,
                (step.StartDrag, nearDrag, step.StartDrag * onDrag),
                (lift, nearLift, Sum(0.83, change, 2) * (lift - (onDrag * byDrag))),
                (series.Decay0, nearDecay, series.Decay0 + (series.DecayBySpin * change)));
            onDrag = Sum(0.3056, change, 3);
            air.Evaluate(in step, square, spin * (1 + change), square, out double drag, out double faded, out _);
            Same(
                1e-12,
                (step.StartDrag, drag, step.StartDrag * onDrag),
                (lift, faded, Sum(0.83, change, 3) * (lift - (onDrag * byDrag))));
        }
    }

    [Fact]
    public void There_are_no_series_for_larger_changes()
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        foreach ((double speed, double spin) in Starts(air))
        {
            double square = speed * speed;
            AirStep step = Start(ref air, square, spin);
            Assert.True(air.Expand(in step, Farthest * square, FarthestSpin * spin, out _));
            Assert.False(air.Expand(in step, Farthest * square * (1 + 1e-15), 0, out _));
            Assert.False(air.Expand(in step, 0, FarthestSpin * spin * (1 + 1e-15), out _));
            Assert.False(air.Expand(in step, double.PositiveInfinity, 0, out _));
        }
    }

    [Theory]
    [InlineData((int)DragBranch.Unknown)]
    [InlineData((int)DragBranch.NoSpin)]
    [InlineData((int)DragBranch.AlongCriticalSpeed)]
    [InlineData((int)DragBranch.AlongCriticalSpin)]
    public void There_are_no_series_but_on_the_branch_with_spin(int branch)
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        air.Begin(30, (DragBranch)branch, out AirStep step);
        air.EvaluateStart(ref step, 400, 30, 400, out _, out _, out _);
        Assert.False(air.Expand(in step, 0, 0, out _));
    }

    [Fact]
    public void There_are_no_series_of_decay_alone()
    {
        PublishedAir<Absent, Absent, Present> air = default;
        air.Prepare(LawGrid.Scene);
        AirStep step = Start(ref air, 400, 30);
        Assert.False(air.Expand(in step, 0, 0, out _));
    }

    private static void Compare<TDrag, TDragLaw, TMagnus, TMagnusLaw, TDecay, TDecayLaw>()
        where TDrag : struct, IPresence
        where TDragLaw : struct, IAirLaw
        where TMagnus : struct, IPresence
        where TMagnusLaw : struct, IAirLaw
        where TDecay : struct, IPresence
        where TDecayLaw : struct, IAirLaw
    {
        PublishedAir<TDrag, TMagnus, TDecay> air = default;
        Aerodynamics<PublishedDragFit, TDragLaw, TMagnusLaw, TDecayLaw> laws = default;
        Aerodynamics<PublishedDragFit, EmpiricalDrag, NoAirLaw, NoAirLaw> drags = default;
        air.Prepare(LawGrid.Scene);
        laws.Prepare(LawGrid.Scene);
        drags.Prepare(LawGrid.Scene);
        var random = new Random(11);
        var dragErrors = new Errors("drag");
        var liftErrors = new Errors("lift");
        var decayErrors = new Errors("decay");
        foreach ((double speed, double spin) in Starts(air))
        {
            double square = speed * speed;
            AirStep step = Start(ref air, square, spin);
            Assert.True(air.Expand(in step, Farthest * square, FarthestSpin * spin, out AirSeries series));
            var points = s_shares.SelectMany(e => s_shares.Where(d => d >= 0).Select(d => (e, d)))
                .Concat(Enumerable.Range(0, 30).Select(_ => ((2 * random.NextDouble()) - 1, random.NextDouble())));
            foreach ((double e, double d) in points)
            {
                double nearSquare = square * (1 + (e * Farthest));
                double nearSpin = spin * (1 - (d * FarthestSpin));
                air.EvaluateNear(in series, nearSquare, nearSpin, out double drag, out double lift, out double decay);
                laws.Begin(nearSpin, DragBranch.Spinning, out AirStep once);
                laws.Evaluate(in once, nearSquare, nearSpin, nearSquare, out double expectedDrag, out double expectedLift, out double expectedDecay);
                drags.Evaluate(in once, nearSquare, nearSpin, nearSquare, out double anyDrag, out _, out _);
                string name = $"{speed} m/s, {spin} rad/s, {e} of the way in |u|², {d} of the spin's loss";
                if (default(TDrag).Is)
                {
                    dragErrors.Add(name, Math.Abs((drag / expectedDrag) - 1));
                }

                if (default(TMagnus).Is)
                {
                    // An error is nothing beside a drag that is far larger.
                    liftErrors.Add(name, Math.Abs(lift - expectedLift) / Math.Max(expectedLift, anyDrag));
                }

                if (default(TDecay).Is)
                {
                    decayErrors.Add(name, Math.Abs((decay / expectedDecay) - 1));
                }

                Assert.True(default(TMagnus).Is || lift == 0);
                Assert.True(default(TDecay).Is || decay == 0);
            }
        }

        Hold(dragErrors, default(TDrag).Is, 1.2e-9);
        Hold(liftErrors, default(TMagnus).Is, 4e-9);

        // Of a rate that takes at most 1/1024 of the spin.
        Hold(decayErrors, default(TDecay).Is, 2.3e-6);
    }

    private static void Hold(Errors errors, bool present, double worst)
    {
        if (present)
        {
            Assert.True(errors.Count > 100_000);
            errors.Hold(worst: worst);
        }
    }

    private static void Same(double tolerance, params ReadOnlySpan<(double Scale, double Actual, double Expected)> pairs)
    {
        foreach ((double scale, double actual, double expected) in pairs)
        {
            Assert.InRange(actual - expected, -tolerance * scale, tolerance * scale);
        }
    }

    /// <summary>Where steps start: the whole domain of the fused laws, with any spin.</summary>
    private static IEnumerable<(double Speed, double Spin)> Starts<TAir>(TAir air)
        where TAir : struct, IAerodynamics =>
        from speed in Enumerable.Range(0, 48).Select(i => 1.06 * Math.Pow(119 / 1.06, i / 47.0))
        from spin in Enumerable.Range(0, 48).Select(i => 1e-2 * Math.Pow(1000 / 1e-2, i / 47.0))
        where air.Covers(speed * speed, spin, 1e-4)
        select (speed, spin);

    private static AirStep Start<TAir>(ref TAir air, double speedSquared, double spin)
        where TAir : struct, IAerodynamics
    {
        air.Begin(spin, DragBranch.Spinning, out AirStep step);
        air.EvaluateStart(ref step, speedSquared, spin, speedSquared, out _, out _, out _);
        return step;
    }

    private static double Binomial(double power, int order) => order == 0 ? 1 : Binomial(power, order - 1) * (power - order + 1) / order;

    /// <summary>The first terms of (1 + x)^power.</summary>
    private static double Sum(double power, double x, int order) =>
        Enumerable.Range(0, order + 1).Sum(i => Binomial(power, i) * Math.Pow(x, i));

    /// <summary>G = ((1 + x)^1.8 + (1 − x)^1.8)/2, X = x².</summary>
    private static double PlateSum(double ratio) => 0.5 * (Math.Pow(1 + Math.Sqrt(ratio), 1.8) + Math.Pow(1 - Math.Sqrt(ratio), 1.8));

    /// <summary>dG/dX.</summary>
    private static double PlateSlope(double ratio)
    {
        double x = Math.Sqrt(ratio);
        return 0.45 * (Math.Pow(1 + x, 0.8) - Math.Pow(1 - x, 0.8)) / x;
    }
}
