using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls of a cluster are put back onto their contacts: gaps, closing speeds and slips end, and what one ball gets the other loses.</summary>
public sealed class ClusterProjectionTests
{
    private static readonly double[] s_radii = [0.11, 0.09, 0.14];
    private static readonly double[] s_masses = [0.43, 0.2, 0.7];

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Closing_speeds_and_slips_end(bool onGround)
    {
        var random = new Random(81);
        for (int draw = 0; draw < 15; draw++)
        {
            ClusterSystem system = SystemOf(random, onGround);
            foreach (bool atEnd in new[] { false, true })
            {
                (Vector3d momentum, double energy) = Sums(system, atEnd);
                double change = ClusterProjection.Velocities(system, atEnd);
                Assert.True(change > 0);
                for (int k = 0; k < system.ContactCount; k++)
                {
                    ref readonly ClusterContact contact = ref system.Contacts[k];
                    Vector3d n = contact.On.Normal;
                    BallState first = StateOf(system, contact.First, atEnd);
                    Vector3d relative = first.Velocity;
                    Vector3d turning = s_radii[contact.First] * first.SpinAxis;
                    if (contact.Second >= 0)
                    {
                        BallState second = StateOf(system, contact.Second, atEnd);
                        relative -= second.Velocity;
                        turning += s_radii[contact.Second] * second.SpinAxis;
                    }

                    double off = Vector3d.Dot(relative, n);
                    Vector3d slip = relative - (off * n) + Vector3d.Cross(n, turning);
                    Assert.True(!contact.On.Bears || Math.Abs(off) < (onGround ? 0.1 : 1e-4), $"draw {draw}, contact {k} closes at {off}");
                    Assert.True(!contact.On.Bears || !contact.On.Sticks || slip.Length < (onGround ? 0.1 : 1e-4), $"draw {draw}, contact {k} slips at {slip.Length}");
                }

                (Vector3d after, double left) = Sums(system, atEnd);
                Assert.True(left <= energy * (1 + 1e-12), $"draw {draw}: {left} of {energy}");
                Assert.True(onGround || (after - momentum).Length < 1e-12, $"draw {draw}: {after - momentum}");
            }
        }
    }

    /// <summary>Gaps of loaded contacts close: two balls move by their masses, and the ground does not move.</summary>
    [Fact]
    public void Gaps_close_by_the_masses()
    {
        var random = new Random(82);
        for (int draw = 0; draw < 15; draw++)
        {
            ClusterSystem system = SystemOf(random, onGround: false);
            for (int i = 0; i < system.Count; i++)
            {
                system.Balls[i].End.Position += 1e-5 * Vector(random);
            }

            Vector3d before = Centre(system);
            ClusterProjection.Places(system);
            Assert.InRange((Centre(system) - before).Length, 0, 1e-14);
            for (int k = 0; k < system.ContactCount; k++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[k];
                double gap = Vector3d.Distance(system.Balls[contact.First].End.Position, system.Balls[contact.Second].End.Position) - s_radii[contact.First] - s_radii[contact.Second];
                Assert.True(contact.On.Bears ? Math.Abs(gap) < 1e-12 : Math.Abs(gap) > 1e-9, $"draw {draw}, contact {k}: {gap}");
            }
        }
    }

    [Fact]
    public void Balls_on_the_ground_are_put_onto_it()
    {
        var random = new Random(83);
        for (int draw = 0; draw < 10; draw++)
        {
            ClusterSystem system = SystemOf(random, onGround: true);
            for (int i = 0; i < system.Count; i++)
            {
                system.Balls[i].End.Position += 1e-6 * Vector(random);
            }

            ClusterProjection.Places(system);
            for (int k = 0; k < system.ContactCount; k++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[k];
                if (contact.Second < 0 && contact.On.Bears)
                {
                    Assert.Equal(s_radii[contact.First], system.Balls[contact.First].End.Position.Y, 1e-15);
                }
            }
        }
    }

