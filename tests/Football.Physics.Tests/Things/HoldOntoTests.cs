using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>A ball is put onto its loaded contacts and out of the others, and loses its velocity into them.</summary>
public sealed class HoldOntoTests
{
    private const double Radius = 0.11;

    private static readonly Vector3d s_place = new(0.2, 0.4, -0.3);

    /// <summary>However small the angle between two normals, the ball gets onto both surfaces, and no farther along them than it must.</summary>
    [Theory]
    [InlineData(2, false)]
    [InlineData(10, false)]
    [InlineData(10, true)]
    [InlineData(60, true)]
    [InlineData(120, false)]
    [InlineData(160, true)]
    public void A_ball_gets_onto_two_loaded_contacts_at_any_angle(double degrees, bool curved)
    {
        double half = 0.5 * degrees * Math.PI / 180;
        Vector3d[] normals = [new(Math.Sin(half), Math.Cos(half), 0), new(-Math.Sin(half), Math.Cos(half), 0)];
        World world = WorldOf(normals, curved);
        Contact[] set = SetOf(world, 1, 1);
        foreach (Vector3d off in new Vector3d[] { new(0, 2e-6, 0), new(0, -2e-6, 0), new(1e-6, 1e-7, 0), new(0, 0, 0) })
        {
            BallState state = new() { Position = s_place + off, Velocity = new Vector3d(0, 0, 2) };
            ContactSet.Hold(world, ref state, set);
            foreach (Collider collider in world.Colliders)
            {
                ShapePoint at = collider.At(state.Position, 0);
                Assert.InRange(at.Distance - Radius, -2e-12, 2e-12);
                Assert.Equal(0, Vector3d.Dot(state.Velocity, at.Normal), 1e-7);
            }

            // In the plane of the normals there is one such place.
            Assert.InRange((state.Position - s_place).Horizontal.Length, 0, 1e-9);
            Assert.Equal(2, state.Velocity.Z, curved ? 1e-5 : 1e-12);
        }
    }

    [Fact]
    public void A_ball_gets_onto_three_loaded_contacts()
    {
        Vector3d[] normals = [new Vector3d(0.5, 1, 0).Normalized(), new Vector3d(-0.4, 1, 0.5).Normalized(), new Vector3d(0.1, 1, -0.7).Normalized()];
        World world = WorldOf(normals, curved: true);
        foreach (double up in new[] { 3e-6, -3e-6 })
        {
            Contact[] set = SetOf(world, 3, 2, 1);
            BallState state = new() { Position = s_place + new Vector3d(0, up, 0), Velocity = new Vector3d(0.3, -0.2, 2) };
            ContactSet.Hold(world, ref state, set);
            Assert.All(world.Colliders.ToArray(), collider => Assert.InRange(collider.At(state.Position, 0).Distance - Radius, -1e-11, 1e-11));
        }
    }

    /// <summary>A contact without load only keeps the ball out, and takes only the velocity into it.</summary>
    [Fact]
    public void A_contact_without_load_only_keeps_the_ball_out()
    {
        Vector3d[] normals = [Vector3d.Up, new(1, 0, 0)];
        World world = WorldOf(normals, curved: false);
        Contact[] set = SetOf(world, 1, 0);
        BallState state = new() { Position = s_place + new Vector3d(2e-6, 1e-6, 0), Velocity = new Vector3d(0.5, -1, 2) };
        ContactSet.Hold(world, ref state, set);
        Assert.Equal(new Vector3d(2e-6, 0, 0).X, (state.Position - s_place).X, 1e-12);
        Assert.Equal(0, (state.Position - s_place).Y, 1e-12);
        Assert.Equal(new Vector3d(0.5, 0, 2), state.Velocity);

        state = new() { Position = s_place + new Vector3d(-2e-6, -1e-6, 0), Velocity = new Vector3d(-0.5, 1, 2) };
        ContactSet.Hold(world, ref state, set);
        Assert.InRange((state.Position - s_place).Length, 0, 2e-12);
        Assert.Equal(new Vector3d(0, 0, 2), state.Velocity);
    }

