using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>How nets bulge, for drawing.</summary>
public sealed class NetBulgeTests
{
    private static Scene Goal(Profile profile) => profile.Scene() with { Goals = [new Goal { Center = new Vector3d(0, 0, -10), Facing = new Vector3d(0, 0, 1) }] };

    [Theory]
    [ProfileData]
    public void A_net_bulges_as_deep_as_the_ball_is_in_it_and_comes_back_at_its_own_speed(Profile profile)
    {
        var simulator = new Simulator(Goal(profile), Flight.With(Integrator.Rk4));
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 2, -25), Vector3d.Zero);
        var bulges = new NetBulges(simulator);
        var log = new StepLog();
        Assert.Equal(4, bulges.Count);
        Assert.Equal("back net", bulges.NameOf(0));
        double before = 0;
        double deepest = 0;
        double largestFall = 0;
        for (int i = 0; i < 1500; i++)
        {
            simulator.Step(ref state, 0.002, log);
            bulges.Follow(in state);
            NetBulge back = bulges[0];

            // Never less than the ball is deep, and the point lies as far behind the plane.
            Assert.True(back.Depth >= 0);
            Assert.True(back.Depth == 0 || back.Direction.Z < 0);
            largestFall = Math.Max(largestFall, before - back.Depth);
            deepest = Math.Max(deepest, back.Depth);
            before = back.Depth;
        }

        Assert.InRange(deepest, 0.1, 1.5);
        Assert.InRange(largestFall, 0.5 * 0.002 / 1.5, (1.0001 * 0.002 / 1.5) + 1e-12);
        Assert.Equal(0, bulges[0].Depth);
    }

    [Theory]
    [ProfileData]
    public void The_ball_lies_in_the_bulge(Profile profile)
    {
        var simulator = new Simulator(Goal(profile), Flight.With(Integrator.Rk4));
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 2, -25), Vector3d.Zero);
        var bulges = new NetBulges(simulator);
        var log = new StepLog();
        simulator.Run(ref state, 0.002, 0.5, StopAt.Time, log);
        bulges.Follow(in state);
        Assert.True(bulges[0].Depth > 0.1, $"{bulges[0].Depth}");
        Assert.Equal(Flight.Radius, (bulges[0].Position - state.Position).Length, 1e-12);

        // Back in time, before the net was met, it hangs still.
        bulges.Follow(simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 2, -25), Vector3d.Zero));
        Assert.Equal(0, bulges[0].Depth);
    }

    [Theory]
    [ProfileData]
    public void A_scene_without_nets_has_no_bulges(Profile profile) => Assert.Equal(0, new NetBulges(new Simulator(profile.Scene())).Count);
}
