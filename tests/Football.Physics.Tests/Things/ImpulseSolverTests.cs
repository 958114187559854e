using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>
/// The impulses of a contact set against what they must be, whoever found them: J_n ≥ 0, no contact closes, J_n only where it would, |J_t| ≤ μ J_n,
/// and as much as that against the slip where one is left.
/// </summary>
public sealed class ImpulseSolverTests
{
    private const double Radius = 0.11;

    /// <summary>Eight planes around the lowest point of a ball are too many for the forces, so the impulses decide if the ball stays. The search starts without the impulses of an earlier one.</summary>
    [Fact]
    public void A_ball_in_a_funnel_of_many_planes_stays_until_it_is_pulled_out()
    {
        var place = new Vector3d(0, 5, 0);
        Obstacle[] planes = [.. Enumerable.Range(0, 8).Select(i =>
        {
            Vector3d normal = new Vector3d(0.7 * Math.Cos(i * Math.PI / 4), 1, 0.7 * Math.Sin(i * Math.PI / 4)).Normalized();
            return new Obstacle { Name = $"plane {i}", Shape = new PlaneShape(place - (Radius * normal), normal), Surface = SurfaceMaterial.Board };
        })];
        var simulator = new Simulator(new Scene { Ball = new BallProperties { Radius = Radius }, Ground = Ground.None, Obstacles = planes });
        World world = simulator.World;
        BallState state = simulator.Launch(place, Vector3d.Zero, Vector3d.Zero);
        Span<Contact> set = ContactSet.Near(world, in state, 0.01, new Contact[ContactSet.Room], world.Room);
        Assert.Equal(8, set.Length);
        foreach (ref Contact contact in set)
        {
            contact.Load = 1;
            contact.Rub = new Vector3d(1, 0, 0);
        }

        const double Duration = 5e-4;
        Assert.True(ImpulseSolver.Holds(set, world, new MotionRates(new Vector3d(0, -9.81, 0), Vector3d.Zero), Duration, 1e-9));
        Assert.True(ImpulseSolver.Holds(set, world, new MotionRates(new Vector3d(1, -9.81, -1), Vector3d.Zero), Duration, 1e-9));
        Assert.False(ImpulseSolver.Holds(set, world, new MotionRates(new Vector3d(0, 9.81, 0), Vector3d.Zero), Duration, 1e-9));
        Assert.Equal(1, set[0].Load);
        ContactSet.Forget(set);
        foreach (ref readonly Contact contact in set)
        {
            Assert.Equal((0, Vector3d.Zero), (contact.Load, contact.Rub));
        }
    }

    [Theory]
    [InlineData(1, 0, true)]
    [InlineData(2, 0.01, true)]
    [InlineData(3, 0.01, true)]
    [InlineData(4, 0.02, true)]
    [InlineData(5, 0.01, false)]
    [InlineData(3, 0, false)]
    public void Impulses_are_those_of_Coulombs_law_at_all_contacts_at_once(int count, double duration, bool turns)
    {
        var random = new Random(100 + count);
        int solved = 0;
        int slipped = 0;
        int gripped = 0;
        int open = 0;
        for (int i = 0; i < 300; i++)
        {
            World world = ContactScenes.WorldOf(random, count, moves: i % 3 == 0, resists: turns && i % 2 == 0, duration > 0 ? 0.03 : 0, out BallState state);
            Span<Contact> set = ContactSet.Near(world, in state, 0.1, new Contact[ContactSet.Room], world.Room);
            Assert.Equal(count, set.Length);
            BallProperties ball = world.Ball;
            Vector3d freeV = state.Velocity;
            Vector3d freeW = state.Spin;
            Vector3d v = freeV;
            Vector3d w = freeW;
            if (!ImpulseSolver.Solve(set, ball, duration, ref v, ref w))
            {
                continue;
            }

            solved++;
            double scale = freeV.Length + (Radius * freeW.Length) + 1;
            double close = 2e-6 * scale;

            // Velocity and spin are what the impulses make of them; what is left over is the resistance to turning.
            Vector3d pushed = freeV;
            Vector3d turned = freeW;
            int heaviest = 0;
            for (int k = 0; k < count; k++)
            {
                pushed += ((set[k].Load * set[k].Normal) + set[k].Rub) / ball.Mass;
                turned -= Radius * Vector3d.Cross(set[k].Normal, set[k].Rub) / ball.MomentOfInertia;
                heaviest = set[k].Load > set[heaviest].Load ? k : heaviest;
            }

            Assert.InRange((v - pushed).Length, 0, close);
            if (!(set[heaviest].Load > 0))
            {
                Assert.InRange((w - turned).Length * Radius, 0, close);
                continue;
            }

            Resistance(in set[heaviest], ball, duration, in v, w - turned, in turned, in w, close);
            for (int k = 0; k < count; k++)
            {
                ref Contact contact = ref set[k];
                double most = contact.Material.Resistance.MostFriction(contact.Load);
                Vector3d relative = v - contact.Velocity;
                double off = Vector3d.Dot(in relative, contact.Normal);
                double closing = off + (duration > 0 ? Math.Max(0, contact.Gap) / duration : 0);
                Vector3d slip = relative - (off * contact.Normal) + (Radius * Vector3d.Cross(contact.Normal, in w));
                Assert.True(contact.Load >= 0);
                Assert.True(closing >= -close, $"{closing} of {i}, {k}");
                Assert.True(contact.Load * closing <= close * scale, $"bears {contact.Load} while it opens at {closing}");
                Assert.Equal(0, Vector3d.Dot(contact.Rub, contact.Normal), close);
                Assert.True(contact.Rub.Length <= most + close);
                if (contact.Load < 0.01)
                {
                    open++;
                }
                else if (contact.Rub.Length < most * (1 - 1e-3))
                {
                    // It grips.
                    gripped++;
                    Assert.InRange(slip.Length, 0, 20 * close);
                }
                else if (slip.Length > 0.05)
                {
                    // It slips: all of the friction, against the slip.
                    slipped++;
                    Assert.Equal(-1, Vector3d.Dot(contact.Rub / contact.Rub.Length, slip / slip.Length), 1e-4);
                }
            }
        }

        Assert.InRange(solved, count > 4 ? 100 : 200, 300);
        Assert.True(slipped > 20 && gripped + slipped > 100, $"{slipped} slipped, {gripped} gripped");
        Assert.True(count < 3 || open > 20, $"{open} open");
    }

