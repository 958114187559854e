using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>What every form of the air promises to those who ask it.</summary>
public sealed class AirContractTests
{
    /// <summary>A force that is none: beside it a scaled air is taken as a force like any other.</summary>
    private static readonly IForce s_nothing = IForce.From(_ => Vector3d.Zero);

    /// <summary>a = L (ω × u) and ω̇ = −decay ω by a spin vector are those by its axis and its size: for fast airs, laws one by one, and all that a scene has.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    [InlineData(AerodynamicModel.Measured)]
    public void By_the_spin_vector_and_by_its_axis_the_factors_are_the_same(AerodynamicModel form)
    {
        Scene scene = LawGrid.Scene with { Forces = ForceSet.Published with { Coefficients = form } };
        Scene mixed = scene with { Forces = scene.Forces with { Magnus = ForceLaw.Constant } };
        Scene constant = scene with { Forces = ForceSet.Constant with { SpinDecayCoefficient = 0.05 } };
        Scene none = scene with { Forces = ForceSet.None };
        PerSpin(SceneAir.Of(scene));
        PerSpin(SceneAir.Of(mixed));
        PerSpin(SceneAir.Of(constant));
        PerSpin(new ConstantAir(constant));
        PerSpin(default(NoAir));
        PerSpin(new FieldAir<MeasuredLaw>(scene, SceneAir.Of(scene)));
        PerSpin(form switch
        {
            AerodynamicModel.Measured => (IFlightAir)new TableAir<MeasuredLaw>(scene),
            AerodynamicModel.Regularized => new TableAir<RegularisedLaw>(scene),
            _ => new TableAir<PublishedLaw>(scene),
        }, withinTables: true);
        Assert.False(SceneAir.Of(none).Acts);
        Assert.True(SceneAir.Of(mixed).Acts);
    }

    /// <summary>Without a field, drag and lift are the only forces of the air.</summary>
    [Fact]
    public void Steady_air_has_no_variable_wind_and_no_side_force()
    {
        IFlightLaws[] steady = [default(NoAir), new ConstantAir(LawGrid.Scene with { Forces = ForceSet.Constant }), new TableAir<MeasuredLaw>(LawGrid.Scene), new TableAir<PublishedLaw>(LawGrid.Scene)];
        foreach (IFlightLaws air in steady)
        {
            Assert.False(air.HasField || air.HasSide);
            Assert.Equal(Vector3d.Zero, air.WindAt(1, 2, 3, 4));
            Assert.Equal(Vector3d.Zero, air.Side(default, 20, 1, 0, 1.0 / 401, Math.Sqrt(401), 0, 360_000, 5));
        }
    }

    private static void PerSpin(IFlightAir air, bool withinTables = false)
    {
        foreach (double speed in new[] { 0.2, 3.0, 13, 25, 60 })
        {
            foreach (double spin in new[] { 1e-120, 0.5, 8, 40, 300 })
            {
                const double Across = 0.6;
                if (withinTables && !(speed > 1 && LawGrid.Scene.Ball.Radius * spin < 1.9 * speed))
                {
                    continue;
                }

                double squared = speed * speed;
                air.Factors(squared, spin, Across * squared, DragBranch.Spinning, out double drag, out double lift, out double decay, out _);
                bool spins = air.FactorsPerSpin(squared, spin * spin, Across * squared * spin * spin, DragBranch.Spinning, out double d, out double l, out double q);
                Assert.Equal(spin > 1e-100, spins);
                Assert.Equal(drag, d, 1e-9 * Math.Max(1, drag));
                if (spins)
                {
                    Assert.Equal(lift / spin, l, 1e-9 * Math.Max(1, Math.Abs(lift / spin)));
                    Assert.Equal(decay / spin, q, 1e-9 * Math.Max(1, decay / spin));
                }
            }
        }
    }

    [Fact]
    public void Laws_alone_are_what_no_force_of_the_games_own_and_no_field_is_beside()
    {
        var scene = new Scene();
        Assert.True(SceneAir.HasLawsAlone(scene));
        Assert.True(SceneAir.HasLawsAlone(scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, 1.1, 0.9)] } }));
        Assert.False(SceneAir.HasLawsAlone(scene with { Forces = scene.Forces with { CustomForces = [s_nothing] } }));
        Assert.False(SceneAir.HasLawsAlone(scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, 1.1, 0.9), s_nothing] } }));
        Assert.False(SceneAir.HasLawsAlone(scene with { Forces = scene.Forces with { KnuckleSeed = 4 } }));
        Assert.False(SceneAir.HasLawsAlone(scene with { Air = scene.Air with { WindField = new WindByHeight(3, 1, 0) } }));

        // Of another ball it is a force like any other.
        Scene lighter = scene with { Ball = scene.Ball with { Mass = 0.3 } };
        Assert.False(SceneAir.HasLawsAlone(scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(lighter, 1.1, 0.9)] } }));
    }

    /// <summary>In a step that the tables alone allow whole, all forces together change the motion by at most half of it: for light and heavy balls, in thin and dense air.</summary>
    [Fact]
    public void A_step_that_the_tables_allow_whole_is_short_for_all_forces()
    {
        var random = new Random(5);
        int whole = 0;
        for (int i = 0; i < 300; i++)
        {
            Scene scene = LawGrid.Scene with
            {
                Gravity = 50 * Math.Pow(random.NextDouble(), 2),
                Ball = LawGrid.Scene.Ball with { Mass = 0.02 * Math.Pow(50, random.NextDouble()) },
                Air = LawGrid.Scene.Air with { Density = 0.1 * Math.Pow(100, random.NextDouble()) },
            };
            var all = SceneAir.Of(scene);
            var air = new TableAir<MeasuredLaw>(scene);
            var limit = StabilityLimit.Of(scene, in all, 0, -scene.Gravity, 2);
            double most = air.WholeUpTo(limit.Bound);
            for (int k = 0; k < 300; k++)
            {
                double speedSquared = Math.Pow(0.02 * Math.Pow(6000, random.NextDouble()), 2);
                double spin = Math.Sqrt(speedSquared) / LawGrid.Scene.Ball.Radius * Math.Pow(random.NextDouble(), 2) * 20;
                double h = most * random.NextDouble();
                if (air.Covers(speedSquared, spin, h))
                {
                    air.Factors(speedSquared, spin, speedSquared, DragBranch.Unknown, out double drag, out double lift, out double decay, out _);
                    Assert.InRange(h * (drag + lift + (decay / spin) + limit.Bound.Constant), 0, 0.5);
                    whole++;
                }
            }
        }

        Assert.InRange(whole, 10_000, 80_000);
    }
}
