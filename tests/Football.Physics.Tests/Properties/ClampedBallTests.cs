using CsCheck;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Properties;

/// <summary>A ball that two opposite surfaces touch: however large the loads could be, friction only brakes it.</summary>
public sealed class ClampedBallTests
{
    private const int Scenes = 2000;
    private const int Steps = 12;
    private const double Step = 1 / 60.0;

    /// <summary>The error of the integrator, relative to the energies of the scene.</summary>
    private const double IntegrationError = 1e-5;

    private static readonly Vector3d s_start = new(0, 1, 0);

    /// <summary>A plane or a sphere, its size, and its material.</summary>
    private static readonly Gen<(int Kind, double Size, SurfaceMaterial Surface)> s_jaw = Gen.Select(Gen.Int[0, 1], Gen.Double[0.02, 2], Drawn.Surface, (kind, size, surface) => (kind, size, surface with { NormalRestitution = 0.9 * surface.NormalRestitution }));

    /// <summary>The gap, the deviation of one normal from the opposite of the other, rad, and the speed of the ball, m/s.</summary>
    private static readonly Gen<(double Gap, double Skew, double Speed)> s_fit = Gen.Select(Gen.OneOfConst(0, 1e-12, 5e-11), Gen.OneOfConst(0, 1e-9, 1e-6, 1e-4, 1e-2), Gen.OneOfConst(0, 1e-9, 1e-4, 1, 10));

    [Fact]
    public void A_clamped_ball_never_gains_energy() =>
        Gen.Select(s_jaw, s_jaw, Drawn.Direction, s_fit, Drawn.Direction, Drawn.Vector(80)).Sample(
            (one, other, normal, fit, direction, spin) =>
            {
                Vector3d across = Vector3d.Cross(normal, Math.Abs(normal.X) < 0.6 ? new Vector3d(1, 0, 0) : Vector3d.Up).Normalized();
                Vector3d opposite = ((-Math.Cos(fit.Skew) * normal) + (Math.Sin(fit.Skew) * across)).Normalized();
                Play([Jaw(one, normal, 0), Jaw(other, opposite, fit.Gap)], fit.Speed * direction, spin);
            },
            iter: Scenes);

    /// <summary>A ball without velocity spins between two spheres, both of which grip more than they press: the upper one need not press at all.</summary>
    [Fact]
    public void A_ball_that_spins_between_two_spheres_never_gains_energy()
    {
        SurfaceMaterial low = SurfaceMaterial.GoalFrame with { NormalRestitution = 0, SlidingFriction = 1.3, ImpactFriction = 1.3 };
        SurfaceMaterial high = low with { SlidingFriction = 1.9, ImpactFriction = double.PositiveInfinity };
        Play([Jaw((1, 0.875, low), Vector3d.Up, 0), Jaw((1, 1.3, high), -Vector3d.Up, 0)], Vector3d.Zero, new Vector3d(70, 0, 0.56));
    }

    /// <summary>Three balls in a row between two opposite planes, each with a spin of its own.</summary>
    [Fact]
    public void Clamped_balls_in_a_row_never_gain_energy() =>
        Gen.Select(Drawn.Surface, Drawn.Surface, Drawn.Direction, s_fit, Drawn.Vector(80), Drawn.Vector(80), Drawn.Vector(80)).Sample(
            (one, other, normal, fit, first, second, third) =>
            {
                double radius = Scene.Default.Ball.Radius;
                Obstacle[] jaws = [Jaw((0, 1, one), normal, 0), new Obstacle { Name = "jaw", Shape = new PlaneShape(s_start + (((5 * radius) + fit.Gap) * normal), -normal), Surface = other }];
                Scene scene = Scene.Default with { Ground = Ground.None, Obstacles = jaws };
                var simulator = new Simulator(scene);
                BallState[] states =
                [
                    simulator.Launch(s_start, Vector3d.Zero, first),
                    simulator.Launch(s_start + (2 * radius * normal), Vector3d.Zero, second),
                    simulator.Launch(s_start + (4 * radius * normal), Vector3d.Zero, third),
                ];
                var group = new BallGroup(simulator, states.Length);
                var log = new StepLog(1);
                NeverGains(() => states.Sum(state => Energy(scene, in state)), () => group.Step(states, Step, log));
            },
            iter: Scenes);

    private static Obstacle Jaw((int Kind, double Size, SurfaceMaterial Surface) jaw, Vector3d normal, double gap)
    {
        Vector3d nearest = s_start - ((Scene.Default.Ball.Radius + gap) * normal);
        return new Obstacle { Name = "jaw", Shape = jaw.Kind == 0 ? new PlaneShape(nearest, normal) : new SphereShape(nearest - (jaw.Size * normal), jaw.Size), Surface = jaw.Surface };
    }

    private static void Play(Obstacle[] jaws, Vector3d velocity, Vector3d spin)
    {
        Scene scene = Scene.Default with { Ground = Ground.None, Obstacles = jaws };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(s_start, velocity, spin);
        var log = new StepLog(1);
        NeverGains(() => Energy(scene, in state), () => simulator.Step(ref state, Step, log));
    }

    private static double Energy(Scene scene, in BallState state)
    {
        BallProperties ball = scene.Ball;
        double weight = ball.Mass * -(Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene));
        return (0.5 * ((ball.Mass * state.Velocity.LengthSquared) + (ball.MomentOfInertia * state.Spin.LengthSquared))) + (weight * state.Position.Y);
    }

    private static void NeverGains(Func<double> energyOf, Action step)
    {
        double least = double.PositiveInfinity;
        for (int i = 0; i <= Steps; i++)
        {
            double energy = energyOf();
            Assert.True(energy <= least + (IntegrationError * (1 + Math.Abs(least))), $"{least} J to {energy} J after {i} steps");
            least = Math.Min(least, energy);
            step();
        }
    }
}
