using FootballPhysics.Integration;
using FootballPhysics.State;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>The laws by table against the laws point by point, wherever the tables say that they hold.</summary>
public sealed class TableLawTests
{
    private static readonly double s_radius = LawGrid.Scene.Ball.Radius;

    /// <summary>Relative to the whole acceleration: the segments about the critical speed are the limit.</summary>
    [Fact]
    public void The_regularised_law_by_table_is_the_law() => Compare<RegularisedLaw>(4e-9, 1e-9);

    /// <summary>In each of its regions, beyond where it holds.</summary>
    [Theory]
    [InlineData((int)DragBranch.NoSpin)]
    [InlineData((int)DragBranch.Spinning)]
    public void The_published_law_by_table_is_the_law(int region) => Compare<PublishedLaw>(4e-9, 1e-9, null, (DragBranch)region);

    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    [InlineData(AerodynamicModel.Measured)]
    public void What_is_left_out_of_a_law_is_nothing_and_what_is_scaled_is_scaled(AerodynamicModel form)
    {
        ForceSet all = ForceSet.Published with { Coefficients = form };
        AirLaws whole = AirLaws.Of(LawGrid.Scene with { Forces = all });
        AirLaws scaled = AirLaws.Of(LawGrid.Scene with { Forces = all }, 1.5, -0.5);
        AirLaws drags = AirLaws.Of(LawGrid.Scene with { Forces = all with { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None } });
        AirLaws lifts = AirLaws.Of(LawGrid.Scene with { Forces = all with { Drag = ForceLaw.None } });
        Assert.Equal((true, false, false), (drags.Drags, drags.Lifts, drags.SpinDecays));
        Assert.Equal((false, true, true), (lifts.Drags, lifts.Lifts, lifts.SpinDecays));
        foreach (double speed in LawGrid.Speeds)
        {
            foreach (double spin in LawGrid.Spins)
            {
                double square = speed * speed;
                whole.Factors(square, spin, square, DragBranch.Spinning, out double drag, out double lift, out double decay);
                scaled.Factors(square, spin, square, DragBranch.Spinning, out double d, out double l, out double q);
                Assert.Equal((1.5 * drag, -0.5 * lift, decay), (d, l, q));
                drags.Factors(square, spin, square, DragBranch.Spinning, out d, out l, out q);
                Assert.Equal((drag, 0, 0), (d, l, q));
                lifts.Factors(square, spin, square, DragBranch.Spinning, out d, out l, out q);
                Assert.Equal((0, lift, decay), (d, l, q));
            }
        }
    }

    [Fact]
    public void The_measured_law_by_table_is_the_law() => Compare<MeasuredLaw>(2e-9, 1e-12);

    /// <summary>The narrowest crisis, at either end of its range, and the steepest rise.</summary>
    [Fact]
    public void For_any_ball_that_is_allowed_the_measured_law_by_table_is_the_law()
    {
        foreach (double reynolds in new[] { 8e4, 6e5 })
        {
            var curve = new DragCurve
            {
                Subcritical = 2,
                CriticalReynolds = reynolds,
                Width = 1e4,
                Supercritical = 0.1,
                Risen = 0.2,
                RiseFrom = reynolds,
                RiseTo = reynolds + 1e4,
            };
            Scene scene = LawGrid.Scene with { Ball = LawGrid.Scene.Ball with { DragCurve = curve } };
            scene.Validate();
            Compare<MeasuredLaw>(1e-7, 1e-12, scene);
        }
    }

    /// <summary>A law that has nothing in common with the others but its form.</summary>
    [Fact]
    public void Any_law_by_table_is_the_law() => Compare<InventedLaw>(3e-9, 1e-9);

    /// <summary>A light ball that spins fast: at S = 2, a plate of the published spin decay has zero speed, and its 1.8th power has a kink.</summary>
    [Fact]
    public void A_law_by_table_is_the_law_at_a_large_spin_parameter()
    {
        double[] large = [.. Enumerable.Range(0, 400).Select(i => 1.9 * Math.Pow(19.99 / 1.9, i / 399.0))];
        Compare<MeasuredLaw>(2e-8, 1e-12, spinParameters: large);
        Compare<PublishedLaw>(1e-6, 3e-7, null, DragBranch.Spinning, large);
        Compare<PublishedLaw>(1e-6, 3e-7, null, DragBranch.NoSpin, large);
        Compare<RegularisedLaw>(1e-6, 3e-7, spinParameters: large);
    }