    /// <summary>A loaded contact with a gap, as of a player who has just left the ball, closes once; what stands still then keeps the ball out.</summary>
    [Fact]
    public void A_loaded_contact_with_a_gap_closes()
    {
        World world = WorldOf([new(1, 0, 0)], curved: true);
        BallState off = new() { Position = s_place + new Vector3d(1e-5, 0, 0) };
        Span<Contact> set = ContactSet.Near(world, in off, 1e-4, new Contact[ContactSet.Room], world.Room);
        Assert.False(set[0].Touches);
        set[0].Load = 1;
        ContactSet.Hold(world, ref off, set);
        Assert.InRange((off.Position - s_place).Length, 0, 1e-11);
    }

    [Fact]
    public void Out_of_what_stands_still_there_is_a_way_unless_it_is_too_narrow()
    {
        World corner = WorldOf([Vector3d.Up, new(1, 0, 0), new Vector3d(0.3, 0.2, 1).Normalized()], curved: false);
        BallState state = new() { Position = s_place + new Vector3d(-0.01, -0.02, -0.03) };
        Assert.True(ContactSet.KeepOut(corner, ref state, SetOf(corner, 0, 0, 0)));
        Assert.All(corner.Colliders.ToArray(), collider => Assert.True(collider.At(state.Position, 0).Distance - Radius >= -1e-11));

        // Two walls that leave 1 mm less than the ball needs.
        World slot = WorldOf([new(1, 0, 0), new(-1, 0, 0)], curved: false, closer: 0.0005);
        state = new() { Position = s_place };
        Assert.False(ContactSet.KeepOut(slot, ref state, SetOf(slot, 0, 0)));
    }

    /// <summary>Of flush surfaces the highest carries, in whichever order the scene names them and whichever carried before.</summary>
    [Fact]
    public void The_highest_of_flush_surfaces_carries_in_any_order()
    {
        double[] heights = [0, 2e-11, 6e-11, 4e-11];
        var random = new Random(3);
        for (int draw = 0; draw < 24; draw++)
        {
            random.Shuffle(heights);
            var scene = new Scene
            {
                Ball = new BallProperties { Radius = Radius },
                Ground = Ground.None,
                Obstacles = [.. heights.Select((height, i) => new Obstacle { Name = $"{i}", Shape = new BoxShape(new Vector3d(0.2 * i, height - 0.5, 0), new Vector3d(2, 0.5, 2)) })],
            };
            World world = new Simulator(scene).World!;
            int highest = Array.IndexOf(heights, heights.Max());
            for (int carrier = 0; carrier < 4; carrier++)
            {
                Assert.Equal(highest, Flush.CarrierAt(world, carrier, new Vector3d(0.3, Radius + 6e-11, 0.1), Vector3d.Zero, 0));
            }
        }
    }

    private static World WorldOf(Vector3d[] normals, bool curved, double closer = 0) => new Simulator(new Scene
    {
        Ball = new BallProperties { Radius = Radius },
        Ground = Ground.None,
        Obstacles = [.. normals.Select((n, i) => new Obstacle
        {
            Name = $"{i}",
            Shape = curved ? new SphereShape(s_place - ((Radius + 0.5 - closer) * n), 0.5) : new PlaneShape(s_place - ((Radius - closer) * n), n),
        })],
    }).World!;

    /// <summary>The contacts where the ball touches all surfaces, with loads in the order of the scene.</summary>
    private static Contact[] SetOf(World world, params double[] loads)
    {
        BallState at = new() { Position = s_place };
        Contact[] set = ContactSet.Near(world, in at, 0.01, new Contact[ContactSet.Room], world.Room).ToArray();
        Assert.Equal(loads.Length, set.Length);
        for (int i = 0; i < set.Length; i++)
        {
            set[i].Load = loads[set[i].Collider];
        }

        return set;
    }
}
