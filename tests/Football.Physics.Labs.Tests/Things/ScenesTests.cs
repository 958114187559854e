using System.Text.Json;
using FootballPhysics.Labs.Scenes;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of random scenes, small; and the models that it judges by, against closed forms and printed values.</summary>
public sealed class ScenesTests
{
    private const double Radius = 0.11;

    [Theory]
    [InlineData("seams", 10, 100)]
    [InlineData("turns", 40, 40)]
    [InlineData("carriers", 8, 8)]
    [InlineData("kerbs", 20, 20)]
    [InlineData("slopes", 20, 20)]
    public void Every_scene_is_as_its_answer_says(string kind, int count, int scenes)
    {
        FootballCommand done = FootballCommand.Run("", "lab", "scenes", "--only", kind, "--count", $"{count}", "--seed", "46");
        JsonElement[] tables = [.. done.Result.GetProperty("tables").EnumerateArray()];
        Assert.Single(tables);
        Assert.Equal(scenes, tables[0].GetProperty("rows").EnumerateArray().Sum(row => row.GetProperty("scenes").GetInt32()));
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>On these drums a slide ends in a roll: the spin about the turning normal is part of the slip, whatever the step is.</summary>
    [Theory]
    [InlineData("232")]
    [InlineData("17")]
    [InlineData("300")]
    [InlineData("46")]
    public void A_slide_ends_on_a_drum_as_the_model_says(string scene)
    {
        FootballCommand done = FootballCommand.Run("", "lab", "scenes", "--only", "carriers", "--scene", scene);
        Assert.StartsWith("Drum", done.Result.GetProperty("tables")[0].GetProperty("rows")[0].GetProperty("group").GetString(), StringComparison.Ordinal);
        Assert.Equal(0, done.ExitCode);
    }

    [Fact]
    public void One_scene_is_shown_alone()
    {
        FootballCommand one = FootballCommand.Run("", "lab", "scenes", "--only", "turns", "--scene", "3");
        Assert.Equal(1, one.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
        FootballCommand refused = FootballCommand.Run("", "lab", "scenes", "--scene", "3");
        Assert.Equal(1, refused.ExitCode);
        Assert.EndsWith("--scene requires --only KIND.", refused.ErrorLine);
    }

    /// <summary>v' = k/(1 + k) Ω × v + g_t/(1 + k) on a plane that turns about its normal: circles that drift across the slope.</summary>
    [Theory]
    [InlineData(0, true)]
    [InlineData(0, false)]
    [InlineData(0.3, true)]
    [InlineData(0.3, false)]
    public void The_model_of_a_carrier_has_the_closed_form_of_a_turntable(double tilt, bool shapeTurns)
    {
        var normal = new Vector3d(Math.Sin(tilt), Math.Cos(tilt), 0);
        Vector3d down = new(Math.Cos(tilt), -Math.Sin(tilt), 0);
        Vector3d across = Vector3d.Cross(normal, down);
        const double Spin = 1.3;
        CarrierModel model = Model(shapeTurns, 0, normal, default);
        model.Spin = Spin * normal;
        model.Place = (Radius * normal) + (0.7 * across);
        model.Moves = 0.5 * down;
        model.Turns = Vector3d.Cross(normal, model.Moves - Vector3d.Cross(model.Spin, model.Place - (Radius * normal))) / Radius;
        model.Advance(2);

        // With x along down and y along across: x'' = A − w y', y'' = w x'.
        double rate = 0.4 * Spin;
        double push = 9.81 * Math.Sin(tilt) * 0.6;
        double sine = Math.Sin(2 * rate);
        double cosine = Math.Cos(2 * rate);
        double x = (0.5 * sine / rate) + (push * (1 - cosine) / (rate * rate));
        double y = (0.5 * (1 - cosine) / rate) + (push * ((2 * rate) - sine) / (rate * rate));
        Vector3d expected = (Radius * normal) + (x * down) + ((0.7 + y) * across);
        Assert.InRange(Vector3d.Distance(expected, model.Place), 0, 1e-9);
    }

    /// <summary>A jump of the carrier is slip: 0.8 of 2 m/s are passed on, within 0.8/(μ g).</summary>
    [Fact]
    public void The_model_of_a_carrier_has_the_closed_form_of_a_platform_that_sets_off()
    {
        CarrierModel model = Model(true, 0, Vector3d.Up, default);
        model.Place = new Vector3d(0, Radius, 0);
        model.Velocity = new Vector3d(2, 0, 0);
        model.Advance(3);
        double slides = 0.8 / (0.5 * 9.81);
        Assert.Equal((0.5 * 0.8 * slides) + (0.8 * (3 - slides)), model.Place.X, 1e-9);
    }

    /// <summary>A drum whose surface turns and one that turns are the same to the ball, and at rest it is the library's own cylinder.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.7)]
    [InlineData(-0.9)]
    public void The_model_of_a_drum_does_not_depend_on_what_turns(double spin)
    {
        var axis = new Vector3d(0, 0, 1);
        var normal = new Vector3d(Math.Sin(0.1), Math.Cos(0.1), 0);
        CarrierModel[] models = [Model(true, 2, normal, axis), Model(false, 2, normal, axis)];
        foreach (CarrierModel model in models)
        {
            model.Spin = spin * axis;
            model.Place = (2 + Radius) * normal;
            model.Moves = Vector3d.Cross(model.Spin, 2 * normal) + new Vector3d(0, 0, 0.4);
            model.Turns = Vector3d.Cross(normal, new Vector3d(0, 0, 0.4)) / Radius + (3 * normal);
            model.Advance(0.5);
        }

        Assert.InRange(Vector3d.Distance(models[0].Place, models[1].Place), 0, 1e-11);
        Assert.InRange(models[0].LeastLoad, 0.1, 1);
        if (spin == 0)
        {
            var surface = SurfaceMaterial.GoalFrame with { SlidingFriction = 0.5, RollingResistance = 0, NormalRestitution = 0.5 };
            var scene = new Scene
            {
                Ball = BallProperties.Tunnel,
                Air = new Air { Density = 0 },
                Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -50 },
                Obstacles = [new Obstacle { Shape = new CapsuleShape(-10 * axis, 10 * axis, 2), Surface = surface }],
            };
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch((2 + Radius) * normal, new Vector3d(0, 0, 0.4), (Vector3d.Cross(normal, new Vector3d(0, 0, 0.4)) / Radius) + (3 * normal));
            simulator.Run(ref state, 0.0025, 0.5, StopAt.Time, new StepLog());
            Assert.InRange(Vector3d.Distance(state.Position, models[0].Place), 0, 1e-7);
        }
    }

    /// <summary>Values of a dense sampling of the same leg by another program.</summary>
    [Fact]
    public void The_model_of_a_turning_leg_meets_the_ball_when_it_should()
    {
        var leg = new TurningModel(new Vector3d(0, -0.85, 0), new Vector3d(0, -0.4, 0), 0.06, false, new Vector3d(0, 1, 0), default, new Vector3d(1, 0, 0), -1.2, 10);
        double time = leg.FirstTouch(_ => new Vector3d(0, Radius, 0), 0, Radius, 0.2, out double least);
        Assert.Equal(0.10097475, time, 1e-6);
        Assert.Equal(0, least);
        leg.Distance(new Vector3d(0, Radius, 0), time, out Vector3d normal);
        Vector3d surface = Vector3d.Cross(new Vector3d(10, 0, 0), new Vector3d(0, Radius, 0) - (Radius * normal) - new Vector3d(0, 1, 0));
        Assert.InRange(Vector3d.Distance(1.5 * Vector3d.Dot(surface, normal) * normal, new Vector3d(0, -4.108924, -11.935454)), 0, 2e-4);
    }

    /// <summary>The check values of the measured laws.</summary>
    [Fact]
    public void The_model_of_the_air_has_the_printed_values()
    {
        var air = new AirModel(1.2, 1.5e-5, default);
        (Vector3d acceleration, Vector3d torque) = air.Act(new Vector3d(24, 7, 1), new Vector3d(1, 20, 15));
        Assert.InRange(Vector3d.Distance(0.43 * acceleration, new Vector3d(-3.45161595, 0.75150132, -2.29449527)), 0, 2e-8);
        Assert.InRange(Vector3d.Distance(torque, new Vector3d(-1.4645e-4, -2.92898e-3, -2.19674e-3)), 0, 1e-8);
    }

    private static CarrierModel Model(bool shapeTurns, double curve, in Vector3d normal, in Vector3d axis) =>
        new(Radius, 2.0 / 3, new Vector3d(0, -9.81, 0), Sliding: 0.5, Rolling: 0, RollingBySpeed: 0, Damping: 0, shapeTurns, curve, axis, normal);
}