    /// <summary>Drilling friction that holds a spin leaves none about the normal.</summary>
    [Fact]
    public void A_held_spin_ends()
    {
        var random = new Random(84);
        ClusterSystem system = SystemOf(random, onGround: true);
        int bearer = Enumerable.Range(0, system.ContactCount).First(k => system.Contacts[k].Second < 0);
        int held = system.Contacts[bearer].First;
        system.Balls[held].HoldsSpin = true;
        system.Balls[held].Bearer = bearer;
        system.Contacts[bearer].On.CarrierSpin = 0.7;
        ClusterProjection.Velocities(system, atEnd: true);
        Assert.Equal(0.7, system.Balls[held].End.SpinAxis.Y, 1e-12);
    }

    /// <summary>Three balls in a row that bends, in the air or on the ground.</summary>
    private static ClusterSystem SystemOf(Random random, bool onGround)
    {
        var system = new ClusterSystem(new ClusterRoom()) { Count = 3 };
        var places = new Vector3d[3];
        Vector3d way = new(1, 0, 0.3);
        for (int i = 0; i < 3; i++)
        {
            var ball = new BallProperties { Radius = s_radii[i], Mass = s_masses[i], InertiaFactor = 0.4 + (0.1 * i) };
            var simulator = new Simulator(new Scene { Ball = ball });
            if (i == 0)
            {
                places[i] = new Vector3d(0.2, onGround ? s_radii[0] : 3, 0.1);
            }
            else
            {
                // On the ground the line of centres rises with the radius.
                double sum = s_radii[i] + s_radii[i - 1];
                double rise = onGround ? s_radii[i] - s_radii[i - 1] : sum * ((0.8 * random.NextDouble()) - 0.4);
                way = (way + (0.5 * Vector(random))).Horizontal.Normalized();
                places[i] = places[i - 1] + (Math.Sqrt((sum * sum) - (rise * rise)) * way) + new Vector3d(0, rise, 0);
            }

            ref ClusterBall of = ref system.Balls[i];
            of.World = simulator.World!;
            of.PerMass = 1 / ball.Mass;
            of.PerInertia = 1 / ball.MomentOfInertia;
            of.Radius = ball.Radius;
            of.Bearer = -1;
            of.Start = simulator.Launch(places[i], Vector(random), 20 * Vector(random));
            of.Start.SpinAxis = of.Start.Spin;
            of.End = of.Start;
            of.End.Position = places[i];
            of.End.Velocity = Vector(random);
            of.End.SpinAxis = 20 * Vector(random);
            if (onGround)
            {
                ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
                contact = new ClusterContact { First = i, Second = -1 };
                contact.On.Collider = 0;
                contact.On.Turn(Vector3d.Up);
                contact.On.Bears = random.Next(4) > 0 || i == 0;
                contact.On.Sticks = random.Next(2) == 0;
            }
        }

        for (int i = 0; i < 2; i++)
        {
            ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
            contact = new ClusterContact { First = i, Second = i + 1 };
            contact.On.Collider = -1;
            contact.On.Turn((places[i] - places[i + 1]).Normalized());
            contact.On.Bears = i == 0 || random.Next(4) > 0;
            contact.On.Sticks = random.Next(2) == 0;
        }

        return system;
    }

    private static BallState StateOf(ClusterSystem system, int ball, bool atEnd) => atEnd ? system.Balls[ball].End : system.Balls[ball].Start;

    private static (Vector3d Momentum, double Energy) Sums(ClusterSystem system, bool atEnd)
    {
        Vector3d momentum = default;
        double energy = 0;
        for (int i = 0; i < system.Count; i++)
        {
            BallState s = StateOf(system, i, atEnd);
            momentum += s.Velocity / system.Balls[i].PerMass;
            energy += 0.5 * ((s.Velocity.LengthSquared / system.Balls[i].PerMass) + (s.SpinAxis.LengthSquared / system.Balls[i].PerInertia));
        }

        return (momentum, energy);
    }

    private static Vector3d Centre(ClusterSystem system)
    {
        Vector3d sum = default;
        for (int i = 0; i < system.Count; i++)
        {
            sum += system.Balls[i].End.Position / system.Balls[i].PerMass;
        }

        return sum / s_masses.Sum();
    }

    private static Vector3d Vector(Random random) => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
}
