namespace FootballPhysics.Tests.Several;

/// <summary>A few balls that press each other go by whole steps of the method: closed forms, balances, counts.</summary>
public sealed class ClusterTests
{
    private const double Tilt = 15 * Math.PI / 180;
    private const double Gravity = 9.81;

    private static readonly Vector3d s_normal = new(0, Math.Cos(Tilt), -Math.Sin(Tilt));
    private static readonly Vector3d s_down = new(0, -Math.Sin(Tilt), -Math.Cos(Tilt));
    private static readonly Air s_vacuum = new() { Density = 0 };

    /// <summary>A solid ball rolls down behind a hollow one, which would be slower: with m (1 + α) of both their acceleration is g sin θ Σm/Σm(1 + α), less c₀ of each load.</summary>
    [Theory]
    [InlineData(0.0, 0.01)]
    [InlineData(0.0, 0.1)]
    [InlineData(0.03, 1 / 60.0)]
    public void A_ball_pushes_another_down_a_slope(double resistance, double step)
    {
        BallProperties hollow = BallProperties.Tunnel with { InertiaFactor = 2 / 3.0 };
        BallProperties solid = BallProperties.Tunnel with { InertiaFactor = 0.4, Mass = 0.6 };
        double r = hollow.Radius;
        var scene = new Scene
        {
            Air = s_vacuum,
            Gravity = Gravity,
            Ground = new Ground { Material = SurfaceMaterial.DryTurf with { RollingResistance = resistance, RollingResistancePerSpeed = 0 }, Normal = s_normal },
        };
        var group = new BallGroup(scene, [hollow, solid], null, SurfaceMaterial.Ball with { ImpactFriction = 0 });
        Vector3d velocity = 1.0 * s_down;
        Vector3d spin = Vector3d.Cross(s_normal, velocity) / r;
        BallState[] states =
        [
            group.SimulatorOf(0).Launch(r * s_normal, velocity, spin),
            group.SimulatorOf(1).Launch((r * s_normal) - (2 * r * s_down), velocity, spin),
        ];
        var log = new StepLog();
        int steps = (int)Math.Round(1 / step);
        for (int i = 0; i < steps; i++)
        {
            group.Step(states, step, log);
        }

        // m (1 + α) a = m g sin θ ± N − (1 + α) c₀ m g cos θ: resistance is a deceleration of either.
        double pulled = (hollow.Mass + solid.Mass) * Gravity * Math.Sin(Tilt);
        double inertia = (hollow.Mass * (1 + hollow.InertiaFactor)) + (solid.Mass * (1 + solid.InertiaFactor));
        double a = (pulled / inertia) - (resistance * Gravity * Math.Cos(Tilt));
        double time = steps * step;
        Assert.Equal(1 + (a * time), Vector3d.Dot(states[0].Velocity, s_down), 1e-9);
        Assert.Equal(1 + (a * time), Vector3d.Dot(states[1].Velocity, s_down), 1e-9);
        Assert.Equal(time + (0.5 * a * time * time), Vector3d.Dot(states[0].Position, s_down), 1e-9);
        Assert.Equal(2 * r, Vector3d.Distance(states[0].Position, states[1].Position), 1e-12);

        // All of them whole.
        Assert.Equal(2 * steps, log.Steps);
        Assert.Equal(2 * 5 * steps, log.Evaluations);
    }

    /// <summary>The same on a sloping table that turns: the balls grip the surface as it moves under them, and whole steps agree with far shorter ones.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(-3.0)]
    public void A_table_that_turns_carries_a_pair_in_whole_steps(double rate)
    {
        (BallState[] states, StepLog log) = Turned(rate, 0.01);
        (BallState[] exact, _) = Turned(rate, 0.00125);
        Assert.Equal(2 * 20, log.Steps);
        Assert.All(Enumerable.Range(0, 2), i =>
        {
            Assert.Equal(MotionState.Rolling, states[i].Motion);
            Assert.InRange((states[i].Position - exact[i].Position).Length, 0, 1e-9);
            Assert.InRange((states[i].Velocity - exact[i].Velocity).Length, 0, 1e-8);
        });
    }

