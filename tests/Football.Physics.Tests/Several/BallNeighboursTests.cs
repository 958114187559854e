using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Which balls are neighbours, against all pairs; and how long their spheres are good for.</summary>
public sealed class BallNeighboursTests
{
    private const double Dt = 0.01;

    /// <summary>Of a resting ball the sphere has room for a quarter of a meter and for a fall of sixteen steps: 0.25 + ½ · 10 · 0.16².</summary>
    private const double RoomAtRest = 0.25 + 0.128;

    private static readonly Simulator Nowhere = new(Scene.Default with { Ground = Ground.None });

    [Fact]
    public void Neighbours_are_all_whose_spheres_touch_and_no_others()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            int count = 2 + (seed * 2);
            double[] radii = [.. Enumerable.Range(0, count).Select(_ => 0.05 + (0.3 * random.NextDouble()))];
            var neighbours = new BallNeighbours(radii);
            for (int round = 0; round < 3; round++)
            {
                BallState[] balls = [.. radii.Select(_ => At(new Vector3d(6 * random.NextDouble(), 3 * random.NextDouble(), 3 * random.NextDouble()), new Vector3d(random.Next(4) * random.NextDouble(), 0, 0)))];
                neighbours.Renew(balls, new double[count], Dt);
                List<(int, int)> expected = [];
                for (int i = 0; i < count; i++)
                {
                    for (int j = i + 1; j < count; j++)
                    {
                        double reach = radii[i] + radii[j] + (2 * RoomAtRest) + (0.16 * (balls[i].Velocity.Length + balls[j].Velocity.Length));
                        if ((balls[i].Position - balls[j].Position).Length <= reach)
                        {
                            expected.Add((i, j));
                        }
                    }
                }

                Assert.Equal(expected, Enumerable.Range(0, neighbours.Count).Select(k => neighbours[k]).Order());
            }
        }
    }

    [Fact]
    public void Spheres_that_just_touch_are_neighbours()
    {
        foreach ((double apart, int count) in new[] { (2 * RoomAtRest + 0.4 - 1e-9, 1), (2 * RoomAtRest + 0.4 + 1e-9, 0) })
        {
            foreach (Vector3d way in new[] { new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0), new Vector3d(0, 0, 1), new Vector3d(0, -1, 0), new Vector3d(0.6, 0, 0.8) })
            {
                var neighbours = new BallNeighbours([0.1, 0.3]);
                neighbours.Renew([At(new Vector3d(1, 2, 3), default), At(new Vector3d(1, 2, 3) + (apart * way), default)], [0, 0], Dt);
                Assert.Equal(count, neighbours.Count);
            }
        }
    }

    /// <summary>The speed a sphere is made for: that of the ball, a fall of sixteen steps, and a quarter of a meter in their time; with a tenth more it gets so far in a step.</summary>
    [Fact]
    public void A_sphere_holds_up_to_the_speed_the_room_and_the_step_that_it_is_made_for()
    {
        const double Speed = 3;
        const double Fastest = Speed + 1.6 + (0.25 / 0.16);
        const double Reach = 1.1 * Fastest * Dt;
        const double Room = RoomAtRest + (Speed * 0.16);
        var neighbours = new BallNeighbours([0.1]);
        BallState ball = At(new Vector3d(1, 2, 3), new Vector3d(0, Speed, 0));
        neighbours.Renew([ball], [0], Dt);
        Assert.Equal(Reach, neighbours.ReachOf(0), 1e-14);
        Assert.True(neighbours.Allows(0, Fastest * Fastest * (1 - 1e-9)));
        Assert.False(neighbours.Allows(0, Fastest * Fastest * (1 + 1e-9)));
        Assert.True(Holds(ball, ball));
        Assert.False(neighbours.Holds(0, in ball, in ball, Dt * 1.0001));
        Assert.True(neighbours.Holds(0, in ball, in ball, Dt / 2));
        foreach (Vector3d way in new[] { new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1), new Vector3d(-1, 0, 0), new Vector3d(0, -1, 0), new Vector3d(0, 0, -1), new Vector3d(0.6, -0.8, 0), new Vector3d(0.6, 0, 0.8), new Vector3d(0, -0.6, 0.8) })
        {
            foreach ((double share, bool holds) in new[] { (1 - 1e-9, true), (1 + 1e-9, false) })
            {
                BallState far = At(ball.Position + (share * (Room - Reach) * way), default);
                Assert.Equal(holds, Holds(far, far));
                BallState gone = At(ball.Position + (share * Reach * way), default);
                Assert.Equal(holds, Holds(ball, gone));
                BallState fast = At(ball.Position, share * Fastest * way);
                Assert.Equal(holds, Holds(fast, ball));
                Assert.Equal(holds, Holds(ball, fast));
                BallState reaching = At(ball.Position + (0.25 * way), default);
                Assert.Equal(holds, neighbours.Holds(0, in reaching, share * (Room - 0.25), Dt));
            }
        }

        Assert.True(neighbours.Holds(0, in ball, 0.1, Dt));
        Assert.False(neighbours.Holds(0, in ball, 0.1, 1.0001 * Dt));
        BallState net = ball;
        net.Nets = 1;
        Assert.False(Holds(net, ball));
        Assert.False(Holds(ball, net));
        BallState squeezed = ball;
        squeezed.Motion = MotionState.Pinned;
        Assert.False(Holds(squeezed, ball));

        bool Holds(BallState before, BallState after) => neighbours.Holds(0, in before, in after, Dt);
    }

    /// <summary>A ball that has got farther in its step than its speed says has a sphere for that.</summary>
    [Fact]
    public void A_reach_that_was_measured_counts_where_it_is_larger()
    {
        var neighbours = new BallNeighbours([0.1, 0.1]);
        BallState[] balls = [At(default, default), At(new Vector3d(5.0, 0, 0), default)];
        neighbours.Renew(balls, [0.2, 0], Dt);
        Assert.Equal(0.2, neighbours.ReachOf(0));
        Assert.Equal(0, neighbours.Count);
        neighbours.Renew(balls, [5.0 - 0.2 - RoomAtRest - 1e-9, 0], Dt);
        Assert.Equal(0, neighbours.Count);
        neighbours.Renew(balls, [5.0 - 0.2 - RoomAtRest + 1e-9, 0], Dt);
        Assert.Equal(1, neighbours.Count);
        Assert.True(neighbours.Holds(0, in balls[0], 4.4, Dt));
    }

    private static BallState At(Vector3d place, Vector3d velocity) => Nowhere.Launch(place, velocity, default);
}
