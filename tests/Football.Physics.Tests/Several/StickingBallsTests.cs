using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls whose contact has an infinite impact friction: the surfaces stick. A contact without a load has no friction, and no state is ever NaN.</summary>
public sealed class StickingBallsTests
{
    private const double Step = 1.0 / 60;

    [Theory]
    [InlineData(double.PositiveInfinity, 0.0, 0.0)]
    [InlineData(double.PositiveInfinity, 1e-300, double.PositiveInfinity)]
    [InlineData(0.4, 0.0, 0.0)]
    [InlineData(0.4, 2.0, 0.8)]
    public void The_limit_of_friction_is_zero_without_a_load(double friction, double load, double most) => Assert.Equal(most, FrictionLaw.Limit(friction, load));

    /// <summary>Each published material has this friction. Balls that touch, and balls of a cloud, spin against each other and on the ground.</summary>
    [Theory]
    [InlineData("publishedTurf")]
    [InlineData("publishedWetTurf")]
    [InlineData("publishedSand")]
    [InlineData("publishedCourt")]
    [InlineData("ball")]
    public void A_group_stays_finite(string name)
    {
        SurfaceMaterial contact = name == "ball" ? SurfaceMaterial.Ball with { ImpactFriction = double.PositiveInfinity } : SurfaceMaterial.Presets[name];
        Assert.True(double.IsPositiveInfinity(contact.ImpactFriction));
        for (int draw = 0; draw < 24; draw++)
        {
            var random = new Random(draw);
            double Draw(double low, double high) => low + (random.NextDouble() * (high - low));
            Vector3d Any(double most) => new(Draw(-most, most), Draw(-most, most), Draw(-most, most));
            var group = new BallGroup(new Simulator(), 2 + (draw % 5), contact);
            BallState[] balls =
            [
                .. Enumerable.Range(0, group.Count).Select(i => group.SimulatorOf(i).Launch(
                    draw % 2 == 0 ? new Vector3d(0.2200001 * i, 0.11, 0.05 * i * i) : new Vector3d((0.3 * i) + Draw(0, 0.05), Draw(0.11, 0.6), Draw(-0.2, 0.2)),
                    i > 0 && draw % 2 == 0 ? Vector3d.Zero : Any(4),
                    Any(20))),
            ];
            var log = new StepLog();
            for (int i = 0; i < 90; i++)
            {
                log.Clear();
                group.Step(balls, Step, log);
                Assert.All(balls, ball => Assert.True(ball.Position.IsFinite && ball.Velocity.IsFinite && ball.Spin.IsFinite, $"draw {draw} step {i}: {ball}"));
            }
        }
    }

    /// <summary>A contact that closes its gap slowly bears nothing; with an infinite friction its impulses are still numbers.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(1e-3)]
    public void The_impulses_of_a_pile_are_numbers(double gap)
    {
        const double Mass = 0.43;
        const double Inertia = 2.0 / 3 * Mass * 0.11 * 0.11;
        var solver = new PileSystem { Count = 3 };
        for (int i = 0; i < 3; i++)
        {
            solver.Balls[i] = new PressedBall { PerMass = 1 / Mass, PerInertia = 1 / Inertia, InertiaFactor = 2.0 / 3, Radius = 0.11, V = new Vector3d(-0.01 * i, 0, 0), W = new Vector3d(0, 30, 5 * i) };
        }

        for (int i = 0; i < 2; i++)
        {
            solver.Add(new Contact
            {
                First = i + 1,
                Second = i,
                Collider = -1,
                Normal = new Vector3d(1, 0, 0),
                Gap = i * gap,
                NormalMass = Mass / 2,
                SlipMass = 0.5 / ((1 / Mass) + (0.11 * 0.11 / Inertia)),
                TwistMass = Inertia / 2,
                Material = new ContactMaterial { Resistance = new Resistance(double.PositiveInfinity, 0, 0, 0, 0.004) },
            });
        }

        solver.Solve(1e-3, 200, 1e-14);
        Vector3d momentum = Vector3d.Zero;
        for (int i = 0; i < 3; i++)
        {
            Assert.True(solver.Balls[i].V.IsFinite && solver.Balls[i].W.IsFinite);
            momentum += Mass * solver.Balls[i].V;
        }

        Assert.Equal(-0.03 * Mass, momentum.X, 1e-15);

        // The touching pair sticks.
        ref readonly PressedBall a = ref solver.Balls[0];
        ref readonly PressedBall b = ref solver.Balls[1];
        Vector3d slip = b.V - a.V - Vector3d.Cross(0.11 * (a.W + b.W), new Vector3d(1, 0, 0));
        Assert.InRange((slip - (slip.X * new Vector3d(1, 0, 0))).Length, 0, 1e-9);
    }

    /// <summary>A part that no round solves well is scaled. If only balls press each other, that keeps their momentum, and takes energy.</summary>
    [Fact]
    public void A_scaled_part_keeps_the_momentum_of_balls_alone()
    {
        const double Mass = 0.43;
        var solver = new PileSystem { Count = 2 };
        for (int i = 0; i < 2; i++)
        {
            solver.Balls[i] = new PressedBall { PerMass = 1 / Mass, PerInertia = 300, InertiaFactor = 2.0 / 3, Radius = 0.11, FreeV = new Vector3d(i == 0 ? 1 : 3, 0, 0), FreeW = new Vector3d(0, 2, 0) };
        }

        // An impulse that is too large: the balls separate faster than they closed.
        solver.Balls[0].V = new Vector3d(6, 0, 0);
        solver.Balls[1].V = new Vector3d(-2, 0, 0);
        solver.Balls[0].W = solver.Balls[1].W = new Vector3d(0, 2, 0);
        solver.Add(new Contact { First = 0, Second = 1, Collider = -1, Normal = new Vector3d(-1, 0, 0), NormalMass = Mass / 2, Load = 5 * Mass });
        solver.LimitWork();
        Assert.Equal(4.0, solver.Balls[0].V.X + solver.Balls[1].V.X, 1e-12);
        Assert.Equal(2.0, solver.Balls[0].V.X, 1e-12);
        Assert.Equal(new Vector3d(0, 2, 0), solver.Balls[0].W);
    }
}
