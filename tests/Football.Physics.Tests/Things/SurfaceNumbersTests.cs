using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>What a ball does that meets the surfaces a game has: the presets' numbers, seen from outside.</summary>
public sealed class SurfaceNumbersTests
{
    private static readonly SolverSettings s_rk4 = Flight.With(Integrator.Rk4);

    /// <summary>e = e₀/√(1 + (v_n/V_e)²), 0.80 at 6 m/s, V_e = 30 m/s.</summary>
    [Theory]
    [InlineData(3, 0.81179)]
    [InlineData(6, 0.80000)]
    [InlineData(20, 0.67882)]
    public void The_measured_frame_gives_back_less_of_a_faster_ball(double speed, double restitution) =>
        Assert.Equal(restitution, Restitution(new Scene { Obstacles = [Wall(SurfaceMaterial.GoalFrame)] }, speed), 1e-5);

    [Theory]
    [InlineData(nameof(SurfaceMaterial.PublishedGoalFrame), 0.70)]
    [InlineData(nameof(SurfaceMaterial.Wood), 0.65)]
    [InlineData(nameof(SurfaceMaterial.Board), 0.50)]
    [InlineData(nameof(SurfaceMaterial.Concrete), 0.861)]
    [InlineData(nameof(SurfaceMaterial.Boot), 0.50)]
    [InlineData(nameof(SurfaceMaterial.Head), 0.45)]
    [InlineData(nameof(SurfaceMaterial.Glove), 0.25)]
    public void Presets_give_back_what_their_comments_say(string name, double restitution)
    {
        var surface = (SurfaceMaterial)typeof(SurfaceMaterial).GetProperty(name)!.GetValue(null)!;
        Assert.Equal(restitution, Restitution(new Scene { Obstacles = [Wall(surface)] }, 6), 1e-12);
    }

    [Fact]
    public void A_body_is_a_boot_unless_it_is_told_otherwise()
    {
        var bodies = new KinematicBodies();
        bodies.Add("leg", Wall(SurfaceMaterial.Wood).Shape);
        Assert.Equal(0.5, Restitution(new Scene { Bodies = bodies }, 6), 1e-12);
    }

    /// <summary>A goal has the frame of its scene's laws: measured 0.80 at 6 m/s, in the thesis 0.7 at every speed; or its own.</summary>
    [Fact]
    public void The_frame_of_a_goal_is_that_of_its_scene()
    {
        var goal = new Goal { Center = new Vector3d(3.72, 0, 0.06), Facing = new Vector3d(0, 0, 1), HasNet = false };
        Assert.Equal(0.80, Restitution(new Scene { Goals = [goal] }, 6), 1e-12);
        Assert.Equal(0.67882, Restitution(Pitch.Standard.On() with { Goals = [goal] }, 20), 1e-5);
        Assert.Equal(0.7, Restitution(Scene.Published with { Goals = [goal] }, 20), 1e-12);
        Assert.Equal(0.65, Restitution(new Scene { Goals = [goal with { Surface = SurfaceMaterial.Wood }] }, 6), 1e-12);
        Assert.Equal(0.80, Restitution(new Scene { Goals = [Pitch.Standard.Goal with { Center = goal.Center, HasNet = false }] }, 6), 1e-12);
    }

    /// <summary>The same turf as the ground, as a pattern on other ground and as a table: the ball rolls as far.</summary>
    [Fact]
    public void A_ball_rolls_as_far_on_a_pattern_and_on_a_table_as_on_the_ground_of_the_same()
    {
        Ground turf = Ground.Of(SurfaceMaterial.DryTurf);
        Ground patterned = new Ground { Material = SurfaceMaterial.Concrete, Pattern = new SurfaceRectangles((new Vector3d(-100, 0, -100), new Vector3d(100, 0, 100), turf.Material)) };
        var table = new Obstacle { Name = "table", Shape = new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(50, 0.5, 50)), Surface = turf.Material };
        Vector3d ground = Roll(new Scene { Ground = turf }, 0);
        Assert.Equal(0, Vector3d.Distance(ground, Roll(new Scene { Ground = patterned }, 0)), 1e-6);
        Assert.Equal(0, Vector3d.Distance(ground, Roll(new Scene { Obstacles = [table] }, 1)), 1e-6);
    }

    [Theory]
    [InlineData(0, -1, "far board", 56.5)]
    [InlineData(0, 1, "near board", 56.5)]
    [InlineData(-1, 0, "left board", 38)]
    [InlineData(1, 0, "right board", 38)]
    public void The_boards_of_a_stadium_stand_4_m_behind_the_lines(double x, double z, string name, double from)
    {
        var simulator = new Simulator(Pitch.Stadium.On(), s_rk4);
        var towards = new Vector3d(x, 0, z);
        BallState state = simulator.Launch(((from - 2) * towards) + new Vector3d(20 * z * z, 0.5, 20 * x * x), 20 * towards, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
        Assert.Equal(name, simulator.NameOf(log.Events[0].ColliderIndex));
        Assert.Equal(from - Flight.Radius, Vector3d.Dot(log.Events[0].Position, in towards), 1e-9);
    }

    private static Obstacle Wall(SurfaceMaterial surface) =>
        new() { Name = "wall", Shape = new BoxShape(new Vector3d(0, 1, -1), new Vector3d(5, 1, 1)), Surface = surface };

    /// <summary>Against what stands at z = 0, straight on.</summary>
    private static double Restitution(Scene scene, double speed)
    {
        var simulator = new Simulator(scene with { Gravity = 0, Air = new Air { Density = 0 } }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 1, 1), new Vector3d(0, 0, -speed), Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 2, StopAt.Impact, log);
        return log.Events[0].Velocity.Z / speed;
    }

    private static Vector3d Roll(Scene scene, double height)
    {
        var up = new Vector3d(0, height, 0);
        BallState rest = Flight.Play(
            scene, s_rk4, 0.01, 30, StopAt.Rest, up + new Vector3d(0, Flight.Radius, 0), new Vector3d(3, 0, 4), new Vector3d(4, 0, -3) / Flight.Radius, out StepLog log);
        Assert.Equal("Rest", Flight.Kinds(log));
        return rest.Position - up;
    }
}
