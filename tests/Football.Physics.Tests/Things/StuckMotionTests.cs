using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>What is left of a slip or of a speed into a surface is removed by impulses at the contacts: the motion then fits their modes.</summary>
public sealed unsafe class StuckMotionTests
{
    private const double Radius = 0.11;

    private static readonly Vector3d s_place = new(0.3, 0.2, -0.2);

    [Theory]
    [InlineData(1, false)]
    [InlineData(2, false)]
    [InlineData(2, true)]
    [InlineData(3, false)]
    public void A_motion_fits_the_modes(int count, bool moves)
    {
        var random = new Random(50 + count);
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 100; draw++)
        {
            World world = WorldOf(random, count, moves);
            Vector3d with = world.Colliders[0].Velocity;
            BallState s = new() { Position = s_place, Velocity = with + Vector(random, 1e-5), SpinAxis = Vector(random, 1e-4) };
            ContactSystem system = SystemOf(world, in s, contacts);
            for (int i = 0; i < count; i++)
            {
                contacts[i].Bears = i == 0 || random.Next(4) > 0;
                contacts[i].Sticks = contacts[i].Bears && random.Next(2) == 0;
            }

            system.HoldsSpin = random.Next(2) == 0 && count == 1;
            BallState before = s;
            StuckMotion.Project(world, in system, ref s);
            Vector3d pushed = s.Velocity - before.Velocity;
            Vector3d turned = s.SpinAxis - before.SpinAxis;
            bool sticks = false;
            for (int i = 0; i < count; i++)
            {
                ref readonly SetContact contact = ref contacts[i];
                Vector3d relative = s.Velocity - contact.Surface;
                double off = Vector3d.Dot(relative, contact.Normal);
                Assert.True(contact.Bears ? Math.Abs(off) <= 1e-6 : off >= -1e-6 || moves, $"draw {draw}, contact {i}: {off}");
                Vector3d slip = relative - (off * contact.Normal) + (Radius * Vector3d.Cross(contact.Normal, s.SpinAxis));
                Assert.True(!contact.Sticks || slip.Length <= 1e-6, $"draw {draw}, contact {i} slips at {slip.Length}");
                sticks |= contact.Sticks;
            }

            // Without friction the spin stays; one contact changes it by −n × J/(α r) of its impulse.
            Assert.True(sticks || turned == Vector3d.Zero || system.HoldsSpin);
            if (count == 1)
            {
                Vector3d expected = -Vector3d.Cross(contacts[0].Normal, pushed) / (world.Ball.InertiaFactor * Radius);
                Vector3d n = contacts[0].Normal;
                Assert.InRange((turned - (Vector3d.Dot(turned, n) * n) - expected).Length, 0, 1e-12);
                Assert.Equal(system.HoldsSpin ? 0 : Vector3d.Dot(before.SpinAxis, n), Vector3d.Dot(s.SpinAxis, n), 1e-12);
            }
        }
    }

    /// <summary>A ball that rolling resistance holds in a groove moves with the groove, and spins only with it.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_ball_that_is_held_moves_with_its_carrier(bool moves)
    {
        var random = new Random(53);
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 40; draw++)
        {
            World world = WorldOf(random, 1, moves);
            Vector3d surface = world.Colliders[0].Velocity;
            BallState s = new() { Position = s_place, Velocity = surface + Vector(random, 1e-8), SpinAxis = Vector(random, 1e-7) };
            ContactSystem system = SystemOf(world, in s, contacts);
            contacts[0].Bears = true;
            contacts[0].Sticks = true;
            system.Pinned = true;
            Vector3d n = contacts[0].Normal;
            double about = Vector3d.Dot(s.SpinAxis, n);
            StuckMotion.Project(world, in system, ref s);
            Assert.Equal(surface, s.Velocity);
            Assert.InRange((s.SpinAxis - (about * n)).Length, 0, 1e-15);
        }
    }

    /// <summary>If no motion fits all contacts, the ball enters none that stands still.</summary>
    [Fact]
    public void A_mover_that_leaves_no_room_does_not_push_the_ball_into_what_stands_still()
    {
        var scene = new Scene
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = Ground.None,
            Obstacles =
            [
                new Obstacle { Name = "wall", Shape = new PlaneShape(s_place - new Vector3d(Radius, 0, 0), new Vector3d(1, 0, 0)) },
                new Obstacle { Name = "mover", Shape = new SphereShape(s_place + new Vector3d(Radius + 0.5, 0, 0), 0.5), Velocity = new Vector3d(-3, 0, 0) },
            ],
        };
        World world = new Simulator(scene).World!;
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        BallState s = new() { Position = s_place, Velocity = new Vector3d(-1, 2, 0) };
        ContactSystem system = SystemOf(world, in s, contacts);
        contacts[0].Bears = contacts[1].Bears = true;
        contacts[0].Sticks = contacts[1].Sticks = false;
        StuckMotion.Project(world, in system, ref s);
        Assert.Equal(0, s.Velocity.X, 1e-12);
        Assert.Equal(2, s.Velocity.Y, 1e-12);
    }

    private static ContactSystem SystemOf(World world, in BallState s, SetContact* contacts)
    {
        Span<Contact> set = ContactSet.Near(world, in s, ContactTolerances.Touching, new Contact[ContactSet.Room], world.Room);
        Assert.Equal(world.Colliders.Length, set.Length);
        var at = new FootballPhysics.Motion(s.Position, s.Velocity, s.SpinAxis);
        for (int i = 0; i < set.Length; i++)
        {
            contacts[i].Prepare(in set[i], world.Colliders[set[i].Collider]);
            contacts[i].Look(world, 0, in at);
        }

        return new ContactSystem { World = world, Contacts = contacts, Count = set.Length };
    }

    private static World WorldOf(Random random, int count, bool moves) => new Simulator(new Scene
    {
        Ball = new BallProperties { Radius = Radius, InertiaFactor = 0.55 },
        Ground = Ground.None,
        Obstacles = Sides(random, count, moves ? Vector(random, 1) : Vector3d.Zero),
    }).World!;

    private static Obstacle[] Sides(Random random, int count, Vector3d velocity) =>
    [
        .. Enumerable.Range(0, count).Select(i =>
        {
            Vector3d n = (Vector(random, 0.7) + Vector3d.Up).Normalized();
            return new Obstacle
            {
                Name = $"{i}",
                Shape = random.Next(2) == 0 ? new SphereShape(s_place - ((Radius + 0.5) * n), 0.5) : new PlaneShape(s_place - (Radius * n), n),
                Velocity = velocity,
            };
        }),
    ];

    private static Vector3d Vector(Random random, double size) => size * new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
}
