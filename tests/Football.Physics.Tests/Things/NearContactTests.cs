using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>What is found near a ball, and what a ball is put out of.</summary>
public sealed class NearContactTests
{
    private const double Radius = 0.11;

    [Theory]
    [InlineData(5)]
    [InlineData(8)]
    [InlineData(14)]
    [InlineData(30)]
    public void All_that_are_near_are_found_in_the_order_of_the_scene(int count)
    {
        var random = new Random(count);
        for (int i = 0; i < 60; i++)
        {
            World world = ContactScenes.WorldOf(random, count, moves: false, resists: false, 0.08, out BallState state);
            double reach = 0.02 + (0.05 * random.NextDouble());
            double[] gaps = [.. world.Colliders.Select(collider => collider.At(state.Position).Distance - Radius)];
            int[] expected = [.. Enumerable.Range(0, gaps.Length).Where(k => gaps[k] <= reach)];
            Span<Contact> set = ContactSet.Near(world, in state, reach, new Contact[ContactSet.Room], world.Room);
            Assert.Equal(expected, set.ToArray().Select(contact => contact.Collider));
            foreach (Contact contact in set)
            {
                Assert.Equal(gaps[contact.Collider], contact.Gap);
            }
        }
    }

    [Fact]
    public void Of_flat_things_side_by_side_one_stands_for_all()
    {
        static Obstacle Board(string name, double x, double back) =>
            new() { Name = name, Shape = new BoxShape(new Vector3d(x, 0.5, -0.05 - Radius - back), new Vector3d(0.5, 0.5, 0.05)), Surface = SurfaceMaterial.Board };

        // Three in a row, of which one stands back a little; and one behind the ball.
        Scene scene = new()
        {
            Ball = new BallProperties { Radius = Radius },
            Obstacles = [Board("left", -0.5, 1e-4), Board("middle", 0.0, 0), Board("right", 0.5, 0), new Obstacle { Name = "behind", Shape = new BoxShape(new Vector3d(0, 0.5, 0.05 + Radius), new Vector3d(2, 0.5, 0.05)) }],
        };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 0.4, 0), Vector3d.Zero, Vector3d.Zero);
        World world = simulator.World!;
        Span<Contact> set = ContactSet.Near(world, in state, 0.01, new Contact[ContactSet.Room], world.Room);
        Assert.Equal(["middle", "behind"], set.ToArray().Select(contact => world.Colliders[contact.Collider].Name));
    }

    /// <summary>Out of one thing along its normal, and nothing else changes; at the height at which it was, though the ground is near.</summary>
    [Theory]
    [ProfileData]
    public void Out_of_a_board_it_is_put_straight(Profile profile)
    {
        double r = profile.Scene().Ball.Radius;
        Scene scene = profile.Scene() with { Obstacles = [new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.5, -0.05 - r), new Vector3d(3, 0.5, 0.05)) }] };
        var simulator = new Simulator(scene);
        World world = simulator.World!;
        foreach (double above in new[] { 0.0, 0.004, 0.4 })
        {
            BallState state = simulator.Launch(new Vector3d(0.3, r + above, 0), new Vector3d(1, 2, -3), Vector3d.Zero);
            state.Position -= new Vector3d(0, 0, 0.002);
            ContactSet.Separate(world, ref state);
            Assert.Equal(0.3, state.Position.X);
            Assert.Equal(r + above, state.Position.Y, 1e-15);
            Assert.Equal(0, state.Position.Z, 1e-15);
            Assert.Equal(new Vector3d(1, 2, 0), state.Velocity);
        }

        // What overlaps nothing is left alone.
        BallState free = simulator.Launch(new Vector3d(0.3, r + 0.004, 0.001), new Vector3d(1, -2, -3), Vector3d.Zero);
        BallState same = free;
        ContactSet.Separate(world, ref same);
        Assert.Equal((free.Position, free.Velocity), (same.Position, same.Velocity));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Out_of_several_it_is_put_out_of_all(int count)
    {
        var random = new Random(count);
        for (int i = 0; i < 200; i++)
        {
            World world = ContactScenes.WorldOf(random, count, moves: false, resists: false, 0, out BallState state);
            BallState before = state;
            state.Position += 0.004 * new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            double deepest = world.Colliders.Max(collider => Radius - collider.At(state.Position).Distance);
            Vector3d from = state.Position;
            ContactSet.Separate(world, ref state);
            double left = world.Colliders.Max(collider => Radius - collider.At(state.Position).Distance);
            Assert.InRange(left, double.NegativeInfinity, count == 1 ? 1e-12 : 1e-4);
            Assert.True(deepest > 0 || state.Position == from);
            Assert.InRange((state.Position - from).Length, count == 1 ? Math.Max(0, deepest - 1e-12) : 0, count == 1 ? Math.Max(0, deepest) + 1e-12 : 0.05);

            // Of its velocity is taken what goes into what it was put out of, and nothing is given.
            Assert.InRange(state.Velocity.Length, 0, before.Velocity.Length * (1 + 1e-9));
        }
    }

    [Fact]
    public void The_deepest_overlap_is_told_the_first_of_the_scene_where_two_are_as_deep()
    {
        var random = new Random(5);
        for (int i = 0; i < 100; i++)
        {
            World world = ContactScenes.WorldOf(random, 4, moves: false, resists: false, 0.01, out BallState state);
            state.Position += 0.01 * new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            double[] depths = [.. world.Colliders.Select(collider => Radius - collider.At(state.Position).Distance)];
            int expected = depths.Max() > 1e-10 ? Array.IndexOf(depths, depths.Max()) : -1;
            Assert.Equal(expected, NearThings.Deepest(world, in state, out bool body));
            Assert.False(body);
        }

        // Twins at one place.
        var sphere = new SphereShape(new Vector3d(0, 5, 0), 0.5);
        var simulator = new Simulator(new Scene { Obstacles = [new Obstacle { Name = "far", Shape = new SphereShape(new Vector3d(9, 5, 0), 0.5) }, new Obstacle { Name = "one", Shape = sphere }, new Obstacle { Name = "two", Shape = sphere }, new Obstacle { Name = "three", Shape = sphere }] });
        BallState at = simulator.Launch(new Vector3d(0.3, 5.7, 0), Vector3d.Zero, Vector3d.Zero);
        at.Position = new Vector3d(0.2, 5.5, 0);
        Assert.Equal("one", simulator.World!.Colliders[NearThings.Deepest(simulator.World!, in at, out _)].Name);
    }
}
