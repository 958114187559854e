using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Impulses of a pile against closed forms and balances.</summary>
public sealed class PileSystemTests
{
    private const double Mass = 0.43;
    private const double Radius = 0.11;
    private const double Inertia = 2.0 / 3 * Mass * Radius * Radius;

    /// <summary>A column on the ground: each contact bears all that lies above it.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(12)]
    public void A_column_bears_its_weight(int count)
    {
        const double Pull = 0.00981;
        PileSystem solver = Of(count);
        for (int i = 0; i < count; i++)
        {
            solver.Balls[i].V = new Vector3d(0, -Pull, 0);
            solver.Balls[i].FirstContact = solver.ContactCount;
            solver.Balls[i].OwnContacts = i == 0 ? 1 : 0;
            if (i == 0)
            {
                solver.Add(Ground(0));
            }

            if (i < count - 1)
            {
                solver.Add(Between(i, i + 1, new Vector3d(0, -1, 0), 0));
            }
        }

        solver.Solve(1e-3, 1000, 1e-15);
        Assert.InRange(solver.Fastest(), 0, 1e-12);
        Assert.Equal(0, solver.BearerOf(0));
        for (int i = 0; i < count; i++)
        {
            Assert.Equal((count - i) * Mass * Pull, solver.Contacts[i].Load, 1e-12);
        }
    }

    /// <summary>Two balls that touch and gain speed together move at their mean velocity. A ball that hits the other moves at its new velocity, as does the other.</summary>
    [Theory]
    [InlineData(0, false)]
    [InlineData(-1e-6, false)]
    [InlineData(-1e-3, true)]
    [InlineData(-1, true)]
    public void Balls_move_at_their_mean_velocity_unless_one_hits_the_other(double rate, bool hits)
    {
        const double Gain = 0.01;
        PileSystem solver = Of(2);
        solver.Members[0].StartV = new Vector3d(1 + rate, 0, 0);
        solver.Members[1].StartV = new Vector3d(1, 0, 0);
        solver.Balls[0].V = solver.Members[0].StartV + new Vector3d(Gain, 0, 0);
        solver.Balls[1].V = solver.Members[1].StartV + new Vector3d(2 * Gain, 0, 0);
        solver.Add(Between(0, 1, new Vector3d(1, 0, 0), 0));
        solver.Solve(1e-3, 1000, 1e-15);
        solver.SetWays();
        double end = 1 + (0.5 * rate) + (1.5 * Gain);
        for (int i = 0; i < 2; i++)
        {
            ref readonly PileMember member = ref solver.Members[i];
            Assert.Equal(end, solver.Balls[i].V.X, 1e-12);
            Assert.Equal(hits ? end : 0.5 * (member.StartV.X + end), member.Way.X, 1e-12);
        }
    }

    /// <summary>In turn from the top down and from the ground up, a column of twelve needs few rounds.</summary>
    [Theory]
    [InlineData(60, 0.01)]
    [InlineData(120, 1e-5)]
    public void A_column_needs_few_rounds(int rounds, double left)
    {
        const double Pull = 0.00981;
        PileSystem solver = Of(12);
        for (int i = 0; i < 12; i++)
        {
            solver.Balls[i].V = new Vector3d(0, -Pull, 0);
            solver.Balls[i].FirstContact = solver.ContactCount;
            solver.Balls[i].OwnContacts = i == 0 ? 1 : 0;
            if (i == 0)
            {
                solver.Add(Ground(0));
            }

            if (i < 11)
            {
                solver.Add(Between(i, i + 1, new Vector3d(0, -1, 0), 0));
            }
        }

        solver.Solve(1e-3, rounds, 1e-15);
        Assert.InRange(solver.Fastest() / Pull, 0, left);
    }

    /// <summary>Between balls alone nothing comes from nothing: momentum and turning are kept, energy never grows, and none closes by more than its gap.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Balls_among_themselves_keep_their_momentum(int seed)
    {
        const double H = 1e-3;
        var random = new Random(seed);
        Vector3d Draw() => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        PileSystem solver = Of(7);
        Vector3d[] places = [default, .. Enumerable.Range(0, 6).Select(i => 2 * Radius * (i < 3 ? 1 : -1) * new Vector3d(i % 3 == 0 ? 1 : 0, i % 3 == 1 ? 1 : 0, i % 3 == 2 ? 1 : 0))];
        for (int i = 0; i < 7; i++)
        {
            solver.Balls[i].V = Draw() - (4.0 * places[i]);
            solver.Balls[i].W = 20.0 * Draw();
        }

        for (int i = 1; i < 7; i++)
        {
            solver.Add(Between(0, i, (-places[i]).Normalized(), 1e-4 * (i % 2)));
        }

        (Vector3d Momentum, Vector3d Turning, double Energy) before = Balance(solver, places);
        solver.Solve(H, 400, 1e-14);
        (Vector3d Momentum, Vector3d Turning, double Energy) after = Balance(solver, places);
        Assert.InRange((after.Momentum - before.Momentum).Length, 0, 1e-12);
        Assert.InRange((after.Turning - before.Turning).Length, 0, 1e-12);
        Assert.InRange(after.Energy, 0, before.Energy);
        int pressed = 0;
        for (int i = 0; i < solver.ContactCount; i++)
        {
            ref readonly Contact contact = ref solver.Contacts[i];
            double rate = Vector3d.Dot(solver.Balls[contact.First].V - solver.Balls[contact.Second].V, in contact.Normal);
            Assert.InRange(rate + (contact.Gap / H), -1e-9, double.PositiveInfinity);
            Assert.InRange(contact.Rub.Length, 0, contact.Material.Resistance.MostFriction(contact.Load) + 1e-12);
            Assert.InRange(Math.Abs(contact.Twist), 0, contact.Material.Resistance.MostDrilling(contact.Load) + 1e-12);
            pressed += contact.Load > 0 ? 1 : 0;
        }

        Assert.True(pressed > 1);
    }

