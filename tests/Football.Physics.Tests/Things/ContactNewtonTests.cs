using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>A step of Newton's method from close to the answer: what it leaves of an error is of the error's square.</summary>
public sealed class ContactNewtonTests
{
    private const double Radius = 0.11;

    [Theory]
    [InlineData(2, false)]
    [InlineData(2, true)]
    [InlineData(3, true)]
    public void From_close_by_a_step_finds_the_impulses(int count, bool resists)
    {
        var random = new Random(40 + count);
        int tried = 0;
        int found = 0;
        for (int i = 0; i < 400; i++)
        {
            World world = ContactScenes.WorldOf(random, count, moves: i % 4 == 0, resists, 0.002, out BallState state);
            BallProperties ball = world.Ball;
            const double Duration = 0.01;
            Span<Contact> set = ContactSet.Near(world, in state, 0.1, new Contact[ContactSet.Room], world.Room);
            Vector3d v = state.Velocity;
            Vector3d w = state.Spin;
            if (!ContactSolver.Solve(set, ball, Duration, ref v, ref w))
            {
                continue;
            }

            // Only where what bears, grips and slips is plain, and the impulses are determined.
            bool plain = true;
            int heaviest = ContactSet.Heaviest(set);
            if (heaviest < 0)
            {
                continue;
            }

            for (int k = 0; k < count; k++)
            {
                ref Contact contact = ref set[k];
                double most = contact.Material.Resistance.MostFriction(contact.Load);
                Vector3d relative = v - contact.Velocity;
                Vector3d slip = relative - (Vector3d.Dot(in relative, contact.Normal) * contact.Normal) + (Radius * Vector3d.Cross(contact.Normal, in w));
                bool bears = contact.Load > 0.2;
                plain &= bears ? contact.Friction.Length < 0.8 * most || slip.Length > 0.5 : contact.Load == 0 && ContactSolver.Closing(in contact, Duration, in v) > 0.2;
                plain &= k == heaviest || contact.Load < 0.9 * set[heaviest].Load;
            }

            int gripping = 0;
            for (int k = 0; k < count; k++)
            {
                gripping += set[k].Load > 0 && set[k].Friction.Length < 0.8 * set[k].Material.Resistance.MostFriction(set[k].Load) ? 1 : 0;
            }

            if (!plain || gripping > 1)
            {
                continue;
            }

            // What resists the turning at the answer, by one round more.
            TurningResistance exact = Resistance(set, ball, Duration, in state, in v, in w);
            Vector3d turning = w - (Vector3d.Dot(in w, set[heaviest].Normal) * set[heaviest].Normal);
            double about = Math.Abs(Vector3d.Dot(in w, set[heaviest].Normal));
            bool ended = about < 1e-9
                && Math.Abs(exact.Drilling) < 0.8 * (1 + TurningResistance.Damping(in set[heaviest], ball, Duration)) * TurningResistance.DrillingPerLoad(in set[heaviest], ball) * set[heaviest].Load;
            if (resists && ((about < 0.5 && !ended) || (set[heaviest].Rolls && turning.Length < 1)))
            {
                continue;
            }

            // All impulses off by a share, and velocity and spin with them.
            Contact[] off = set.ToArray();
            const double Error = 1e-4;
            TurningResistance near = exact;
            near.Drilling *= 1 + Error;
            near.Rolling *= 1 - Error;
            Vector3d nv = state.Velocity;
            Vector3d nw = state.Spin + near.Rolling + (near.Drilling * set[heaviest].Normal);
            double worst = 0;
            for (int k = 0; k < count; k++)
            {
                Vector3d tilt = Vector3d.Cross(off[k].Normal, off[k].Friction);
                off[k].Load *= 1 + (Error * (random.NextDouble() - 0.5));
                off[k].Friction = ((1 + (Error * (random.NextDouble() - 0.5))) * off[k].Friction) + (Error * random.NextDouble() * tilt);
                nv += (off[k].Load * off[k].Normal) + off[k].Friction;
                nw -= Vector3d.Cross(off[k].Normal, off[k].Friction) / (ball.InertiaFactor * Radius);
            }

            double before = (nv - v).Length + (Radius * (nw - w).Length);
            ContactNewton.Step(off, ball, Duration, ref near, ref nv, ref nw);
            double after = (nv - v).Length + (Radius * (nw - w).Length);
            for (int k = 0; k < count; k++)
            {
                worst = Math.Max(worst, Math.Abs(off[k].Load - set[k].Load) + (off[k].Friction - set[k].Friction).Length);
            }

            tried++;
            found += after < (0.01 * before) + 1e-9 && worst < 1e-6 ? 1 : 0;
        }

        Assert.True(tried >= 30, $"{tried} tried");
        Assert.InRange(found, 0.97 * tried, tried);
    }

