namespace FootballPhysics.Tests.Motion;

/// <summary>Rest is a condition, not a memory: a ball that nothing holds begins to move, however it came to lie there.</summary>
public sealed class RestConditionTests
{
    private const double Frame = 1 / 60.0;

    private static readonly Scene s_level = new() { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) };

    public static TheoryData<string> Ways => ["new", "placed", "runner", "scene", "restored"];

    /// <summary>The slope that was met: 0.34 across, 0.94 up.</summary>
    [Theory]
    [MemberData(nameof(Ways))]
    public void On_a_slope_it_rolls_as_after_a_kick_without_speed(string way) => As_after_a_kick(way, On(new Vector3d(0.34, 0.94, 0)), 120, 2.529);

    [Theory]
    [MemberData(nameof(Ways))]
    public void On_steep_slopes_it_rolls_as_after_a_kick_without_speed(string way)
    {
        As_after_a_kick(way, On(Tilted(20)), 120, null);
        As_after_a_kick(way, On(Tilted(44)), 120, null);
    }

    /// <summary>A stored state can be at rest where nothing holds the ball. Beside bodies, which may wake a ball, it then leaves.</summary>
    [Theory]
    [InlineData("slope")]
    [InlineData("ice")]
    [InlineData("held")]
    public void At_rest_where_nothing_holds_it_it_leaves(string where)
    {
        SurfaceMaterial grass = SurfaceMaterial.DryTurf with { RollingResistance = 0.1 };
        var patch = new SurfaceRectangles((new Vector3d(5, -9, -9), new Vector3d(20, 9, 9), grass with { RollingResistance = 0.001 }));
        var bodies = new KinematicBodies();
        bodies.Add("player", new SphereShape(Vector3d.Zero, 0.3)).MoveTo(new Vector3d(-50, 9, 0), Vector3d.Zero, 0);
        Scene scene = On(Tilted(where == "slope" ? 30 : 2)) with { Bodies = bodies };
        var simulator = new Simulator(scene with { Ground = scene.Ground with { Material = grass, Pattern = where == "ice" ? patch : null } });
        Vector3d n = Tilted(where == "slope" ? 30 : 2).Normalized();
        BallState ball = simulator.Launch((simulator.Scene.Ball.Radius * n) + (where == "ice" ? new Vector3d(10, -10 * n.X / n.Y, 0) : Vector3d.Zero), Vector3d.Zero, Vector3d.Zero);
        ball.Motion = MotionState.Rest;
        Vector3d start = ball.Position;

        // Another ball that grass holds must not decide about this one.
        BallState other = ball;
        other.Position = simulator.Scene.Ball.Radius * n;
        simulator.Step(ref other, Frame, new StepLog());
        for (int i = 0; i < 30; i++)
        {
            simulator.Step(ref ball, Frame, new StepLog());
        }

        Assert.Equal(where != "held", (ball.Position - start).Length > 0.01);
        Assert.Equal(0, Vector3d.Dot(ball.Position - start, n), 1e-9);
    }

    [Theory]
    [InlineData(8, 2.81)]
    [InlineData(15, 13.18)]
    [InlineData(30, 54.71)]
    public void Wind_that_rolling_friction_does_not_hold_sets_it_off(double wind, double expected)
    {
        foreach (string way in Ways.Select(row => row.Data))
        {
            As_after_a_kick(way, s_level with { Air = new Air { Wind = new Vector3d(wind, 0, 0) } }, 300, expected);
        }
    }

    /// <summary>v' = A − c₁ g v with A = F/(m (1 + k)) − c₀ g, from 2 s on.</summary>
    [Fact]
    public void A_force_that_begins_later_sets_it_off_when_it_begins()
    {
        const double Step = 1 / 64.0;
        const double Force = 3;
        Scene scene = s_level with
        {
            Air = new Air { Density = 0 },
            Forces = ForceSet.None with { CustomForces = [IForce.From(at => at.Time >= 2 ? new Vector3d(Force, 0, 0) : default)] },
        };
        var ball = new Ball(scene);
        for (int i = 0; i < 128; i++)
        {
            ball.Step(Step);
            Assert.Equal((0, MotionState.Rest), (ball.Position.X, ball.Motion));
        }

        for (int i = 0; i < 64; i++)
        {
            ball.Step(Step);
        }

        Ground turf = Ground.Of(SurfaceMaterial.DryTurf);
        double push = (Force / (scene.Ball.Mass * (1 + scene.Ball.InertiaFactor))) - (turf.Material.RollingResistance * 9.81);
        double rate = turf.Material.RollingResistancePerSpeed * 9.81;
        Assert.Equal((push / rate) - (push / (rate * rate) * (1 - Math.Exp(-rate))), ball.Position.X, 1e-6);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(44)]
    public void Without_rolling_friction_it_rolls_down_a_slope_by_the_closed_form(double degrees)
    {
        Scene scene = On(Tilted(degrees)) with { Air = new Air { Density = 0 }, Forces = ForceSet.None };
        scene = scene with { Ground = scene.Ground with { Material = scene.Ground.Material with { RollingResistance = 0, RollingResistancePerSpeed = 0, SlidingFriction = 2 } } };
        double way = 0.5 * 9.81 * Math.Sin(degrees * Math.PI / 180) / (1 + scene.Ball.InertiaFactor) * 4;
        foreach (string put in Ways.Select(row => row.Data))
        {
            Vector3d gone = Played(put, scene, 120, out Vector3d from) - from;
            Assert.Equal(way, gone.Length, 1e-6);
            Assert.InRange(gone.Y, -way, 0);
        }
    }

    /// <summary>The control: what rolling friction holds stays, and costs no evaluation where nothing can change.</summary>
    [Theory]
    [InlineData(6.6, true)]
    [InlineData(6.8, false)]
    public void On_a_slope_it_stays_where_rolling_friction_holds_it(double degrees, bool held)
    {
        // g sin θ/(1 + k) ≤ c₀ g cos θ: up to 6.654 degrees.
        Scene scene = On(Tilted(degrees)) with { Air = new Air { Density = 0 }, Forces = ForceSet.None };
        foreach (string put in Ways.Select(row => row.Data))
        {
            double gone = Vector3d.Distance(Played(put, scene, 240, out Vector3d from), from);
            Assert.Equal(held, gone == 0);
        }

        var ball = new Ball(scene);
        ball.Step(Frame);
        BallState state = ball.State;
        var log = new StepLog();
        ball.Simulator.Step(ref state, Frame, log);
        Assert.Equal(held, log.Evaluations == 0);
    }

    private static void As_after_a_kick(string way, Scene scene, int steps, double? expected)
    {
        Vector3d found = Played(way, scene, steps, out Vector3d from);
        Vector3d kicked = Played("kicked", scene, steps, out Vector3d start);
        Assert.Equal(0, Vector3d.Distance(start, from), 1e-12);
        Assert.True(Vector3d.Distance(kicked, found) <= 1e-9, $"{way}: {found.ToString("R", null)}, after a kick {kicked.ToString("R", null)}");
        if (expected is { } distance)
        {
            Assert.Equal(distance, Vector3d.Distance(from, found), 0.0051);
        }
    }

    /// <summary>Plays a ball that came to lie at the origin in one of the ways.</summary>
    private static Vector3d Played(string way, Scene scene, int steps, out Vector3d from)
    {
        if (way == "runner")
        {
            var runner = new FixedStepRunner(new Simulator(scene), Frame);
            from = runner.State.Position;
            for (int i = 0; i < steps; i++)
            {
                runner.Step();
            }

            return runner.State.Position;
        }

        var ball = new Ball(way == "scene" ? s_level : scene);
        switch (way)
        {
            case "placed":
                ball.Place(new Vector3d(0, ball.Simulator.ContactHeight, 0));
                break;
            case "restored":
                BallState state = ball.State;
                ball = new Ball(scene) { State = state };
                break;
            case "scene":
                ball.Simulator = new Simulator(scene);
                break;
            case "kicked":
                ball.Kick(default(Vector3d), default);
                break;
            case "new":
                break;
            default:
                throw new ArgumentException($"{way} is no way", nameof(way));
        }

        from = ball.Position;
        for (int i = 0; i < steps; i++)
        {
            ball.Step(Frame);
        }

        return ball.Position;
    }

    private static Scene On(in Vector3d normal) => s_level with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = normal } };

    private static Vector3d Tilted(double degrees) => new(Math.Sin(degrees * Math.PI / 180), Math.Cos(degrees * Math.PI / 180), 0);
}