    /// <summary>A ball that rolls on the ground is slowed by c₀ of its load; one that slips by μ; one that turns about the normal by b μ.</summary>
    [Theory]
    [InlineData(1.0, 0.0, 0.0)]
    [InlineData(1.0, 2.0, 0.0)]
    [InlineData(0.0, 0.0, 30.0)]
    public void The_ground_slows_a_ball_as_its_surface_says(double speed, double slip, double about)
    {
        const double Pull = 0.01;
        PileSystem solver = Of(1);
        solver.Balls[0].V = new Vector3d(speed, -Pull, 0);
        solver.Balls[0].W = new Vector3d(0, about, -(speed - slip) / Radius);
        solver.Balls[0].OwnContacts = 1;
        solver.Add(Ground(0));
        solver.Solve(1e-3, 400, 1e-15);
        double slowed = speed - solver.Balls[0].V.X;
        Assert.Equal(slip > 0 ? 0.5 * Pull : speed > 0 ? 0.07 * Pull : 0, slowed, 1e-9);
        Assert.Equal(about > 0 ? 0.02 * 0.5 * Mass * Pull / Inertia : 0, about - solver.Balls[0].W.Y, 1e-9);
    }

    /// <summary>On a surface that moves, friction, rolling resistance and the load depend on the velocity relative to it.</summary>
    [Theory]
    [InlineData(2.0, 0.0)]
    [InlineData(0.0, 0.0)]
    [InlineData(0.0, 0.3)]
    public void A_surface_that_moves_carries_a_ball_as_one_that_stands(double slip, double lift)
    {
        const double Pull = 0.01;
        var motion = new Vector3d(3, lift, -1);
        PileSystem[] solvers = [Of(1), Of(1)];
        foreach (PileSystem solver in solvers)
        {
            bool moves = solver == solvers[1];
            solver.Balls[0].V = new Vector3d(1, -Pull, 0) + (moves ? motion : Vector3d.Zero);
            solver.Balls[0].W = new Vector3d(0, 0, -(1 - slip) / Radius);
            solver.Balls[0].OwnContacts = 1;
            solver.Add(Ground(0) with { Velocity = moves ? motion : Vector3d.Zero });
            solver.Solve(1e-3, 400, 1e-15);
        }

        Assert.InRange((solvers[1].Balls[0].V - motion - solvers[0].Balls[0].V).Length, 0, 1e-9);
        Assert.InRange((solvers[1].Balls[0].W - solvers[0].Balls[0].W).Length, 0, 1e-8);
        Assert.Equal(Mass * Pull, solvers[1].Contacts[0].Load, 1e-12);
    }

    /// <summary>Damping slows a spin about the normal to ω/(1 + c_ω h/I).</summary>
    [Fact]
    public void Damping_slows_a_spin_by_its_share()
    {
        const double H = 0.01;
        const double Damping = 2e-3;
        PileSystem solver = Of(1);
        solver.Balls[0].V = new Vector3d(0, -0.01, 0);
        solver.Balls[0].W = new Vector3d(0, 30, 0);
        solver.Balls[0].OwnContacts = 1;
        solver.Add(Ground(0) with { Material = new ContactMaterial { Resistance = new Resistance(0.5, 0.07, 0, Damping, 0) } });
        solver.Solve(H, 400, 1e-15);
        Assert.Equal(30 / (1 + (Damping * H / Inertia)), solver.Balls[0].W.Y, 1e-9);
    }

    /// <summary>Of several surfaces the one with the greatest load resists a roll, in any order of the contacts.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_surface_with_the_greatest_load_slows_a_roll(bool wallIsFirst)
    {
        const double Pull = 0.01;
        PileSystem solver = Of(1);
        solver.Balls[0].V = new Vector3d(-0.1 * Pull, -Pull, 1);
        solver.Balls[0].W = new Vector3d(1 / Radius, 0, 0);
        solver.Balls[0].OwnContacts = 2;
        Contact wall = Ground(0) with { Normal = new Vector3d(1, 0, 0), Material = new ContactMaterial { Resistance = new Resistance(0, 0.9, 0, 0, 0.02) } };
        solver.Add(wallIsFirst ? wall : Ground(0));
        solver.Add(wallIsFirst ? Ground(0) : wall);
        solver.Solve(1e-3, 400, 1e-15);
        Assert.Equal(wallIsFirst ? 1 : 0, solver.BearerOf(0));
        Assert.Equal(0.07 * Pull, 1 - solver.Balls[0].V.Z, 1e-9);
        Assert.Equal(0.1 * Mass * Pull, solver.Contacts[wallIsFirst ? 0 : 1].Load, 1e-9);
    }

