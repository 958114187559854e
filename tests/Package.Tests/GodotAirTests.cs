using FootballPhysics.GodotAddon;
using Godot;
using Vector3 = Godot.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>A RigidBody3D of Godot with the air of a football, and bodies that the football hits by Godot's coarse cast, played against the shims.</summary>
[Collection(EngineTests.Statics)]
public sealed class GodotAirTests : IDisposable
{
    public GodotAirTests() => Dispose();

    public void Dispose()
    {
        World3D.Only.DirectSpaceState.All.Clear();
        World3D.Only.DirectSpaceState.IsLocked = false;
        Engine.PhysicsTicksPerSecond = 60;
        GD.Pushed.Clear();
    }

    [Theory]
    [InlineData(240, 1e-3)]
    [InlineData(60, 5e-3)]
    public void A_kicked_body_flies_as_the_librarys_ball(int ticks, double near)
    {
        Engine.PhysicsTicksPerSecond = ticks;
        var body = new RigidBody3D { Mass = 2 };
        var air = new FootballAir();
        body.AddChild(air);
        air._Ready();
        var direction = new Vector3(0.1f, 0.3f, -1);
        air.Kick(26, direction, -15, 45);
        var simulator = new Simulator(new Scene { Ground = Ground.None, Gravity = 9.8 });
        BallState ball = simulator.Launch(
            Vector3d.Zero, GodotFrame.FromGodot(direction * (26 / direction.Length())), KickVectors.Spin(GodotFrame.FromGodot(direction), -15, 45));
        for (int i = 0; i < 1.2 * ticks; i++)
        {
            air._PhysicsProcess(1.0 / ticks);
            body.Simulate(1f / ticks);
            simulator.Step(ref ball, 1.0 / ticks, new StepLog());
        }

        Assert.InRange((body.GlobalPosition - GodotFrame.ToGodot(ball.Position)).Length(), 0, near);
        Assert.InRange((body.AngularVelocity - GodotFrame.SpinToGodot(ball.Spin)).Length(), 0, 0.05);
        Assert.True(body.GlobalPosition.X < (-0.1f * body.GlobalPosition.Z) - 1);
    }

    [Fact]
    public void A_body_that_is_frozen_or_sleeps_gets_no_force_and_another_parent_is_rejected_clearly()
    {
        var body = new RigidBody3D { LinearVelocity = new Vector3(0, 0, -20), GravityScale = 0 };
        var air = new FootballAir { Name = "Air" };
        body.AddChild(air);
        air._Ready();
        body.Freeze = true;
        air._PhysicsProcess(0.02);
        body.Freeze = false;
        body.Sleeping = true;
        air._PhysicsProcess(0.02);
        body.Simulate(0.02f);
        Assert.Equal(-20, body.LinearVelocity.Z);
        body.Sleeping = false;
        air.Preset = new FootballPreset { AirDensity = -3 };
        air._PhysicsProcess(0.02);
        air._PhysicsProcess(0.02);
        Assert.Contains("air.density is -3", Assert.Single(GD.Pushed));
        body.Simulate(0.02f);
        Assert.True(body.LinearVelocity.Z > -20);
        var lost = new FootballAir { Name = "Lost" };
        new Node3D().AddChild(lost);
        Assert.Contains("\"Lost\" is not a RigidBody3D", Assert.Throws<InvalidOperationException>(lost._Ready).Message);
    }

    [Theory]
    [InlineData("capsule")]
    [InlineData("cylinder")]
    public void A_post_is_hit_at_40_metres_a_second_a_thousand_times_of_a_thousand(string shape)
    {
        const int Shots = 1000;
        var post = new StaticBody3D { Name = "post", GlobalPosition = new Vector3(0, 1, -8) };
        post.Add(shape == "capsule" ? new CapsuleShape3D { Radius = 0.06f, Height = 4 } : new CylinderShape3D { Radius = 0.06f, Height = 4 }, Transform3D.Identity);
        World3D.Only.DirectSpaceState.All.Add(post);
        int hits = 0;
        for (int i = 0; i < Shots; i++)
        {
            // Across the whole width of post and ball, but for grazes of the last two per cent; from distances that the steps do not divide.
            float aside = 0.98f * 0.17f * ((2f * i / (Shots - 1)) - 1);
            var ball = new FootballBall { HitMask = 1, GlobalPosition = new Vector3(aside, 1, -0.01f * (i % 67)) };
            ball._Ready();
            ball.KickWith(new Vector3(0, 0.9f, -40), Vector3.Zero);
            for (int tick = 0; tick < 20 && ball.Emitted.Count == 0; tick++)
            {
                ball._PhysicsProcess(1 / 60.0);
            }

            if (ball.Emitted.Count > 0)
            {
                Variant[] said = ball.Emitted[0].Arguments;
                Assert.Equal(("post", post), (said[5].AsString(), said[6].Value));

                // The place of the ball at the impact is on the post's surface.
                var at = (Vector3)said[0].Value;
                float from = MathF.Sqrt((at.X * at.X) + ((at.Z + 8) * (at.Z + 8)));
                Assert.InRange(from, 0.17f - 1e-3f, 0.17f + 1e-3f);
                hits++;
            }
        }

        Assert.Equal(Shots, hits);
    }

    [Fact]
    public void A_space_that_rejects_queries_stops_no_step_and_is_warned_of_once()
    {
        World3D.Only.DirectSpaceState.IsLocked = true;
        var wall = new StaticBody3D { Name = "wall", GlobalPosition = new Vector3(0, 1, -3) };
        wall.Add(new BoxShape3D { Size = new Vector3(4, 4, 0.2f) }, Transform3D.Identity);
        World3D.Only.DirectSpaceState.All.Add(wall);
        var ball = new FootballBall { HitMask = 1, GlobalPosition = new Vector3(0, 1, 0) };
        ball._Ready();
        ball.KickWith(new Vector3(0, 2, -5), Vector3.Zero);
        for (int tick = 0; tick < 12; tick++)
        {
            ball._PhysicsProcess(1 / 60.0);
        }

        Assert.Equal(12, ball.Runner.Tick);
        Assert.Contains("rejected a query", Assert.Single(GD.Pushed));

        // Once the space answers, the wall is hit.
        World3D.Only.DirectSpaceState.IsLocked = false;
        for (int tick = 0; tick < 60 && ball.Emitted.Count == 0; tick++)
        {
            ball._PhysicsProcess(1 / 60.0);
        }

        Assert.Equal("wall", ball.Emitted[0].Arguments[5].AsString());
    }

    [Fact]
    public void The_impact_reports_the_ground_by_name_and_no_node()
    {
        var ball = new FootballBall { GlobalPosition = new Vector3(0, 1, 0) };
        ball._Ready();
        for (int tick = 0; tick < 60 && ball.Emitted.Count == 0; tick++)
        {
            ball._PhysicsProcess(1 / 60.0);
        }

        Variant[] said = ball.Emitted[0].Arguments;
        Assert.Equal(("ground", (object?)null), (said[5].AsString(), said[6].Value));
    }
}
