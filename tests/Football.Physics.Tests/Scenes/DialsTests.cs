using FootballPhysics.Tests.Support;
using FootballPhysics.Tests.Things;

namespace FootballPhysics.Tests.Scenes;

/// <summary>The dials of a designer: what they change, by how much, and that they change nothing else.</summary>
public sealed class DialsTests
{
    [Fact]
    public void At_their_defaults_they_change_nothing() => Assert.Same(Scene.Default, new Dials().Apply(Scene.Default));

    /// <summary>The ball bounces by its pressure off all that it meets: from 2 m onto concrete to h₀ (1 − L √(0.8/p))/(1 − L), a little less in air.</summary>
    [Theory]
    [InlineData(0.6, "ground")]
    [InlineData(0.7, "obstacle")]
    [InlineData(0.8, "ground")]
    [InlineData(0.9, "body")]
    [InlineData(1.1, "engine")]
    [InlineData(1.1, "pattern")]
    public void A_soft_ball_bounces_less_off_everything(double pressure, string support)
    {
        double concrete = SurfaceMaterial.Concrete.NormalRestitution;
        double usual = RiseOf(Scene.Default, support);
        double rise = RiseOf(new Dials { Pressure = pressure }.Apply(Scene.Default), support);
        double loss = 1 - (concrete * concrete);
        double share = (1 - (loss * Math.Sqrt(0.8 / pressure))) / (1 - loss);
        Assert.Equal(share * usual, rise, 0.002);
        Assert.InRange(usual, 1.32, 1.38);
    }

    /// <summary>0.3 bar more is 2.0 g of air: Δp V/(R T).</summary>
    [Fact]
    public void Air_has_mass() =>
        Assert.Equal(0.43 + (0.3e5 * 5.5753e-3 / (287.058 * 293.15)), new Dials { Pressure = 1.1 }.Apply(Scene.Default).Ball.Mass, 1e-6);

