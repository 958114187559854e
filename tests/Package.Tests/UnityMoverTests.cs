using FootballPhysics.Unity;
using UnityEngine;
using UnityEngine.SceneManagement;
using Vector3 = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>What moves in Unity without being a Rigidbody on the object of its collider: the ball leaves it as it leaves a body of the same motion.</summary>
[Collection(EngineTests.Statics)]
public sealed class UnityMoverTests : IDisposable
{
    private const float Step = 1f / 64f;

    public UnityMoverTests() => Dispose();

    public void Dispose()
    {
        GameObject.DestroyAll();
        UnityEngine.Physics.All.Clear();
        new PhysicsScene(1).All.Clear();
        Debug.Warned.Clear();
        Time.fixedDeltaTime = 0.02f;
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_character_controller_hits_the_ball_with_its_own_velocity_and_stands_upright(bool turned)
    {
        var player = new GameObject("player");
        CharacterController controller = player.Attach<CharacterController>();
        controller.radius = 0.25f;
        controller.height = 1.5f;
        controller.center = new Vector3(0f, 0.75f, 0f);
        controller.velocity = new Vector3(0f, 0f, 8f);
        player.transform.rotation = turned ? Quaternion.AngleAxis(90f, new Vector3(0f, 1f, 0f)) : Quaternion.identity;
        var shape = new CapsuleShape(new Vector3d(0, -0.5, 0), new Vector3d(0, 0.5, 0), 0.25);
        LeavesAsABody(
            controller, shape, new Vector3(0f, 0f, 0f), false,
            frame => player.transform.position = new Vector3(0.0625f, 0f, -2f + (0.125f * frame)),
            () => (new Vector3(0.0625f, 0.75f, player.transform.position.z), Quaternion.identity, controller.velocity, Vector3.zero));
    }

    [Fact]
    public void A_collider_below_a_Rigidbody_has_the_velocity_of_its_point()
    {
        var player = new GameObject("player");
        Rigidbody body = player.Attach<Rigidbody>();
        body.isKinematic = true;
        body.velocity = new Vector3(0f, 0f, 8f);
        body.angularVelocity = new Vector3(2f, 0f, 0f);
        body.centerOfMass = new Vector3(0f, 1f, 0f);
        var foot = new GameObject("foot");
        foot.transform.SetParent(player.transform);
        SphereCollider collider = foot.Attach<SphereCollider>();
        collider.radius = 0.125f;
        LeavesAsABody(
            collider, new SphereShape(default, 0.125), Vector3.zero, false,
            frame =>
            {
                player.transform.position = new Vector3(0f, 0f, -2f + (0.125f * frame));
                foot.transform.position = new Vector3(0.03125f, 0.125f, player.transform.position.z);
            },
            () => (foot.transform.position, Quaternion.identity, body.GetPointVelocity(foot.transform.position), body.angularVelocity));
    }

    [Fact]
    public void An_animated_collider_has_the_velocity_of_its_last_two_positions_by_option()
    {
        var bat = new GameObject("bat");
        BoxCollider collider = bat.Attach<BoxCollider>();
        collider.size = new Vector3(0.5f, 0.5f, 0.25f);
        LeavesAsABody(
            collider, new BoxShape(default, new Vector3d(0.25, 0.25, 0.125)), Vector3.zero, true,
            frame => bat.transform.position = new Vector3(0.0625f, 0.125f, -2f + (0.125f * frame)),
            () => (bat.transform.position, Quaternion.identity, new Vector3(0f, 0f, 8f), Vector3.zero));
    }

    [Fact]
    public void Without_the_option_it_is_a_wall_and_a_jump_has_no_velocity()
    {
        foreach ((bool option, float jump) in new[] { (false, 0f), (true, 6f) })
        {
            Dispose();
            var bat = new GameObject("bat");
            SphereCollider collider = bat.Attach<SphereCollider>();
            collider.radius = 0.25f;
            UnityEngine.Physics.All.Add(collider);
            FootballBall ball = NewBall(Vector3.zero);
            ball.VelocityFromMotion = option;
            Play(ball, 12, frame => bat.transform.position = new Vector3(0f, 0.11f, frame < 10 ? -6f + (jump > 0f ? 0f : 0.5625f * frame) : -0.34f));
            Assert.InRange(ball.Velocity.magnitude, 0f, 0.5f);
        }
    }

    [Fact]
    public void A_ball_hits_the_colliders_of_its_own_physics_scene_alone()
    {
        var other = new UnityEngine.SceneManagement.Scene { handle = 1 };
        SphereCollider here = Post("here", default);
        SphereCollider there = Post("there", other);
        FootballBall[] balls = [NewBall(Vector3.zero), NewBall(Vector3.zero, other)];
        var hit = new string[2];
        for (int i = 0; i < 2; i++)
        {
            int which = i;
            balls[i].Impact += (_, happened) => hit[which] ??= happened.Collider == null ? null! : happened.Surface;
            balls[i].Kick(new Vector3(0f, 1f, 20f), Vector3.zero);
            Play(balls[i], 30, _ => { });
        }

        Assert.Equal(["here", "there"], hit);
        Assert.True(Netcode.Snapshot.Same(balls[0].Runner.State, balls[1].Runner.State));

        // Layers count: a mask without the collider's layer sees nothing.
        there.gameObject.layer = 3;
        here.gameObject.layer = 3;
        FootballBall free = NewBall(Vector3.zero);
        free.Kick(new Vector3(0f, 1f, 20f), Vector3.zero);
        Play(free, 30, _ => { });
        Assert.True(free.Velocity.z > 0f);
    }

    [Fact]
    public void Destroyed_colliders_are_released()
    {
        FootballBall ball = NewBall(Vector3.zero);
        var known = new List<WeakReference>();
        for (int i = 0; i < 20; i++)
        {
            known.Add(Meet(ball));
        }

        Post("last", default);
        Play(ball, 1, _ => { });
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        Assert.InRange(known.Count(reference => reference.IsAlive), 0, 2);
    }

    [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
    private static WeakReference Meet(FootballBall ball)
    {
        SphereCollider cone = Post("cone", default);
        cone.transform.position = new Vector3(0f, 0.3f, 0.45f);
        ball.Place(Vector3.zero);
        ball.Kick(new Vector3(0f, 0.5f, 6f), Vector3.zero);
        Play(ball, 4, _ => { });
        UnityEngine.Physics.All.Remove(cone);
        UnityEngine.Object.DestroyImmediate(cone.gameObject);
        return new WeakReference(cone);
    }

    private static SphereCollider Post(string name, UnityEngine.SceneManagement.Scene scene)
    {
        var holder = new GameObject(name);
        SceneManager.MoveGameObjectToScene(holder, scene);
        SphereCollider collider = holder.Attach<SphereCollider>();
        collider.radius = 0.3f;
        holder.transform.position = new Vector3(0f, 0.4f, 5f);
        scene.GetPhysicsScene().All.Add(collider);
        return collider;
    }

    private static FootballBall NewBall(Vector3 place, UnityEngine.SceneManagement.Scene scene = default)
    {
        Time.fixedDeltaTime = Step;
        var holder = new GameObject("ball");
        SceneManager.MoveGameObjectToScene(holder, scene);
        holder.transform.position = place;
        FootballBall ball = holder.Attach<FootballBall>();
        ball.Preset = new FootballPreset { timeStep = Step };
        ball.Hits = 1;
        holder.WakeUp();
        return ball;
    }

    private static void Play(FootballBall ball, int frames, Action<int> move)
    {
        for (int i = 0; i < frames; i++)
        {
            move(i);
            ball.gameObject.Send("FixedUpdate");
        }
    }

    /// <summary>Plays the collider into a ball at rest, and a body of the library with the same motion into another.</summary>
    private static void LeavesAsABody(
        Collider collider, IShape shape, Vector3 place, bool option, Action<int> move, Func<(Vector3 Place, Quaternion Turned, Vector3 Velocity, Vector3 Spin)> motion)
    {
        UnityEngine.Physics.All.Add(collider);
        FootballBall ball = NewBall(place);
        ball.VelocityFromMotion = option;
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("body", shape, SurfaceMaterial.GoalFrame);
        var runner = new FixedStepRunner(new Simulator(ball.Runner.Simulator.Scene with { EngineColliders = null, Bodies = bodies }, ball.Runner.Simulator.Settings), Step);
        runner.Place(UnityFrame.FromUnity(place));
        int hits = 0;
        for (int frame = 0; frame < 40; frame++)
        {
            move(frame);
            (Vector3 at, Quaternion turned, Vector3 velocity, Vector3 spin) = motion();
            body.MoveTo(UnityFrame.FromUnity(at), UnityFrame.FromUnity(turned), UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin), runner.State.Time);
            ball.gameObject.Send("FixedUpdate");
            runner.Step();
            foreach (BallEvent happened in runner.Events)
            {
                hits += happened.Kind == BallEventKind.Impact && happened.ColliderIndex > 0 ? 1 : 0;
            }

            Assert.InRange((runner.State.Velocity - ball.Runner.State.Velocity).Length, 0, 1e-9);
            Assert.InRange((runner.State.Spin - ball.Runner.State.Spin).Length, 0, 1e-8);
        }

        Assert.True(hits > 0 && ball.Velocity.z > 4f, $"{hits} impacts, {ball.Velocity.z} m/s");
    }
}
