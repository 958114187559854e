using FootballPhysics.State;
using FootballPhysics.Tests.Laws;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Batch;

/// <summary>The laws in lanes at single points against the laws one by one, over the whole domain of speed and spin.</summary>
public sealed class LaneLawPointTests
{
    /// <summary>Each of a dozen operations is rounded to 6e-8, each coefficient too.</summary>
    private const double Tolerance = 6e-7;

    [Fact]
    public void The_published_law_is_the_law_on_both_branches()
    {
        FittedLaneLaw<Lanes1, PublishedLaneFit<Lanes1>> law = default;
        Compare(ref law, ForceSet.Published, Tolerance, DecayBound);
    }

    [Fact]
    public void The_regularised_law_is_the_law()
    {
        // Its weight changes by e within 0.25 m/s: of a speed of 12 m/s in float by 2e-6.
        FittedLaneLaw<Lanes1, RegularisedLaneFit<Lanes1>> law = default;
        Compare(ref law, ForceSet.Regularized, 4e-6, DecayBound);
    }

    [Fact]
    public void The_constant_law_is_the_law()
    {
        ConstantLaneLaw<Lanes1> law = default;
        Compare(ref law, ForceSet.Constant with { SpinDecayCoefficient = 3e-5 }, Tolerance, _ => Tolerance);
    }

    [Fact]
    public void The_measured_law_is_the_law()
    {
        // The crisis is so narrow that a Reynolds number in float moves the drag in it by more than an operation.
        MeasuredLaneLaw<Lanes1> law = default;
        Compare(ref law, ForceSet.Measured, 2e-6, _ => Tolerance);
    }

    /// <summary>The two plates as a parabola in x = Sp/2: what the next terms of the series come to, and what a power by degree 5 lacks.</summary>
    private static double DecayBound(double spinParameter) => 2.5e-6 + (0.02 * Math.Pow(spinParameter / 2, 4));

    private static void Compare<TLaw>(ref TLaw law, ForceSet forces, double tolerance, Func<double, double> decayTolerance)
        where TLaw : struct, ILaneLaw<Lanes1>
    {
        Scene scene = LawGrid.Scene with { Forces = forces };
        var air = new MixedLaws(scene, 1, 1);
        law.Prepare(scene);
        var drags = new Errors("drag");
        var lifts = new Errors("lift");
        var decays = new Errors("decay");
        foreach ((double speed, double spin) in Points(scene.Ball.Radius))
        {
            float speedSquared = (float)(speed * speed);
            float rate = (float)spin;
            float across = 0.7f * speedSquared;
            double parameter = scene.Ball.Radius * rate / Math.Sqrt(speedSquared);
            foreach (DragBranch branch in (DragBranch[])[DragBranch.NoSpin, DragBranch.Spinning])
            {
                // The branch with spin is never asked where it is far from holding.
                if (branch == DragBranch.Spinning && law.Jumps && (speed < 0.6 * FittedDrag.CriticalSpeed || parameter < 0.6 * FittedDrag.CriticalSpin))
                {
                    continue;
                }

                air.Factors(speedSquared, rate, across, branch, out double expectedDrag, out double expectedLift, out double expectedDecay);
                law.Begin(Lanes1.Of(rate), out LaneSpin<Lanes1> step);
                Lanes1 mask = Lanes1.Of(branch == DragBranch.Spinning ? 1 : 0);
                law.Evaluate(
                    in step, new LanesOnEither<Lanes1>(mask), Lanes1.Of(speedSquared), Lanes1.Of(across), Lanes1.Of(rate), out Lanes1 drag, out Lanes1 lift, out Lanes1 decay);
                string name = $"{speed} m/s, {spin} rad/s, {branch}";
                drags.Add(name, Math.Abs((Value(drag) / expectedDrag) - 1));

                // Where lift is the difference of like numbers, or far less than drag, an error of it is nothing.
                double size = Math.Max(Math.Abs(expectedLift), expectedDrag * Math.Max(1, parameter));
                lifts.Add(name, Math.Abs(Value(lift) - expectedLift) / size);
                decays.Add(name, Math.Abs((Value(decay) / expectedDecay) - 1) / decayTolerance(parameter));
                if (branch == DragBranch.Spinning)
                {
                    law.Evaluate(
                        in step, default(LanesWithSpin<Lanes1>), Lanes1.Of(speedSquared), Lanes1.Of(across), Lanes1.Of(rate), out Lanes1 again, out Lanes1 liftAgain, out _);
                    Assert.Equal((Value(drag), Value(lift)), law.Jumps ? (Value(again), Value(liftAgain)) : (Value(drag), Value(lift)));
                }
            }
        }

        drags.Hold(worst: tolerance);
        lifts.Hold(worst: tolerance);
        decays.Hold(worst: 1);
    }

    /// <summary>Slower than 0.8 m/s, where the powers keep their value, is left to what a flight does there.</summary>
    private static IEnumerable<(double Speed, double Spin)> Points(double radius) =>
        from speed in Enumerable.Range(0, 120).Select(i => 0.8 * Math.Pow(127.9 / 0.8, i / 119.0)).Concat([12.18, 12.2, 12.5])
        from spin in Enumerable.Range(0, 80).Select(i => 0.005 * Math.Pow(LaneDomain.GreatestSurfaceSpeed / radius / 0.005, i / 79.0))
        select (speed, spin);

    private static float Value(Lanes1 x)
    {
        var to = new float[1];
        Lanes1.Store(x, to, 0);
        return to[0];
    }
}