    [Fact]
    public void The_laws_point_by_point_are_the_laws_one_by_one()
    {
        OneByOne(new TableAir<RegularisedLaw>(LawGrid.Scene), ForceSet.Regularized, DragBranch.NoSpin);
        OneByOne(new TableAir<PublishedLaw>(LawGrid.Scene), ForceSet.Published, DragBranch.NoSpin);
        OneByOne(new TableAir<PublishedLaw>(LawGrid.Scene), ForceSet.Published, DragBranch.Spinning);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1e-9)]
    [InlineData(1e-6)]
    [InlineData(1e-3)]
    public void A_ball_with_next_to_no_spin_is_by_table_too(double spin)
    {
        Covers<PublishedLaw>(spin);
        Covers<RegularisedLaw>(spin);
        Covers<MeasuredLaw>(spin);
    }

    [Fact]
    public void They_hold_for_every_shot_of_a_match_and_for_a_ball_that_rolls()
    {
        var air = new TableAir<MeasuredLaw>(LawGrid.Scene);
        for (double speed = 2; speed <= 45; speed += 0.5)
        {
            for (double spin = 0; s_radius * spin < 1.6 * speed; spin += 2)
            {
                Assert.True(air.Covers(speed * speed, spin, 0.01), $"{speed} m/s, {spin} rad/s");
            }
        }
    }

    /// <summary>Beyond the tables' ends there would be no segment: whatever pulls at a ball within a step that is covered.</summary>
    [Fact]
    public void A_step_that_is_covered_never_leaves_the_tables()
    {
        int covered = Steps<PublishedLaw>() + Steps<RegularisedLaw>() + Steps<MeasuredLaw>();
        Assert.InRange(covered, 150_000, 450_000);
    }

    [Theory]
    [InlineData(0.0156, 0.1)]
    [InlineData(0.01, 0)]
    [InlineData(0, 0)]
    [InlineData(120, 30)]
    [InlineData(1e6, 30)]
    [InlineData(20, 3900)]
    [InlineData(20, double.NaN)]
    [InlineData(double.NaN, 30)]
    public void Elsewhere_the_tables_do_not_answer(double speed, double spin)
    {
        var air = new TableAir<RegularisedLaw>(LawGrid.Scene);
        Assert.False(air.Covers(speed * speed, spin, 0.01));
        Assert.False(air.HoldsAt(speed * speed, spin * spin));
    }

    /// <summary>Its axis means nothing: to the bit, not to an error.</summary>
    [Fact]
    public void A_ball_without_spin_has_drag_and_no_lift()
    {
        var air = new TableAir<RegularisedLaw>(LawGrid.Scene);
        foreach (double speed in Speeds())
        {
            Assert.True(air.HoldsAt(speed * speed, 0));
            air.Factors(speed * speed, 0, speed * speed, DragBranch.NoSpin, out double drag, out double lift, out _);
            Assert.True(drag > 0);
            Assert.Equal(0, lift);
        }
    }

    /// <summary>Absent forces and constant coefficients are data of the tables: every mixture gives the factors of its laws one by one.</summary>
    [Fact]
    public void Tables_of_every_mixture_have_the_factors_of_its_laws()
    {
        ForceLaw[] kinds = [ForceLaw.None, ForceLaw.Constant, ForceLaw.Empirical];
        int mixtures = 0;
        foreach (ForceLaw drag in kinds)
        {
            foreach (ForceLaw magnus in kinds)
            {
                foreach (ForceLaw decay in kinds)
                {
                    ForceSet forces = ForceSet.Measured with { Drag = drag, Magnus = magnus, SpinDecay = decay, SpinDecayCoefficient = 2e-4 };
                    if (AirLaws.HasFits(forces))
                    {
                        Mixture<MeasuredLaw>(forces, DragBranch.Unknown);
                        Mixture<PublishedLaw>(forces with { Coefficients = AerodynamicModel.Published }, DragBranch.NoSpin);
                        Mixture<PublishedLaw>(forces with { Coefficients = AerodynamicModel.Published }, DragBranch.Spinning);
                        Mixture<RegularisedLaw>(forces with { Coefficients = AerodynamicModel.Regularized }, DragBranch.Unknown);
                        mixtures++;
                    }
                }
            }
        }

        Assert.Equal(19, mixtures);
    }

    private static void Mixture<TLaw>(ForceSet forces, DragBranch region)
        where TLaw : struct, ITableLaw
    {
        Scene scene = LawGrid.Scene with { Forces = forces };
        var laws = new MixedLaws(scene, 1, 1);
        AirLaws tables = AirLaws.Of(scene);
        var air = new TableAir<TLaw>(scene);
        Assert.Equal(laws.Bound.At(20, 30), tables.Bound.At(20, 30), 1e-12);
        Assert.Equal((laws.Drags, laws.Lifts, laws.SpinDecays, laws.Jumps), (tables.Drags, tables.Lifts, tables.SpinDecays, tables.Jumps));
        foreach (double speed in LawGrid.Speeds)
        {
            foreach (double spin in LawGrid.Spins)
            {
                double square = speed * speed;
                if (air.HoldsAt(square, spin * spin))
                {
                    laws.Factors(square, spin, 0.7 * square, region, out double expectedDrag, out double expectedLift, out double expectedDecay);
                    air.Factors(square, spin, 0.7 * square, region, out double drag, out double lift, out double decay);

                    // The lift is a difference that vanishes at Sp 1.88.
                    double scale = Math.Max(Math.Abs(expectedLift), 0.04 * speed * Math.Pow(s_radius * spin / speed, 0.83));
                    Assert.Equal(expectedDrag, drag, 1e-6 * Math.Max(1e-9, expectedDrag));
                    Assert.Equal(expectedLift, lift, 1e-6 * Math.Max(1e-9, scale));
                    Assert.Equal(expectedDecay, decay, 1e-7 * Math.Max(1e-9, expectedDecay));
                }
            }
        }
    }

    [Fact]
    public void Scenes_with_the_same_functions_have_the_same_tables()
    {
        MeasuredLaw one = default;
        MeasuredLaw other = default;
        one.Prepare(LawGrid.Scene);
        other.Prepare(Scene.HighAltitude with { Ball = LawGrid.Scene.Ball });
        Assert.NotEqual(one.SpeedScale, other.SpeedScale);
        Assert.Same(one.Tables, other.Tables);
        Assert.Same(default(RegularisedLaw).Tables, default(RegularisedLaw).Tables);
    }

    private static void OneByOne<TLaw>(TableAir<TLaw> whole, ForceSet forces, DragBranch region)
        where TLaw : struct, ITableLaw
    {
        Scene scene = LawGrid.Scene with { Forces = forces };
        var laws = new MixedLaws(scene, 1, 1);
        Assert.Equal(laws.Bound, AirLaws.Of(scene).Bound);
        foreach (double speed in LawGrid.Speeds.Prepend(0.99e-9).Prepend(0))
        {
            foreach (double spin in LawGrid.Spins.Append(0).Append(-1e-3))
            {
                double square = speed * speed;
                laws.Factors(square, spin, square, region, out double expectedDrag, out double expectedLift, out double expectedDecay);
                whole.ByFunctions(square, spin, square, region, out double drag, out double lift, out double decay);
                Assert.InRange(drag - expectedDrag, -1e-11 * expectedDrag, 1e-11 * expectedDrag);

                // The lift is a difference that vanishes at Sp 1.88.
                double scale = Math.Max(expectedLift, expectedDrag * Math.Pow(s_radius * Math.Abs(spin) / Math.Max(speed, 1e-9), 0.83));
                Assert.InRange(lift - expectedLift, -1e-11 * scale, 1e-11 * scale);
                if (spin > 0)
                {
                    // Below a nanometre a second it is the decay at a nanometre a second.
                    double least = 1e-15 + (1e-8 * expectedDecay);
                    Assert.InRange(decay - expectedDecay, -least, least);
                }
            }
        }
    }

    private static void Covers<TLaw>(double spin)
        where TLaw : struct, ITableLaw
    {
        var air = new TableAir<TLaw>(LawGrid.Scene);
        foreach (double speed in new[] { 1.5, 5, 12.19, 20, 40, 110 })
        {
            Assert.True(air.Covers(speed * speed, spin, 0.001));
        }
    }

    /// <summary>Steps of every length from the edges of what is covered, in light and heavy air, with strong and weak gravity.</summary>
    private static int Steps<TLaw>()
        where TLaw : struct, ITableLaw
    {
        var random = new Random(11);
        int covered = 0;
        for (int i = 0; i < 400; i++)
        {
            Scene scene = LawGrid.Scene with
            {
                Gravity = 100 * Math.Pow(random.NextDouble(), 3),
                Air = new Air { Density = 20 * Math.Pow(random.NextDouble(), 4), KinematicViscosity = 1e-5 * (1 + random.NextDouble()) },
            };
            var air = new TableAir<TLaw>(scene);
            for (int k = 0; k < 400; k++)
            {
                double speed = 0.015 * Math.Pow(10_000, random.NextDouble());
                double spin = 22 * Math.Pow(random.NextDouble(), 3) * speed / s_radius;
                double h = Math.Pow(10, -4 + (3.5 * random.NextDouble()));
                if (!air.Covers(speed * speed, spin, h))
                {
                    continue;
                }

                FlightMotion motion;
                motion.Velocity = speed * Direction(random);
                motion.Axis = Direction(random);
                motion.SpinRate = spin;
                default(ClassicalRungeKutta).Fly(
                    ref air, default, ref motion, Vector3d.Zero, DragBranch.NoSpin, -scene.Gravity, h, out FlightStep step);
                Assert.True(double.IsFinite(step.AirVelocity.LengthSquared) && double.IsFinite(step.SpinRate));
                covered++;
            }
        }

        return covered;
    }

    private static Vector3d Direction(Random random)
    {
        double up = (2 * random.NextDouble()) - 1;
        double around = 2 * Math.PI * random.NextDouble();
        double across = Math.Sqrt(1 - (up * up));
        return new Vector3d(across * Math.Cos(around), up, across * Math.Sin(around));
    }

    /// <param name="forceTolerance">Relative to the whole acceleration.</param>
    /// <param name="decayTolerance">Relative to the spin decay.</param>
    /// <param name="scene">The scene; none is the usual one.</param>
    /// <param name="region">Region of the law.</param>
    /// <param name="spinParameters">The spin parameters; none is those of a football.</param>
    private static void Compare<TLaw>(
        double forceTolerance, double decayTolerance, Scene? scene = null, DragBranch region = DragBranch.NoSpin, IReadOnlyList<double>? spinParameters = null)
        where TLaw : struct, ITableLaw
    {
        var air = new TableAir<TLaw>(scene ?? LawGrid.Scene);
        double[] sines = default(TLaw).NeedsSpinAcross ? [1, 0.7, 0.1, 0] : [1];
        var forces = new Errors("acceleration");
        var decays = new Errors("spin deceleration");
        foreach (double speed in Speeds())
        {
            foreach (double spinParameter in (spinParameters ?? SpinParameters()).Where(s => s > 0.01 || region != DragBranch.Spinning))
            {
                foreach (double sine in sines)
                {
                    double square = speed * speed;
                    double spin = spinParameter * speed / s_radius;
                    double across = square * sine * sine;
                    Assert.True(air.HoldsAt(square, spin * spin));
                    air.Factors(square, spin, across, region, out double drag, out double lift, out double decay);
                    air.ByFunctions(square, spin, across, region, out double expectedDrag, out double expectedLift, out double expectedDecay);
                    string name = $"{speed} m/s, {spin} rad/s (S {spinParameter}), sine {sine}";
                    double scale = Math.Sqrt((expectedDrag * expectedDrag) + (sine * sine * expectedLift * expectedLift));
                    forces.Add(name, Math.Abs(drag - expectedDrag) / scale);
                    forces.Add(name, sine * Math.Abs(lift - expectedLift) / scale);
                    if (spin > 0)
                    {
                        decays.Add(name, Math.Abs((decay / expectedDecay) - 1));
                    }
                }
            }
        }

        Assert.True(forces.Count > 50_000);
        forces.Hold(worst: forceTolerance);
        decays.Hold(worst: decayTolerance);
    }

    private static IEnumerable<double> Speeds() =>
        Enumerable.Range(0, 400).Select(i => 0.0157 * Math.Pow(119.9 / 0.0157, i / 399.0)).Concat(Enumerable.Range(0, 150).Select(i => 11 + (i * 0.02)));

    private static IReadOnlyList<double> SpinParameters() =>
    [
        0, 1e-9, 1e-6, 1e-4, 1e-3, 0.0038, 0.0039, 0.004, 0.01, 0.02, 0.03,
        .. Enumerable.Range(0, 61).Select(i => 0.035 + (i * 0.0005)),
        .. Enumerable.Range(0, 80).Select(i => 0.066 * Math.Pow(1.899 / 0.066, i / 79.0)),
    ];
}