    /// <summary>From no impulses and without slip, one step stops a ball that moves straight at a surface, along any axis: all of it is load.</summary>
    [Theory]
    [InlineData(0, 1, 0, false)]
    [InlineData(0, 1, 0, true)]
    [InlineData(1, 0, 0, true)]
    [InlineData(0, 0, -1, false)]
    [InlineData(-1, 0, 0, false)]
    public void From_nothing_a_step_stops_a_ball(double x, double y, double z, bool resists)
    {
        var n = new Vector3d(x, y, z);
        SurfaceMaterial rough = SurfaceMaterial.GoalFrame with { SlidingFriction = 0.6, RollingResistance = 0.05, TorsionalPatchRadius = 0.02, SpinDamping = 0.01 };
        World world = new Simulator(new Scene
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = Ground.None,
            Obstacles = [new Obstacle { Shape = new PlaneShape(-Radius * n, n), Surface = rough }],
        }).World!;
        BallState state = new() { Velocity = -2 * n };
        Span<Contact> set = ContactSet.Near(world, in state, 0.01, new Contact[ContactSet.Room], world.Room);
        var resistance = new TurningResistance { Bearer = resists ? 0 : -1 };
        Vector3d v = state.Velocity;
        Vector3d w = default;
        ContactNewton.Step(set, world.Ball, 0.01, ref resistance, ref v, ref w);
        Assert.Equal(2, set[0].Load, 1e-9);
        Assert.InRange(v.Length + w.Length + set[0].Friction.Length + resistance.Rolling.Length + Math.Abs(resistance.Drilling), 0, 1e-9);

        // With a slip that friction cannot stop: μ of the load, against the slip.
        Vector3d along = 5 * new Vector3d(n.Y, n.Z, n.X);
        state = new() { Velocity = along - (2 * n) };
        set = ContactSet.Near(world, in state, 0.01, new Contact[ContactSet.Room], world.Room);
        resistance = new TurningResistance { Bearer = -1 };
        v = state.Velocity;
        w = default;
        ContactNewton.Step(set, world.Ball, 0.01, ref resistance, ref v, ref w);
        Assert.Equal(2, set[0].Load, 1e-9);
        Assert.InRange((set[0].Friction + (0.6 * 2 * along / 5)).Length, 0, 1e-9);
        Assert.InRange((v - (along * (1 - (0.6 * 2 / 5)))).Length, 0, 1e-9);
    }

    /// <summary>What is left of the spin's change when the contacts' friction is taken off is what resists: about the normal of the heaviest, and across it.</summary>
    private static TurningResistance Resistance(Span<Contact> set, BallProperties ball, double duration, in BallState state, in Vector3d v, in Vector3d w)
    {
        Vector3d turned = state.Spin;
        foreach (ref Contact contact in set)
        {
            turned -= Vector3d.Cross(contact.Normal, contact.Friction) / (ball.InertiaFactor * ball.Radius);
        }

        int heaviest = ContactSet.Heaviest(set);
        var resistance = new TurningResistance { Bearer = heaviest, Normal = heaviest < 0 ? Vector3d.Zero : set[heaviest].Normal };
        if (heaviest >= 0)
        {
            Vector3d n = set[heaviest].Normal;
            Vector3d taken = w - turned;
            resistance.Drilling = Vector3d.Dot(in taken, in n);
            resistance.Rolling = taken - (resistance.Drilling * n);

            // A round at the answer changes nothing.
            Vector3d again = w;
            Assert.InRange(ball.Radius * ContactSolver.Resist(set, ball, duration, ref resistance, in v, ref again), 0, 1e-6);
        }

        return resistance;
    }
}
