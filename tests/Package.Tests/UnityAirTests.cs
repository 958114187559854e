using FootballPhysics.Unity;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>A Rigidbody of Unity with the air of a football, played against the shims.</summary>
[Collection(EngineTests.Statics)]
public sealed class UnityAirTests : IDisposable
{
    public UnityAirTests() => Dispose();

    public void Dispose()
    {
        GameObject.DestroyAll();
        Debug.Warned.Clear();
        Time.fixedDeltaTime = 0.02f;
    }

    [Theory]
    [InlineData(1f / 240f, 1e-3)]
    [InlineData(0.02f, 5e-3)]
    public void A_kicked_body_flies_as_the_librarys_ball(float step, double near)
    {
        Time.fixedDeltaTime = step;
        FootballAir air = NewBody();
        Rigidbody body = air.GetComponent<Rigidbody>();
        body.mass = 1f;
        air.Kick(26f, new Vector3(0.1f, 0.3f, 1f), -15f, 45f);
        BallState ball = Library(null, 26, new Vector3(0.1f, 0.3f, 1f), -15, 45);
        var simulator = new Simulator(new Scene { Ground = Ground.None });
        int steps = (int)Math.Round(1.2 / step);
        for (int i = 0; i < steps; i++)
        {
            air.gameObject.Send("FixedUpdate");
            body.Simulate(step);
            simulator.Step(ref ball, step, new StepLog());
        }

        Vector3 expected = UnityFrame.ToUnity(ball.Position);
        Assert.InRange((air.transform.position - expected).magnitude, 0, near);
        Assert.InRange((body.angularVelocity - UnityFrame.SpinToUnity(ball.Spin)).magnitude, 0, 0.05);

        // It bends to the left, which is towards −x, by metres.
        Assert.True(expected.x < (0.1f * expected.z) - 1f);
    }

    [Fact]
    public void Damping_is_switched_off_and_a_spin_of_a_kick_is_possible()
    {
        Rigidbody body = NewBody().GetComponent<Rigidbody>();
        Assert.Equal((0f, 0f, 200f), (body.drag, body.angularDrag, body.maxAngularVelocity));
    }

    [Fact]
    public void A_preset_counts_from_the_next_step_on_and_one_out_of_range_is_reported_once()
    {
        FootballAir air = NewBody();
        Rigidbody body = air.GetComponent<Rigidbody>();
        air.Buoyancy = false;
        body.useGravity = false;
        body.velocity = new Vector3(0f, 0f, 20f);
        air.Preset = new FootballPreset { laws = FootballPreset.AirChoice.Vacuum };
        Step();
        Assert.Equal(20f, body.velocity.z);
        air.Preset.laws = FootballPreset.AirChoice.Measured;
        Step();
        Assert.InRange(body.velocity.z, 19.7f, 19.97f);
        air.Preset.airDensity = -5f;
        Step();
        Step();
        Assert.Contains("air.density is -5", Assert.Single(Debug.Warned));
        Assert.InRange(body.velocity.z, 19f, 19.9f);

        void Step()
        {
            air.gameObject.Send("FixedUpdate");
            body.Simulate(Time.fixedDeltaTime);
        }
    }

    [Fact]
    public void Bodies_that_sleep_or_are_kinematic_get_no_force()
    {
        FootballAir air = NewBody();
        Rigidbody body = air.GetComponent<Rigidbody>();
        body.useGravity = false;
        body.velocity = new Vector3(0f, 0f, 20f);
        body.Sleeps = true;
        air.gameObject.Send("FixedUpdate");
        body.Sleeps = false;
        body.isKinematic = true;
        air.gameObject.Send("FixedUpdate");
        body.isKinematic = false;
        body.Simulate(0.02f);
        Assert.Equal(20f, body.velocity.z);
    }

    [Fact]
    public void The_sample_makes_a_ball_and_kicks_it_to_alternate_sides()
    {
        Time.fixedTimeAsDouble = 0;
        FootballSamples.CurlARigidbody sample = new GameObject("sample").AddComponent<FootballSamples.CurlARigidbody>();
        GameObject ball = GameObject.All.Single(item => item.name == "Ball");
        Rigidbody body = ball.GetComponent<Rigidbody>();
        var sides = new List<float>();
        for (int i = 1; i <= 300; i++)
        {
            sample.gameObject.Send("FixedUpdate");
            ball.Send("FixedUpdate");
            body.Simulate(0.02f);
            Time.fixedTimeAsDouble = 0.02 * i;
            if (i % 150 == 60)
            {
                sides.Add(ball.transform.position.x);
            }
        }

        Time.fixedTimeAsDouble = 0;
        Assert.InRange(sides[0], -8f, -1f);
        Assert.Equal(-sides[0], sides[1], 1e-3f);
    }

    private static FootballAir NewBody() => new GameObject("body").AddComponent<FootballAir>();

    private static BallState Library(Scene? scene, float speed, Vector3 direction, float topSpin, float sideSpin)
    {
        Vector3d forward = UnityFrame.FromUnity(direction);
        return new Simulator(scene ?? new Scene { Ground = Ground.None }).Launch(
            Vector3d.Zero, UnityFrame.FromUnity(direction * (speed / direction.magnitude)), KickVectors.Spin(forward, topSpin, sideSpin));
    }
}
