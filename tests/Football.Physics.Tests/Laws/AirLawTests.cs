using FootballPhysics.State;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>Every aerodynamic law against its plain twin, over speeds to 200 m/s and spins to 1000 rad/s.</summary>
public sealed class AirLawTests
{
    private const double Tolerance = 1e-9;

    [Fact]
    public void Published_drag_is_the_equation() =>
        Compare(
            ForceSet.Published with { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None },
            (u, w) => PlainLaws.Drag(LawGrid.Scene, PlainLaws.Published(u.Length, Sp(u, w)), u), (_, _) => 0);

    [Fact]
    public void Regularised_drag_is_the_equation() =>
        Compare(
            ForceSet.Regularized with { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None },
            (u, w) => PlainLaws.Drag(LawGrid.Scene, PlainLaws.Regularised(u.Length, Sp(u, w)), u), (_, _) => 0);

    [Fact]
    public void Constant_drag_is_the_equation() =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.Constant, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None, DragCoefficient = 0.31 },
            (u, w) => PlainLaws.Drag(LawGrid.Scene, 0.31, u), (_, _) => 0);
    [Fact]
    public void Published_lift_is_the_equation() =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None },
            (u, w) => PlainLaws.Magnus(LawGrid.Scene, PlainLaws.Lift(PlainLaws.Published(u.Length, Sp(u, w)), Sp(u, w)), u, w), (_, _) => 0);

    [Fact]
    public void Regularised_lift_is_the_equation() =>
        Compare(
            ForceSet.Regularized with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None },
            (u, w) => PlainLaws.Magnus(LawGrid.Scene, PlainLaws.Lift(PlainLaws.Regularised(u.Length, Sp(u, w)), Sp(u, w)), u, w), (_, _) => 0);

    [Fact]
    public void Lift_keeps_the_fitted_drag_coefficient_where_drag_itself_is_constant() =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.Constant, SpinDecay = ForceLaw.None, DragCoefficient = 0.31 },
            (u, w) => PlainLaws.Drag(LawGrid.Scene, 0.31, u)
                + PlainLaws.Magnus(LawGrid.Scene, PlainLaws.Lift(PlainLaws.Published(u.Length, Sp(u, w)), Sp(u, w)), u, w),
            (_, _) => 0);
    [Theory]
    [InlineData(0.37)]
    [InlineData(-0.2)]
    public void Constant_lift_is_the_equation(double coefficient) =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.None, Magnus = ForceLaw.Constant, SpinDecay = ForceLaw.None, MagnusCoefficient = coefficient },
            (u, w) => PlainLaws.ConstantMagnus(LawGrid.Scene, coefficient, u, w), (_, _) => 0);
    [Fact]
    public void Spin_decay_is_the_equation() =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.None, Magnus = ForceLaw.None },
            (_, _) => Vector3d.Zero, (speed, spin) => PlainLaws.DecayTorque(LawGrid.Scene, speed, spin));

    [Fact]
    public void Constant_spin_decay_is_the_equation() =>
        Compare(
            ForceSet.Published with { Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.Constant, SpinDecayCoefficient = 3e-5 },
            (_, _) => Vector3d.Zero, (_, spin) => 3e-5 * spin);
    [Fact]
    public void All_laws_together_add_up() =>
        Compare(
            ForceSet.Published,
            (u, w) =>
            {
                double drag = PlainLaws.Published(u.Length, Sp(u, w));
                return PlainLaws.Drag(LawGrid.Scene, drag, u) + PlainLaws.Magnus(LawGrid.Scene, PlainLaws.Lift(drag, Sp(u, w)), u, w);
            },
            (speed, spin) => PlainLaws.DecayTorque(LawGrid.Scene, speed, spin));

    [Fact]
    public void There_is_no_drag_and_no_lift_below_a_nanometre_a_second()
    {
        AirRatesAt(ForceSet.Published, 0.99e-9, 50, out double drag, out double lift, out double decay);
        Assert.Equal(0, drag);
        Assert.Equal(0, lift);
        Assert.InRange(decay * LawGrid.Scene.Ball.MomentOfInertia / PlainLaws.DecayTorque(LawGrid.Scene, 0, 50), 1 - 1e-8, 1 + 1e-8);
    }

    [Fact]
    public void Lift_vanishes_where_spin_makes_the_drag_coefficient_larger_than_at_rest()
    {
        // c Sp^d passes C_D0 there.
        double spin = Math.Pow(PlainLaws.AtRest / FittedDrag.C, 1 / FittedDrag.D) * 20 / LawGrid.Scene.Ball.Radius;
        AirRatesAt(ForceSet.Published with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None }, 20, 0.999 * spin, out _, out double below, out _);
        AirRatesAt(ForceSet.Published with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None }, 20, 1.001 * spin, out _, out double above, out _);
        Assert.True(below > 0);
        Assert.Equal(0, above);
    }

    [Fact]
    public void No_law_ever_gives_a_number_that_is_not_finite()
    {
        double[] sizes = [0, double.Epsilon, 1e-300, 1e-160, 1e-20, 1e-10, 1e-9, 1, 1000, 2000];
        double[] spins = [0, double.Epsilon, 1e-300, 1e-160, 1e-20, 1e-10, 1, 10_000, -1e-12, -1];
        foreach (double speed in sizes)
        {
            foreach (double spin in spins)
            {
                foreach (DragBranch branch in new[] { DragBranch.NoSpin, DragBranch.Spinning })
                {
                    Finite(ForceSet.Published, speed, spin, branch);
                    Finite(ForceSet.Regularized, speed, spin, branch);
                }
            }
        }
    }

    /// <summary>The numbers of the thesis, 2.6 to 2.15, and the widths of the regularised form.</summary>
    [Fact]
    [Trait("Constants", "Published")]
    public void The_constants_are_the_published_ones()
    {
        Assert.Equal(0.155, FittedDrag.A);
        Assert.Equal(0.346, FittedDrag.B);
        Assert.Equal(12.19, FittedDrag.CriticalSpeed);
        Assert.Equal(1.309, FittedDrag.SpeedScale);
        Assert.Equal(0.4127, FittedDrag.C);
        Assert.Equal(0.3056, FittedDrag.D);
        Assert.Equal(0.05, FittedDrag.CriticalSpin);
        Assert.Equal(1.15, EmpiricalMagnus.Alpha);
        Assert.Equal(0.83, EmpiricalMagnus.Beta);
        Assert.Equal(0.0074, EmpiricalSpinDecay.SkinFriction);
        Assert.Equal(0.2m, EmpiricalSpinDecay.ReynoldsExponent);
        Assert.Equal(0.25, RegularisedDragFit.SpeedWidth);
        Assert.Equal(0.0025, RegularisedDragFit.SpinWidth);
    }

    /// <summary>Points worked out with another calculator.</summary>
    [Theory]
    [Trait("Constants", "Published")]
    [InlineData(0, 0, 0.500968761494)]
    [InlineData(10, 0.5, 0.446324996944)]
    [InlineData(12.19, 0, 0.328)]
    [InlineData(25, 0, 0.155019453783)]
    [InlineData(25, 0.2, 0.252365065223)]
    [InlineData(25, 1, 0.4127)]
    public void The_drag_coefficient_has_the_published_values(double speed, double spinParameter, double expected) =>
        Assert.Equal(expected, PublishedCoefficient(speed, spinParameter), 1e-11);

    /// <summary>Steps are divided by these bounds: no force at ordinary speeds exceeds its bound, and at some speed and spin it comes near it.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    [InlineData(AerodynamicModel.Measured)]
    public void Each_force_comes_near_its_bound_and_never_exceeds_it(AerodynamicModel model)
    {
        foreach (ForceLaw law in (ForceLaw[])[ForceLaw.Constant, ForceLaw.Empirical])
        {
            ForceSet none = ForceSet.None with { Coefficients = model, SpinDecayCoefficient = 1e-5 };
            foreach (ForceSet forces in (ForceSet[])[none with { Drag = law }, none with { Magnus = law }, none with { SpinDecay = law }])
            {
                AirLaws air = AirLaws.Of(LawGrid.Scene with { Forces = forces });
                double nearest = 0;
                foreach ((double speed, double spin, double spinParameter) in LawGrid.Points.Where(at => at.Speed < AirLaws.OrdinarySpeed))
                {
                    // The torque of the plates does not vanish with the spin, so its bound is that of its rate of change.
                    DragBranch branch = LawGrid.BranchOf(speed, spinParameter);
                    air.Factors(speed * speed, spin, speed * speed, branch, out double drag, out double lift, out double decay);
                    air.Factors(speed * speed, 1.001 * spin, speed * speed, branch, out _, out _, out double more);
                    double rate = drag + lift + ((more - decay) / (0.001 * spin));
                    Assert.InRange(rate, -1e-6, (air.Bound.At(speed, spin) * (1 + 1e-3)) + 1e-6);
                    nearest = Math.Max(nearest, rate / air.OrdinaryBound.At(speed, spin));
                }

                Assert.InRange(nearest, 0.3, 1 + 1e-3);
            }

            // The bound of all is the sum, so a force that does not act adds nothing.
            RateBound BoundOf(ForceSet forces) => AirLaws.Of(LawGrid.Scene with { Forces = forces }).Bound;
            RateBound sum = BoundOf(none with { Drag = law }) + BoundOf(none with { Magnus = law }) + BoundOf(none with { SpinDecay = law });
            Assert.Equal(sum.At(20, 30), BoundOf(none with { Drag = law, Magnus = law, SpinDecay = law }).At(20, 30), 1e-12);
            Assert.Equal(0, BoundOf(none).At(20, 30));
        }
    }

    private static double PublishedCoefficient(double speed, double spinParameter) => LawGrid.BranchOf(speed, spinParameter) == DragBranch.Spinning
        ? FittedDrag.WithSpin(spinParameter)
        : FittedDrag.WithoutSpin(speed);

    private static double Sp(Vector3d u, Vector3d w) => LawGrid.Scene.Ball.Radius * w.Length / u.Length;

    private static void Finite(ForceSet forces, double speed, double spin, DragBranch branch)
    {
        Scene scene = LawGrid.Scene with { Forces = forces };
        foreach (AirLaws air in new[] { new MixedLaws(scene, 1, 1), AirLaws.Of(scene) })
        {
            air.Factors(speed * speed, spin, 0, branch, out double drag, out double lift, out double decay);
            Assert.True(double.IsFinite(drag) && double.IsFinite(lift) && double.IsFinite(decay), $"{speed} m/s, {spin} rad/s, {branch}: {drag} {lift} {decay}");
        }
    }

    private static void AirRatesAt(ForceSet forces, double speed, double spin, out double drag, out double lift, out double decay)
    {
        var air = new MixedLaws(LawGrid.Scene with { Forces = forces }, 1, 1);
        DragBranch branch = LawGrid.BranchOf(speed, LawGrid.Scene.Ball.Radius * spin / speed);
        air.Factors(speed * speed, spin, 0, branch, out drag, out lift, out decay);
    }

    /// <summary>Accelerations of the library's laws at every point of the grid against a plain force and torque.</summary>
    private static void Compare(ForceSet forces, Func<Vector3d, Vector3d, Vector3d> force, Func<double, double, double> torque)
    {
        var direction = new Vector3d(2.0 / 7, 3.0 / 7, -6.0 / 7);
        var axis = new Vector3d(-4.0 / 9, 7.0 / 9, 4.0 / 9);
        var forceErrors = new Errors("acceleration");
        var torqueErrors = new Errors("spin deceleration");
        foreach ((double speed, double spin, double sp) in LawGrid.Points)
        {
            Vector3d u = speed * direction;
            Vector3d w = spin * axis;
            AirRatesAt(forces, speed, spin, out double drag, out double lift, out double decay);
            Vector3d acceleration = (lift * Vector3d.Cross(axis, u)) - (drag * u);
            Vector3d expected = force(u, w) / LawGrid.Scene.Ball.Mass;
            double expectedDecay = torque(speed, spin) / LawGrid.Scene.Ball.MomentOfInertia;
            string name = $"{speed} m/s, {spin} rad/s (Sp {sp})";
            forceErrors.Add(name, expected.Length == 0 ? acceleration.Length : Vector3d.Distance(acceleration, expected) / expected.Length);
            torqueErrors.Add(name, expectedDecay == 0 ? Math.Abs(decay) : Math.Abs(decay - expectedDecay) / expectedDecay);
        }

        forceErrors.Hold(worst: Tolerance);
        torqueErrors.Hold(worst: Tolerance);
    }
}