    /// <summary>With each method, shorter steps halve the error by its order, and a step has one evaluation more than the method has stages.</summary>
    [Theory]
    [InlineData(Integrator.Euler, 1, 2)]
    [InlineData(Integrator.SemiImplicitEuler, 1, 2)]
    [InlineData(Integrator.Rk2, 2, 3)]
    public void Whole_steps_of_every_method_converge(Integrator integrator, int order, int evaluations)
    {
        (BallState[] exact, _) = Turned(2, 0.00125);
        double[] errors = [.. new[] { 0.01, 0.005 }.Select(step =>
        {
            (BallState[] states, StepLog log) = Turned(2, step, integrator);
            Assert.Equal(2 * Math.Round(0.2 / step), log.Steps);
            Assert.Equal(evaluations * log.Steps, log.Evaluations);
            return Math.Max((states[0].Position - exact[0].Position).Length, (states[1].Position - exact[1].Position).Length);
        })];
        Assert.InRange(errors[0], 0, order == 1 ? 5e-3 : 1e-4);
        Assert.InRange(errors[0] / errors[1], 0.8 * Math.Pow(2, order), 1.3 * Math.Pow(2, order));
    }

    /// <summary>Explicit Euler turns the balls with their spins at the start of a step, the semi-implicit form with the new ones. The clock is that of the step.</summary>
    [Theory]
    [InlineData(Integrator.Euler, true)]
    [InlineData(Integrator.SemiImplicitEuler, false)]
    public void Methods_of_order_one_turn_the_balls_by_one_spin(Integrator integrator, bool isOfStart)
    {
        (BallState[] start, _) = Turned(2, 1, integrator);
        (BallState[] after, _) = Turned(2, 0.2, integrator);
        for (int i = 0; i < 2; i++)
        {
            double byStart = Cosine(after[i].Orientation, start[i].Spin);
            double byEnd = Cosine(after[i].Orientation, after[i].Spin);
            Assert.InRange(isOfStart ? byStart : byEnd, isOfStart ? 1 - 1e-9 : byStart + 1e-4, 1 + 1e-9);
            Assert.Equal(0.2, after[i].Time, 1e-12);
        }

        static double Cosine(Quaterniond at, Vector3d spin)
        {
            var turn = Quaterniond.FromAxisAngle(spin.Normalized(), 0.2 * spin.Length);
            return Math.Abs((turn.X * at.X) + (turn.Y * at.Y) + (turn.Z * at.Z) + (turn.W * at.W));
        }
    }

    private static (BallState[] States, StepLog Log) Turned(double rate, double step, Integrator integrator = Integrator.Rk4)
    {
        BallProperties hollow = BallProperties.Tunnel with { InertiaFactor = 2 / 3.0 };
        BallProperties solid = BallProperties.Tunnel with { InertiaFactor = 0.4, Mass = 0.6 };
        double r = hollow.Radius;
        Vector3d turning = rate * s_normal;
        SurfaceMaterial felt = SurfaceMaterial.DryTurf with { RollingResistance = 0, RollingResistancePerSpeed = 0 };
        var scene = new Scene
        {
            Air = s_vacuum,
            Gravity = Gravity,
            Ground = Ground.None,
            Obstacles = [new Obstacle { Name = "table", Shape = new PlaneShape(Vector3d.Zero, s_normal), Surface = felt, Spin = turning }],
        };
        var group = new BallGroup(scene, [hollow, solid], new SolverSettings { Integrator = integrator }, SurfaceMaterial.Ball with { ImpactFriction = 0 });
        Vector3d velocity = 1.0 * s_down;
        BallState[] states = [.. Enumerable.Range(0, 2).Select(i =>
        {
            Vector3d contact = -2 * i * r * s_down;
            Vector3d spin = turning + (Vector3d.Cross(s_normal, velocity - Vector3d.Cross(turning, contact)) / r);
            return group.SimulatorOf(i).Launch(contact + (r * s_normal), velocity, spin);
        })];
        var log = new StepLog();
        for (int i = 0; i < (int)Math.Round(0.2 / step); i++)
        {
            group.Step(states, step, log);
        }

        return (states, log);
    }

