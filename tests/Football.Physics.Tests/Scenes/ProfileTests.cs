using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Scenes;

/// <summary>What the two profiles are, and where they stand.</summary>
public sealed class ProfileTests
{
    private const string Page = "docs/profiles.md";

    [Fact]
    public void Whatever_is_given_no_scene_has_the_measured_one()
    {
        Assert.Same(Scene.Measured, Scene.Default);
        Assert.Equal(Scene.Measured, new Scene());
        Assert.Equal(ForceSet.Measured, new ForceSet());
        Assert.Equal(Ground.DryTurf, new Ground());
        foreach (Scene scene in (Scene[])[new Ball().Simulator.Scene, new Simulator().Scene, new FixedStepRunner().Simulator.Scene, new BallBatch().Scene])
        {
            Assert.Same(Scene.Measured, scene);
        }
    }

    /// <summary>A simulator takes it as it is.</summary>
    [Fact]
    public void The_default_scene_is_in_range() => Scene.Default.Validate();

    [Fact]
    public void The_published_profile_is_the_thesis()
    {
        Scene scene = Scene.Published;
        Assert.Equal((CoefficientForm.Published, GroundAerodynamics.Horizontal), (scene.Forces.Coefficients, scene.Ground.Aerodynamics));
        Assert.Equal((0.6, 0.5, 0.5, 0.8), (scene.Ground.NormalRestitution, scene.Ground.TangentialRestitutionX, scene.Ground.TangentialRestitutionZ, scene.Ground.SpinRestitution));
        Assert.Equal((0.5, 0.05, 0.002), (scene.Ground.SlidingFriction, scene.Ground.RollingFriction, scene.Ground.SpinDamping));
        Assert.Equal((double.PositiveInfinity, double.PositiveInfinity), (scene.Ground.ImpactFriction, scene.Ground.RestitutionSpeed));
    }

    [Fact]
    public void Every_number_of_a_preset_stands_in_the_page_with_what_it_rests_on()
    {
        Assert.All(PresetTable.Rows(), row => Assert.Contains(row.Tag, (string[])["measured", "law", "derived", "guess"]));
        RepositoryFiles.AssertBetween(Page, "<!-- presets, from the code -->\n", "<!-- /presets -->", PresetTable.Markdown());
    }

    /// <summary>Table 2 of the measured numbers.</summary>
    [Theory]
    [InlineData(nameof(Ground.DryTurf), .622, .20, 1.20, .50, .070, .006, .020)]
    [InlineData(nameof(Ground.ArtificialTurf), .622, .20, 1.20, .55, .069, .008, .020)]
    [InlineData(nameof(Ground.WetTurf), .570, .20, .50, .25, .064, .006, .015)]
    [InlineData(nameof(Ground.HardGround), .740, .20, .90, .50, .040, .002, .012)]
    [InlineData(nameof(Ground.LongGrass), .500, .10, 1.30, .60, .130, .015, .030)]
    [InlineData(nameof(Ground.Indoor), .770, .20, .80, .55, .015, .001, .006)]
    [InlineData(nameof(Ground.Concrete), .861, .20, .80, .60, .013, .001, .005)]
    [InlineData(nameof(Ground.Snow), .250, .00, .40, .20, .200, .010, .030)]
    public void Every_surface_has_its_numbers(string name, double e, double et, double impact, double sliding, double rolling, double bySpeed, double drilling)
    {
        var ground = (Ground)typeof(Ground).GetProperty(name)!.GetValue(null)!;
        Assert.Equal((e, et, et, impact), (ground.NormalRestitution, ground.TangentialRestitutionX, ground.TangentialRestitutionZ, ground.ImpactFriction));
        Assert.Equal((sliding, rolling, bySpeed, drilling), (ground.SlidingFriction, ground.RollingFriction, ground.RollingFrictionBySpeed, ground.DrillingLength));
        Assert.Equal((30, 1, 0, GroundAerodynamics.Full), (ground.RestitutionSpeed, ground.SpinRestitution, ground.SpinDamping, ground.Aerodynamics));
    }
}