    /// <summary>About the normal by damping and drilling, across it by rolling: against the turning, no more than the load gives, all of it where turning is left.</summary>
    private static void Resistance(in Contact contact, BallProperties ball, double duration, in Vector3d v, Vector3d taken, in Vector3d before, in Vector3d after, double close)
    {
        Vector3d n = contact.Normal;
        ContactMaterial material = contact.Material;
        double inertia = ball.MomentOfInertia;
        double drills = material.Resistance.MostDrilling(contact.Load) / inertia;
        double free = Vector3d.Dot(in before, in n);

        // Damped implicitly, ω/(1 + c h/I), then drilled towards zero.
        double damped = free / (1 + (material.Resistance.Damping * duration / inertia));
        double expected = Math.Sign(damped) * Math.Max(0, Math.Abs(damped) - drills);
        double spinScale = 20 * close / Radius;
        Assert.Equal(expected, Vector3d.Dot(in after, in n), spinScale);

        Vector3d across = taken - (Vector3d.Dot(in taken, in n) * n);
        Vector3d turning = after - (Vector3d.Dot(in after, in n) * n);
        double share = material.Resistance.MostRolling(1, (v - contact.Velocity).Length);
        double most = contact.Sticks ? (1 + ball.InertiaFactor) * share * contact.Load * Radius / inertia : 0;
        Assert.InRange(across.Length, 0, most + spinScale);
        if (contact.Sticks && turning.Length > 0.1 && most > 0.01)
        {
            Assert.Equal(most, across.Length, spinScale + (0.01 * most));
            Assert.True(Vector3d.Dot(in across, in turning) < 0);
        }
    }

    [Fact]
    public void Impulses_that_are_there_already_are_taken_on()
    {
        var random = new Random(9);
        for (int i = 0; i < 100; i++)
        {
            World world = ContactScenes.WorldOf(random, 3, moves: false, resists: false, 0, out BallState state);
            Span<Contact> set = ContactSet.Near(world, in state, 0.1, new Contact[ContactSet.Room], world.Room);
            Vector3d v = state.Velocity;
            Vector3d w = state.Spin;
            if (!ImpulseSolver.Solve(set, world.Ball, 0.01, ref v, ref w))
            {
                continue;
            }

            Contact[] first = set.ToArray();
            Vector3d again = state.Velocity;
            Vector3d turn = state.Spin;
            Assert.True(ImpulseSolver.Solve(set, world.Ball, 0.01, ref again, ref turn));
            Assert.InRange((v - again).Length, 0, 1e-6);
            Assert.InRange(Radius * (w - turn).Length, 0, 1e-6);

            // And a few rounds more change nothing of them, with or without them to begin with.
            again = state.Velocity;
            turn = state.Spin;
            ImpulseSolver.Solve(first, world.Ball, 0.01, ref again, ref turn, rounds: ImpulseSolver.RoundsInVain);
            Assert.InRange((v - again).Length, 0, 1e-6);
        }
    }
}