    /// <summary>A soft beach ball of 3 g would weigh less than nothing: the refusal names the dial, and both masses.</summary>
    [Fact]
    public void A_pressure_that_takes_the_mass_of_a_light_ball_is_refused_by_its_name()
    {
        Scene light = Scene.Default with { Ball = new BallProperties { Mass = 0.003, Radius = 0.2 } };
        ArgumentOutOfRangeException refusal = Assert.Throws<ArgumentOutOfRangeException>(() => new Dials { Pressure = 0.6 }.Apply(light));
        Assert.Equal("dials.pressure", refusal.ParamName);
        Assert.StartsWith("dials.pressure is 0.6, which changes ball.mass from 0.003 to -0.004", refusal.Message, StringComparison.Ordinal);
        Assert.Contains(" kg. Use a pressure or a ball with which it stays above 0.001 kg.", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Each_changes_what_its_page_names()
    {
        Scene wet = new Dials { Wetness = 1 }.Apply(Scene.Default);
        SurfaceMaterial turf = SurfaceMaterial.MatchTurf;
        Assert.Equal(0.473, wet.Ball.Mass, 1e-12);
        Assert.Equal(
            turf with
            {
                NormalRestitution = turf.NormalRestitution * (1 - 0.084),
                ImpactFriction = turf.ImpactFriction * (1 - (1 / 3.0)),
                SlidingFriction = turf.SlidingFriction * (1 - 0.45),
                TorsionalPatchRadius = 0.75 * turf.TorsionalPatchRadius,
            },
            wet.Ground.Material);
        Assert.Equal(0.28, wet.Ground.Material.ImpactFriction, 1e-12);

        Scene worn = new Dials { Wear = 1 }.Apply(Scene.Default);
        Assert.Equal(DragCurve.OfRoughness(1).CriticalReynolds, worn.Ball.DragCurve.CriticalReynolds, 1.0);
        Assert.Equal(Scene.Default with { Ball = worn.Ball }, worn);
        Assert.Equal(BallProperties.Modern with { DragCurve = worn.Ball.DragCurve }, worn.Ball);

        Scene muddy = new Dials { Mud = 1 }.Apply(Scene.Default);
        Assert.Equal(0.43 * 1.05, muddy.Ball.Mass, 1e-12);
        Assert.Equal(
            turf with { NormalRestitution = turf.NormalRestitution * (1 - 0.6), GrazingRestitutionGain = 0, SlidingFriction = turf.SlidingFriction * (1 - 0.4), RollingResistance = turf.RollingResistance + 0.12 },
            muddy.Ground.Material);
    }

    /// <summary>The same kick goes less far through mud, skids farther on wet turf, and each dial moves it.</summary>
    [Fact]
    public void Mud_stops_a_ball_and_water_lets_it_skid()
    {
        double dry = LengthOf(new Dials());
        Assert.True(LengthOf(new Dials { Mud = 0.5 }) < dry - 5);
        Assert.True(LengthOf(new Dials { Wetness = 1 }) > dry + 1);
        Assert.True(LengthOf(new Dials { Pressure = 1.1 }) > dry && LengthOf(new Dials { Pressure = 0.6 }) < dry && LengthOf(new Dials { Wear = 1 }) > dry);
    }

    /// <summary>Each part of a patterned pitch is as wet as the rest.</summary>
    [Fact]
    public void A_pattern_gets_wet_too()
    {
        var pattern = new SurfaceRectangles((new Vector3d(-1, 0, -1), new Vector3d(1, 0, 1), SurfaceMaterial.DryTurf));
        Scene scene = new Dials { Wetness = 0.5 }.Apply(Scene.Default with { Ground = Ground.Of(SurfaceMaterial.MatchTurf) with { Pattern = pattern } });
        Assert.Equal(0.5 * (1 - 0.225), scene.Ground.Pattern!.Surfaces[0].SlidingFriction, 1e-12);
        Assert.Equal(0, scene.Ground.Pattern.At(0, 0));
    }

    [Theory]
    [InlineData("pressure", 0.59)]
    [InlineData("pressure", 1.11)]
    [InlineData("wetness", -0.1)]
    [InlineData("wear", 1.1)]
    [InlineData("mud", double.NaN)]
    public void What_is_out_of_range_is_refused(string name, double value)
    {
        Dials dials = name switch
        {
            "pressure" => new Dials { Pressure = value },
            "wetness" => new Dials { Wetness = value },
            "wear" => new Dials { Wear = value },
            _ => new Dials { Mud = value },
        };
        Assert.Contains("dials." + name, Assert.Throws<ArgumentOutOfRangeException>(() => dials.Apply(Scene.Default)).Message, StringComparison.Ordinal);
    }

    /// <summary>No ball gains energy at an elastic wall, however lively it is.</summary>
    [Fact]
    public void A_lively_ball_gains_no_energy()
    {
        var scene = new Scene { Ball = new BallProperties { Bounce = 1.2 }, Forces = ForceSet.None, Ground = Ground.Of(SurfaceMaterial.MatchTurf with { NormalRestitution = 0.95, GrazingRestitutionGain = 0 }) };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), default, default);
        var log = new StepLog();
        for (int i = 0; i < 500; i++)
        {
            simulator.Step(ref state, 0.01, log);
            Assert.True(state.Position.Y <= 1 + 1e-9);
        }
    }

    private static double LengthOf(Dials dials) =>
        Flight.Play(dials.Apply(Scene.Default), SolverSettings.Default, 0.01, 30, StopAt.Rest, new Vector3d(0, 0.11, 0), new Vector3d(22, 6, 0), default, out _).Position.X;

    private static double RiseOf(Scene scene, string support)
    {
        const double Radius = 0.11;
        PosedCollider? posed = null;
        var slab = new BoxShape(new Vector3d(0, -1, 0), new Vector3d(20, 1, 20));
        switch (support)
        {
            case "ground":
                scene = scene with { Ground = scene.Ground with { Material = SurfaceMaterial.Concrete } };
                break;
            case "pattern":
                scene = scene with { Ground = scene.Ground with { Pattern = new SurfaceRectangles((new Vector3d(-1, 0, -1), new Vector3d(1, 0, 1), SurfaceMaterial.Concrete)) } };
                break;
            case "obstacle":
                scene = scene with { Ground = Ground.None, Obstacles = [new Obstacle { Shape = slab, Surface = SurfaceMaterial.Concrete }] };
                break;
            default:
                scene = scene with { Ground = Ground.None };
                posed = PosedCollider.In(ref scene, slab, SurfaceMaterial.Concrete, support == "engine");
                break;
        }

        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 2 + Radius, 0), default, default);
        var log = new StepLog();
        double highest = 0;
        bool bounced = false;
        for (int i = 0; i < 1200; i++)
        {
            posed?.MoveTo(default, Quaterniond.Identity, default, default, state.Time);
            simulator.Step(ref state, 0.001, log);
            bounced |= state.Velocity.Y > 0;
            highest = bounced ? Math.Max(highest, state.Position.Y - Radius) : 0;
        }

        return highest;
    }
}