    /// <summary>Two balls lie on a slope without friction, against a board without friction, and turn against each other: what one gets of the friction along the board the other loses.</summary>
    [Fact]
    public void What_balls_do_to_each_other_is_balanced()
    {
        SurfaceMaterial smooth = SurfaceMaterial.HardGround with { SlidingFriction = 0, RollingResistance = 0, RollingResistancePerSpeed = 0, SpinDamping = 0, TorsionalPatchRadius = 0 };
        BallProperties light = BallProperties.Tunnel with { Mass = 0.2 };
        BallProperties heavy = BallProperties.Tunnel with { Mass = 0.5 };
        double r = light.Radius;
        var scene = new Scene
        {
            Air = s_vacuum,
            Gravity = Gravity,
            Ground = new Ground
            {
                Material = SurfaceMaterial.DryTurf with
                {
                    SlidingFriction = 0,
                    RollingResistance = 0,
                    RollingResistancePerSpeed = 0,
                    SpinDamping = 0,
                    TorsionalPatchRadius = 0,
                },
                Normal = s_normal,
            },
            Obstacles = [new Obstacle { Name = "board", Shape = new PlaneShape(r * s_down, -s_down), Surface = smooth }],
        };
        var group = new BallGroup(scene, [light, heavy]);
        BallState[] states =
        [
            group.SimulatorOf(0).Launch(r * s_normal, new Vector3d(2, 0, 0), (12 * s_normal) + (3 * s_down)),
            group.SimulatorOf(1).Launch((r * s_normal) - (2 * r * s_down), new Vector3d(2, 0, 0), 5 * s_normal),
        ];
        double Momentum() => (light.Mass * states[0].Velocity.X) + (heavy.Mass * states[1].Velocity.X);
        double Turning() => (light.MomentOfInertia * Vector3d.Dot(states[0].Spin, s_normal)) - (heavy.MomentOfInertia * Vector3d.Dot(states[1].Spin, s_normal));
        double Energy() => states.Select((s, i) => (i == 0 ? light : heavy, s)).Sum(pair =>
            (0.5 * pair.Item1.Mass * pair.s.Velocity.LengthSquared) + (0.5 * pair.Item1.MomentOfInertia * pair.s.Spin.LengthSquared) + (pair.Item1.Mass * Gravity * pair.s.Position.Y));
        double momentum = Momentum();
        double turning = Turning();
        double energy = Energy();
        double first = states[0].Velocity.X;
        var log = new StepLog();
        for (int i = 0; i < 20; i++)
        {
            group.Step(states, 0.01, log);
            Assert.Equal(momentum, Momentum(), 1e-12);

            // The friction has the same lever at both.
            Assert.Equal(turning, Turning(), 1e-12);
            Assert.True(Energy() <= energy + 1e-12);
            energy = Energy();
        }

        Assert.True(Math.Abs(states[0].Velocity.X - first) > 0.1, $"{states[0].Velocity}");
    }

    /// <summary>A row of balls that roll down a slope, the heavier behind: one evaluation a stage and one more; in parts where they are more than eight. Their numbers decide nothing.</summary>
    [Theory]
    [InlineData(2, true)]
    [InlineData(5, true)]
    [InlineData(8, true)]
    [InlineData(9, false)]
    public void A_row_goes_by_whole_steps_of_up_to_eight_balls(int count, bool whole)
    {
        int[] order = [.. Enumerable.Range(0, count).Select(i => ((i * 7) + 3) % count)];
        (BallState[] states, StepLog log) = Row([.. Enumerable.Range(0, count)]);
        (BallState[] turned, _) = Row(order.Distinct().Count() == count ? order : [.. Enumerable.Range(0, count).Reverse()]);
        const int Steps = 40;
        if (whole)
        {
            Assert.Equal(count * Steps, log.Steps);
            Assert.Equal(5 * count * Steps, log.Evaluations);
        }
        else
        {
            Assert.InRange(log.Steps, (count * Steps) + 1, 10 * count * Steps);
        }

        for (int i = 0; i < count; i++)
        {
            Assert.True(Snapshot.Same(in states[i], in turned[i]), $"ball {i}: {Snapshot.Difference(in states[i], in turned[i])}");
            double gap = i == 0 ? 0 : Vector3d.Distance(states[i].Position, states[i - 1].Position) - (2 * BallProperties.Tunnel.Radius);
            Assert.InRange(gap, -1e-7, whole ? 1e-12 : 1e-3);
        }

        (BallState[] States, StepLog Log) Row(int[] places)
        {
            BallProperties[] kinds = [.. places.Select(i => BallProperties.Tunnel with { Mass = 0.2 + (0.1 * i) })];
            double r = kinds[0].Radius;
            var group = new BallGroup(new Scene { Air = new Air { Wind = new Vector3d(0.5, 0, 2) }, Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = s_normal } }, kinds);
            Vector3d velocity = 4 * s_down;
            BallState[] balls = [.. places.Select((place, i) =>
                group.SimulatorOf(i).Launch((r * s_normal) - (2 * place * r * s_down), velocity, Vector3d.Cross(s_normal, velocity) / r))];
            var counts = new StepLog();
            for (int i = 0; i < Steps; i++)
            {
                group.Step(balls, 0.01, counts);
            }

            return ([.. Enumerable.Range(0, count).Select(place => balls[Array.IndexOf(places, place)])], counts);
        }
    }
}
