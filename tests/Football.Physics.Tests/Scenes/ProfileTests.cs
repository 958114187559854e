using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Scenes;

/// <summary>What the two profiles are, and where they stand.</summary>
public sealed class ProfileTests
{
    private const string Page = "docs/internals/evidence.md";

    [Fact]
    public void Whatever_is_given_no_scene_has_the_measured_one()
    {
        Assert.Same(Scene.Measured, Scene.Default);
        Assert.Equal(Scene.Measured, new Scene());
        Assert.Equal(ForceSet.Measured, new ForceSet());
        Assert.Equal(Ground.Of(SurfaceMaterial.MatchTurf), new Ground());
        Assert.Equal(BallProperties.Modern, new BallProperties());
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
        Assert.Equal((AerodynamicModel.Published, GroundAerodynamics.Horizontal), (scene.Forces.Coefficients, scene.Ground.Aerodynamics));
        Assert.Equal((0.6, 0.5, 0.8), (scene.Ground.Material.NormalRestitution, scene.Ground.Material.TangentialRestitution, scene.Ground.Material.SpinRestitution));
        Assert.Equal((0.5, 0.05, 0.002), (scene.Ground.Material.SlidingFriction, scene.Ground.Material.RollingResistance, scene.Ground.Material.SpinDamping));
        Assert.Equal((double.PositiveInfinity, double.PositiveInfinity), (scene.Ground.Material.ImpactFriction, scene.Ground.Material.RestitutionSpeedScale));
    }

    [Fact]
    public void Every_number_of_a_preset_stands_in_the_page_with_what_it_rests_on()
    {
        Assert.All(PresetTable.Rows(), row => Assert.Contains(row.Tag, (string[])["measured", "law", "derived", "guess"]));
        RepositoryFiles.AssertBetween(Page, "<!-- presets, from the code -->\n", "<!-- /presets -->", PresetTable.Markdown());
    }

    /// <summary>The page of scenarios lists every number of a scene as the code does.</summary>
    [Fact]
    public void Every_number_of_a_scene_stands_in_the_page_of_scenarios() =>
        RepositoryFiles.AssertBetween("docs/command-line.md", "<!-- fields, from the code -->\n", "<!-- /fields -->", FieldTable.Markdown());

    /// <summary>Table 2 of the measured numbers.</summary>
    [Theory]
    [InlineData("dryTurf", .622, .20, 1.20, .50, .070, .006, .020)]
    [InlineData("artificialTurf", .622, .20, 1.20, .55, .069, .008, .020)]
    [InlineData("wetTurf", .570, .20, .50, .25, .064, .006, .015)]
    [InlineData("hardGround", .740, .20, .90, .50, .040, .002, .012)]
    [InlineData("longGrass", .500, .10, 1.30, .60, .130, .015, .030)]
    [InlineData("indoor", .770, .20, .80, .55, .015, .001, .006)]
    [InlineData("concrete", .861, .20, .80, .60, .013, .001, .005)]
    [InlineData("snow", .250, .00, .40, .20, .200, .010, .030)]
    public void Every_surface_has_its_numbers(string name, double e, double et, double impact, double sliding, double rolling, double bySpeed, double drilling)
    {
        SurfaceMaterial material = SurfaceMaterial.Presets[name];
        Assert.Equal((e, et, impact), (material.NormalRestitution, material.TangentialRestitution, material.ImpactFriction));
        Assert.Equal((sliding, rolling, bySpeed, drilling), (material.SlidingFriction, material.RollingResistance, material.RollingResistancePerSpeed, material.TorsionalPatchRadius));
        Assert.Equal((30, 1, 0, GroundAerodynamics.Full), (material.RestitutionSpeedScale, material.SpinRestitution, material.SpinDamping, Ground.Presets[name].Aerodynamics));
    }
}
