using GodotBall = FootballPhysics.GodotAddon.FootballBall;
using GodotBox = Godot.BoxShape3D;
using GodotVector = Godot.Vector3;
using UnityBall = FootballPhysics.Unity.FootballBall;
using UnityVector = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>The engines' own colliders through the samples' adapters, against shims of the engines' queries.</summary>
[Collection(EngineTests.Statics)]
public sealed class EngineColliderTests : IDisposable
{
    public static TheoryData<string> Things => ["sphere", "box", "capsule", "plane", "moving"];

    public void Dispose()
    {
        UnityEngine.GameObject.DestroyAll();
        UnityEngine.Physics.All.Clear();
        Godot.World3D.Only.DirectSpaceState.All.Clear();
    }

    [Theory]
    [MemberData(nameof(Things))]
    public void A_ball_bounces_off_Unitys_collider_at_the_same_instant_as_off_our_own_shape(string thing)
    {
        var holder = new UnityEngine.GameObject { name = thing };
        UnityEngine.Collider collider;
        switch (thing)
        {
            case "box":
                UnityEngine.BoxCollider box = holder.Attach<UnityEngine.BoxCollider>();
                box.size = new UnityVector(2f, 2f, 0.5f);
                collider = box;
                break;
            case "capsule":
                UnityEngine.CapsuleCollider capsule = holder.Attach<UnityEngine.CapsuleCollider>();
                capsule.radius = 0.25f;
                capsule.height = 2.5f;
                collider = capsule;
                break;
            case "plane":
                collider = holder.Attach<UnityEngine.MeshCollider>();

                // Its y axis towards the ball.
                holder.transform.rotation = new UnityEngine.Quaternion(-0.70710677f, 0f, 0f, 0.70710677f);
                break;
            default:
                UnityEngine.SphereCollider sphere = holder.Attach<UnityEngine.SphereCollider>();
                sphere.radius = 0.75f;
                collider = sphere;
                break;
        }

        holder.transform.position = new UnityVector(0.125f, 1f, 8f);
        bool moves = thing == "moving";
        if (moves)
        {
            UnityEngine.Rigidbody body = holder.Attach<UnityEngine.Rigidbody>();
            body.isKinematic = true;
            body.velocity = new UnityVector(0f, 0f, -4f);
        }

        UnityEngine.Physics.All.Add(collider);
        UnityBall ball = new UnityEngine.GameObject().Attach<UnityBall>();
        ball.Hits = 1;
        ball.gameObject.transform.position = new UnityVector(0f, 1f, 0f);
        ball.gameObject.Send("Awake");
        ball.Kick(new UnityVector(0.25f, 2f, 20f), new UnityVector(10f, 20f, 0f));
        BallEvent hit = default;
        for (int tick = 0; tick < 60 && hit.Time == 0; tick++)
        {
            holder.transform.position = new UnityVector(0.125f, 1f, moves ? 8f - (4f * tick * UnityEngine.Time.fixedDeltaTime) : 8f);
            ball.gameObject.Send("FixedUpdate");
            hit = FirstHit(ball.Runner, hit);
        }

        (BallEvent own, string name) = OnOwn(thing, ball.Runner);
        Assert.Equal(thing, ball.Runner.Simulator.NameOf(hit.ColliderIndex));
        Assert.Equal(thing, name);
        double near = thing is "plane" or "moving" ? 1e-5 : 1e-9;
        Assert.Equal(own.Time, hit.Time, near);
        Assert.Equal(0, (own.Velocity - hit.Velocity).Length, 1e3 * near);
    }

    [Theory]
    [MemberData(nameof(Things))]
    public void A_ball_bounces_off_Godots_body_at_the_same_instant_as_off_our_own_shape(string thing)
    {
        Godot.CollisionObject3D body = thing == "moving" ? new Godot.RigidBody3D { LinearVelocity = new GodotVector(0, 0, 4), Freeze = true } : new Godot.StaticBody3D();
        body.Name = thing;
        Godot.Shape3D shape = thing switch
        {
            "box" => new GodotBox { Size = new GodotVector(2, 2, 0.5f) },
            "capsule" => new Godot.CapsuleShape3D { Radius = 0.25f, Height = 2.5f },
            "plane" => new Godot.WorldBoundaryShape3D(),
            _ => new Godot.SphereShape3D { Radius = 0.75f },
        };

        // Of a plane the y axis towards the ball.
        var turned = new Godot.Basis(new GodotVector(1, 0, 0), new GodotVector(0, 0, 1), new GodotVector(0, -1, 0));
        body.Add(shape, new Godot.Transform3D(thing == "plane" ? turned : Godot.Basis.Identity, GodotVector.Zero));
        body.GlobalPosition = new GodotVector(0.125f, 1, -8);
        Godot.World3D.Only.DirectSpaceState.All.Add(body);
        Godot.Engine.PhysicsTicksPerSecond = 50;
        var ball = new GodotBall { HitMask = 1, GlobalPosition = new GodotVector(0, 1, 0) };
        ball._Ready();
        ball.KickWith(new GodotVector(0.25f, 2, -20), new GodotVector(-10, -20, 0));
        BallEvent hit = default;
        for (int tick = 0; tick < 60 && hit.Time == 0; tick++)
        {
            body.GlobalPosition = new GodotVector(0.125f, 1, thing == "moving" ? -8 + (4 * (float)ball.Runner.State.Time) : -8);
            ball._PhysicsProcess(0.02);
            hit = FirstHit(ball.Runner, hit);
        }

        (BallEvent own, string name) = OnOwn(thing, ball.Runner);
        Assert.Equal(thing, ball.Runner.Simulator.NameOf(hit.ColliderIndex));
        Assert.Equal(thing, name);
        double near = thing is "plane" or "moving" ? 1e-5 : 1e-9;
        Assert.Equal(own.Time, hit.Time, near);
        Assert.Equal(0, (own.Velocity - hit.Velocity).Length, 1e3 * near);
    }

