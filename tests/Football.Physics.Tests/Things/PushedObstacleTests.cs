using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>What an impact pushed is met where it has got to, by a ball that was far from everything.</summary>
public sealed class PushedObstacleTests
{
    [Theory]
    [ProfileData]
    public void A_thing_that_was_pushed_into_the_way_is_met_and_one_that_was_pushed_out_of_it_is_not(Profile profile)
    {
        Scene scene = profile.Scene() with
        {
            Obstacles =
            [
                new Obstacle { Name = "pole", Shape = new SphereShape(new Vector3d(12, 1.2, 10), 1), Mass = 20, Pivot = new Vector3d(12, 1.2, 10) },
                new Obstacle { Name = "far", Shape = new SphereShape(new Vector3d(16, 1, 0), 1), Mass = 20, Pivot = new Vector3d(16, 1, 0) },
            ],
        };
        var velocity = new Vector3d(25, 2, 0);
        Assert.Equal(["far"], Met(_ => { }));

        // The one that is beside the way is pushed into it before the ball is there; the other one out of it.
        Assert.Contains("pole", Met(world => Push(world, 1, new Vector3d(0, 0, -20))));
        Assert.Empty(Met(world => Push(world, 2, new Vector3d(0, 0, 20))));

        string[] Met(Action<World> push)
        {
            var simulator = new Simulator(scene);
            BallState ball = simulator.Launch(new Vector3d(0, 1.5, 0), velocity, Vector3d.Zero);
            var log = new StepLog();

            // Some steps far from everything, so that it is known for how long the way is free.
            for (int i = 0; i < 5; i++)
            {
                simulator.Step(ref ball, 0.01, log);
            }

            push(simulator.World!);
            for (int i = 0; i < 200; i++)
            {
                simulator.Step(ref ball, 0.01, log);
            }

            return [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Impact).Select(item => simulator.NameOf(item.ColliderIndex) ?? "").Where(name => name != "ground").Distinct()];
        }

        static void Push(World world, int collider, Vector3d to) => world.Colliders[collider].Push(20 * to, 0.05);
    }
}
