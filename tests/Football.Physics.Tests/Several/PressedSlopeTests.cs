namespace FootballPhysics.Tests.Several;

/// <summary>Balls that press each other on slopes: closed forms and balances.</summary>
public sealed class PressedSlopeTests
{
    private const double Tilt = 15 * Math.PI / 180;
    private const double Gravity = 9.81;

    /// <summary>The error of the impulses after a second, m and m/s.</summary>
    private const double Error = 2e-6;

    private static readonly Vector3d s_normal = new(0, Math.Cos(Tilt), -Math.Sin(Tilt));
    private static readonly Vector3d s_down = new(0, -Math.Sin(Tilt), -Math.Cos(Tilt));
    private static readonly Air s_vacuum = new() { Density = 0 };

    /// <summary>A solid ball rolls down behind a hollow one, which would be slower: with m (1 + α) of both their acceleration is g sin θ Σm/Σm(1 + α), less c₀ of each load.</summary>
    [Theory]
    [InlineData(0.0, 0.01)]
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
        Assert.Equal(1 + (a * time), Vector3d.Dot(states[0].Velocity, s_down), Error);
        Assert.Equal(1 + (a * time), Vector3d.Dot(states[1].Velocity, s_down), Error);
        Assert.Equal(time + (0.5 * a * time * time), Vector3d.Dot(states[0].Position, s_down), Error);
        Assert.Equal(2 * r, Vector3d.Distance(states[0].Position, states[1].Position), 1e-10);
    }

    /// <summary>The same on a sloping table that turns: the balls grip the surface as it moves under them. Steps of 10 ms agree with far shorter ones.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(-3.0)]
    public void A_table_that_turns_carries_a_pair(double rate)
    {
        BallState[] states = Turned(rate, 0.01);
        BallState[] exact = Turned(rate, 0.00125);
        Assert.All(Enumerable.Range(0, 2), i =>
        {
            Assert.InRange((states[i].Position - exact[i].Position).Length, 0, Error);
            Assert.InRange((states[i].Velocity - exact[i].Velocity).Length, 0, 5 * Error);
        });
    }

    private static BallState[] Turned(double rate, double step)
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
        var group = new BallGroup(scene, [hollow, solid], null, SurfaceMaterial.Ball with { ImpactFriction = 0 });
        Vector3d velocity = 1.0 * s_down;
        BallState[] states = [.. Enumerable.Range(0, 2).Select(i =>
        {
            Vector3d contact = -2 * i * r * s_down;
            Vector3d spin = turning + (Vector3d.Cross(s_normal, velocity - Vector3d.Cross(turning, contact)) / r);
            return group.SimulatorOf(i).Launch(contact + (r * s_normal), velocity, spin);
        })];
        for (int i = 0; i < (int)Math.Round(0.2 / step); i++)
        {
            group.Step(states, step, new StepLog());
        }

        return states;
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

    /// <summary>In a row of balls that roll down a slope, the heavier behind, no ball enters another, and the numbers of the balls decide nothing.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    [InlineData(8)]
    [InlineData(9)]
    public void A_row_rolls_down_a_slope_whatever_the_numbers_of_its_balls(int count)
    {
        int[] order = [.. Enumerable.Range(0, count).Select(i => ((i * 7) + 3) % count)];
        BallState[] states = Row([.. Enumerable.Range(0, count)]);
        BallState[] turned = Row(order.Distinct().Count() == count ? order : [.. Enumerable.Range(0, count).Reverse()]);
        for (int i = 0; i < count; i++)
        {
            Assert.True(Snapshot.Same(in states[i], in turned[i]), $"ball {i}: {Snapshot.Difference(in states[i], in turned[i])}");
            double gap = i == 0 ? 0 : Vector3d.Distance(states[i].Position, states[i - 1].Position) - (2 * BallProperties.Tunnel.Radius);
            Assert.InRange(gap, -1e-7, 1e-3);
        }

        BallState[] Row(int[] places)
        {
            BallProperties[] kinds = [.. places.Select(i => BallProperties.Tunnel with { Mass = 0.2 + (0.1 * i) })];
            double r = kinds[0].Radius;
            var group = new BallGroup(new Scene { Air = new Air { Wind = new Vector3d(0.5, 0, 2) }, Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = s_normal } }, kinds);
            Vector3d velocity = 4 * s_down;
            BallState[] balls = [.. places.Select((place, i) =>
                group.SimulatorOf(i).Launch((r * s_normal) - (2 * place * r * s_down), velocity, Vector3d.Cross(s_normal, velocity) / r))];
            for (int i = 0; i < 40; i++)
            {
                group.Step(balls, 0.01, new StepLog());
            }

            return [.. Enumerable.Range(0, count).Select(place => balls[Array.IndexOf(places, place)])];
        }
    }
}
