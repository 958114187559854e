using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>The order of the integrator survives impacts with round things, both ends of a net, and curved ground.</summary>
public sealed class WorldOrderTests
{
    private static Scene Post(Profile profile) => profile.Scene() with
    {
        Obstacles = [new Obstacle { Shape = new CapsuleShape(new Vector3d(0, 0, -10), new Vector3d(0, 2.5, -10), 0.06) }],
        Forces = profile.SmoothForces(),
    };

    private static Scene Netted(Profile profile) => profile.Scene() with
    {
        Nets = [new Net { Center = new Vector3d(0, 1.25, -10), Normal = new Vector3d(0, 0, 1), Along = new Vector3d(1, 0, 0), HalfLength = 3, HalfWidth = 1.25, Stiffness = 60, Damping = 0.3, TangentialDamping = 5, SpinDamping = 0.002 }],
        Forces = profile.SmoothForces(),
    };

    private static Scene Bowl(Profile profile) => profile.Scene() with
    {
        Ground = profile.Ground() with { Heights = HeightField.FromControlValues(-10, -10, 5, new double[,] { { 2, 1.5, 1, 1.5, 2 }, { 1.5, 0.5, 0.3, 0.5, 1.5 }, { 1, 0.3, 0, 0.3, 1 }, { 1.5, 0.5, 0.3, 0.5, 1.5 }, { 2, 1.5, 1, 1.5, 2 } }) },
        Forces = profile.SmoothForces(),
    };

    [Theory]
    [ProfileData(Integrator.Rk2, 1.8, 2.6)]
    [ProfileData(Integrator.Rk4, 3.6, 5.2)]
    public void Through_a_round_post(Profile profile, Integrator integrator, double low, double high) =>
        Hold("post", Post(profile), integrator, 0.9, new Vector3d(-0.05, 0.5, 0), new Vector3d(0.12, 4, -20), low, high);

    [Theory]
    [ProfileData(Integrator.Rk2, 1e-3)]
    [ProfileData(Integrator.Rk4, 1e-6)]
    public void Through_both_ends_of_a_net_a_step_of_10_ms_is_close(Profile profile, Integrator integrator, double bound)
    {
        // In a net a step is divided, so that the error hardly depends on its length.
        var position = new Vector3d(0.3, 1, -9.2);
        var velocity = new Vector3d(1, 2, -6);
        Vector3d exact = End(Netted(profile), Integrator.Rk4, 1.0 / 8192, 1.0, position, velocity);
        Assert.InRange(Vector3d.Distance(End(Netted(profile), integrator, 0.01, 1.0, position, velocity), exact), 0, bound);
    }

    [Theory]
    [ProfileData(Integrator.Rk2, 1.8, 2.6)]
    [ProfileData(Integrator.Rk4, 3.6, 5.2)]
    public void Into_a_net_and_out_of_it_again(Profile profile, Integrator integrator, double low, double high)
    {
        // So soft that no step is divided in it.
        Scene soft = Netted(profile) with { Ground = Ground.None, Nets = [Netted(profile).Nets[0] with { Give = 1e6, Stiffness = 4, Damping = 0.05, TangentialDamping = 0.2, SpinDamping = 2e-4 }] };
        Hold("soft net", soft, integrator, 2.5, new Vector3d(0.3, 1.2, -9.2), new Vector3d(0.5, 1, -6), low, high, steps: 640, halvings: 2);
    }

    [Theory]
    [ProfileData(Integrator.Rk2, 1.7, 2.8)]
    [ProfileData(Integrator.Rk4, 3.4, 5.5)]
    public void On_curved_ground(Profile profile, Integrator integrator, double low, double high) =>
        Hold("bowl", Bowl(profile), integrator, 0.6, new Vector3d(4, 3, 1), new Vector3d(0, 0, 0), low, high);

    private static void Hold(
        string what, Scene scene, Integrator integrator, double duration, Vector3d position, Vector3d velocity, double low, double high, int steps = 32, int halvings = 3)
    {
        Vector3d exact = End(scene, Integrator.Rk4, duration / Math.Max(4096, 16 * steps), duration, position, velocity);
        double observed = Order.Observed(duration / steps, halvings, h => Vector3d.Distance(End(scene, integrator, h, duration, position, velocity), exact) + 1e-15);
        Order.Hold($"{what} {integrator}", [observed], low, high);
    }

    private static Vector3d End(Scene scene, Integrator integrator, double h, double duration, Vector3d position, Vector3d velocity)
    {
        BallState end = Flight.Play(scene, Flight.With(integrator), h, duration, StopAt.Time, position, velocity, new Vector3d(3, 20, -10), out _);
        return end.Position;
    }
}