    /// <summary>Surfaces that stand still do no work: what contacts change of the free velocities is at most across the velocities left, Σ m (v − v_free)·v = 0. Those that move may.</summary>
    [Theory]
    [InlineData(1.3, false)]
    [InlineData(0.7, false)]
    [InlineData(1.3, true)]
    public void Contacts_that_stand_still_do_no_work(double faster, bool moves)
    {
        var random = new Random(12);
        Vector3d Draw() => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        PileSystem solver = Of(3);
        for (int i = 0; i < 3; i++)
        {
            ref PressedBall ball = ref solver.Balls[i];
            ball.FreeV = Draw();
            ball.FreeW = 10 * Draw();
            ball.V = faster * ball.FreeV;
            ball.W = faster * ball.FreeW;
            solver.Add(Ground(i) with { Velocity = moves && i == 1 ? new Vector3d(1, 0, 0) : default });
        }

        PressedBall[] before = [.. solver.Balls];
        double worked = Work();
        Assert.Equal(faster > 1, worked > 0);
        solver.LimitWork();
        bool limits = faster > 1 && !moves;
        Assert.Equal(limits ? 0 : worked, Work(), 1e-12);
        double share = limits ? 1 / faster : 1;
        for (int i = 0; i < 3; i++)
        {
            Assert.InRange((solver.Balls[i].V - (share * before[i].V)).Length, 0, 1e-12);
            Assert.InRange((solver.Balls[i].W - (share * before[i].W)).Length, 0, 1e-11);
        }

        double Work() => solver.Balls.Sum(ball => (Mass * Vector3d.Dot(ball.V - ball.FreeV, ball.V)) + (Inertia * Vector3d.Dot(ball.W - ball.FreeW, ball.W)));
    }

    /// <summary>Of several overlaps the deepest counts, and gaps do not.</summary>
    [Theory]
    [InlineData(0.001, 0.003)]
    [InlineData(0.003, 0.001)]
    [InlineData(0.002, -0.01)]
    [InlineData(-0.02, -0.01)]
    public void The_deepest_overlap_of_a_pile(double first, double second)
    {
        PileSystem solver = Of(3);
        solver.Add(Ground(0));
        solver.Add(Between(0, 1, new Vector3d(0, -1, 0), -first));
        solver.Add(Between(1, 2, new Vector3d(0, -1, 0), -second));
        var simulator = new Simulator();
        double[] heights = [0, (2 * Radius) - first, (4 * Radius) - first - second];
        BallState[] states = [.. heights.Select(height => simulator.Launch(new Vector3d(0, 3 + height, 0), Vector3d.Zero, Vector3d.Zero))];
        Assert.Equal(Math.Max(0, Math.Max(first, second)), new PileOverlaps([simulator, simulator, simulator], solver).Deepest(states), 1e-12);
    }

    private static PileSystem Of(int count)
    {
        var solver = new PileSystem { Members = new PileMember[count], Balls = new PressedBall[count], Count = count };
        for (int i = 0; i < count; i++)
        {
            solver.Members[i].Ball = i;
            solver.Balls[i] = new PressedBall { PerMass = 1 / Mass, PerInertia = 1 / Inertia, InertiaFactor = 2.0 / 3, Radius = Radius };
        }

        return solver;
    }

    private static Contact Ground(int ball) => new()
    {
        First = ball,
        Second = -1,
        Normal = Vector3d.Up,
        NormalMass = Mass,
        SlipMass = 1 / ((1 / Mass) + (Radius * Radius / Inertia)),
        Material = new ContactMaterial { Resistance = new Resistance(0.5, 0.07, 0, 0, 0.02) },
    };

    private static Contact Between(int first, int second, Vector3d normal, double gap) => new()
    {
        First = first,
        Second = second,
        Collider = -1,
        Normal = normal,
        Gap = gap,
        NormalMass = Mass / 2,
        SlipMass = 0.5 / ((1 / Mass) + (Radius * Radius / Inertia)),
        TwistMass = Inertia / 2,
        Material = new ContactMaterial { Resistance = new Resistance(0.4, 0, 0, 0, 0.004) },
    };

    private static (Vector3d Momentum, Vector3d Turning, double Energy) Balance(PileSystem solver, Vector3d[] places)
    {
        Vector3d momentum = default;
        Vector3d turning = default;
        double energy = 0;
        for (int i = 0; i < solver.Count; i++)
        {
            ref readonly PressedBall ball = ref solver.Balls[i];
            momentum += Mass * ball.V;
            turning += (Inertia * ball.W) + (Mass * Vector3d.Cross(in places[i], in ball.V));
            energy += 0.5 * ((Mass * ball.V.LengthSquared) + (Inertia * ball.W.LengthSquared));
        }

        return (momentum, turning, energy);
    }
}