    [Fact]
    public void A_ball_comes_to_rest_on_Unitys_mesh_and_on_Godots_plane()
    {
        var holder = new UnityEngine.GameObject { name = "mesh" };
        UnityEngine.Physics.All.Add(holder.Attach<UnityEngine.MeshCollider>());
        holder.transform.position = new UnityVector(0f, 1f, 0f);
        UnityBall unity = new UnityEngine.GameObject().Attach<UnityBall>();
        unity.Hits = 1;
        unity.gameObject.transform.position = new UnityVector(0f, 2f, 0f);
        unity.gameObject.Send("Awake");
        unity.Kick(new UnityVector(0f, 2f, 3f), UnityVector.zero);
        var body = new Godot.StaticBody3D { Name = "plane" };
        body.Add(new Godot.WorldBoundaryShape3D(), new Godot.Transform3D(Godot.Basis.Identity, new GodotVector(0, 1, 0)));
        Godot.World3D.Only.DirectSpaceState.All.Add(body);
        Godot.Engine.PhysicsTicksPerSecond = 50;
        var godot = new GodotBall { HitMask = 1, GlobalPosition = new GodotVector(0, 2, 0) };
        godot._Ready();
        godot.KickWith(new GodotVector(0, 2, -3), GodotVector.Zero);
        for (int tick = 0; tick < 1500; tick++)
        {
            unity.gameObject.Send("FixedUpdate");
            godot._PhysicsProcess(0.02);
        }

        Assert.Equal(MotionState.Rest, unity.Motion);
        Assert.Equal(MotionState.Rest, godot.Motion);
        Assert.Equal(1.11, unity.Runner.State.Position.Y, 1e-4);
        Assert.Equal(1.11, godot.Runner.State.Position.Y, 1e-4);
    }

    private static BallEvent FirstHit(FixedStepRunner runner, BallEvent before)
    {
        for (int i = 0; i < runner.Events.Count; i++)
        {
            BallEvent happened = runner.Events[i];
            if (before.Time == 0 && happened.Kind == BallEventKind.Impact && happened.ColliderIndex > 0)
            {
                return happened;
            }
        }

        return before;
    }

    /// <summary>The same kick at our own shape, in the library's frame.</summary>
    private static (BallEvent Hit, string Name) OnOwn(string thing, FixedStepRunner like)
    {
        var at = new Vector3d(0.125, 1, -8);
        IShape shape = thing switch
        {
            "box" => new BoxShape(at, new Vector3d(1, 1, 0.25)),
            "capsule" => new CapsuleShape(at - new Vector3d(0, 1, 0), at + new Vector3d(0, 1, 0), 0.25),
            "plane" => new PlaneShape(at, new Vector3d(0, 0, 1)),
            _ => new SphereShape(at, 0.75),
        };
        var obstacle = new Obstacle { Name = thing, Shape = shape, Velocity = thing == "moving" ? new Vector3d(0, 0, 4) : Vector3d.Zero };
        var runner = new FixedStepRunner(new Simulator(like.Simulator.Scene with { EngineColliders = null, Obstacles = [obstacle] }, like.Simulator.Settings), like.TimeStep);
        runner.Place(new Vector3d(0, 1, 0));
        runner.QueueKick(new Vector3d(0.25, 2, -20), new Vector3d(-10, -20, 0));
        BallEvent hit = default;
        for (int tick = 0; tick < 60 && hit.Time == 0; tick++)
        {
            runner.Step();
            hit = FirstHit(runner, hit);
        }

        return (hit, runner.Simulator.NameOf(hit.ColliderIndex)!);
    }
}
