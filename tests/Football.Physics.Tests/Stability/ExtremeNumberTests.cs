using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>Numbers that are allowed lead to a ball that is somewhere, however large or small they are.</summary>
public sealed class ExtremeNumberTests
{
    private static readonly double[] s_tiny = [0, double.Epsilon, 1e-320, 1e-200, 1e-160, 1e-154, 1e-140, 1e-100, 1e-30];

    public static TheoryData<Integrator> Integrators() => [.. Enum.GetValues<Integrator>()];

    [Theory]
    [MemberData(nameof(Integrators))]
    public void Spins_and_speeds_whose_squares_vanish_stay_finite(Integrator integrator)
    {
        foreach (Scene scene in Scenes())
        {
            var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
            foreach (double height in (double[])[0.11, 0.5])
            {
                foreach (double speed in (double[])[.. s_tiny, 5])
                {
                    foreach (double spin in (double[])[.. s_tiny, 40])
                    {
                        for (int direction = 0; direction < 6; direction++)
                        {
                            Vector3d along = Axis(direction % 3) + (direction >= 3 ? Axis((direction + 1) % 3) : Vector3d.Zero);
                            BallState state = simulator.Launch(new Vector3d(0, height, 0), speed * Axis(0), spin * along);
                            Stays(simulator, state, [0.01, 0.01, 0.3, 0.3]);
                        }
                    }
                }
            }
        }
    }

    /// <summary>Every number of the scene at one end or the other of its range, or where it usually is.</summary>
    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void Scenes_at_the_ends_of_all_ranges_stay_finite(Profile profile, Integrator integrator)
    {
        var random = new FootballPhysics.Yardsticks.SeededRandom((int)integrator);
        int refused = 0;
        for (int i = 0; i < 500; i++)
        {
            double Any(double low, double usual, double high) => random.Chance(0.4) ? usual : random.Any(low, high);
            ForceLaw Law() => (ForceLaw)random.Below(3);
            var scene = profile.Scene() with
            {
                Ball = new BallProperties { Mass = random.Any(0.001, 0.01, 0.43, 0.43, 10, 100), Radius = Any(0.02, 0.11, 5), InertiaFactor = Any(0.1, 0.4, 1) },
                Air = new Air { Density = Any(0, 1.2, 100), KinematicViscosity = Any(1e-7, 1.5e-5, 0.1), Wind = new Vector3d(Any(-500, 0, 500), Any(-500, 0, 500), 0) },
                Gravity = Any(0, 9.81, 1000),
                Forces = profile.Forces() with
                {
                    Drag = Law(),
                    Magnus = Law(),
                    SpinDecay = Law(),
                    Coefficients = (AerodynamicModel)random.Below(2),
                    DragCoefficient = Any(0, 0.25, 10),
                    MagnusCoefficient = Any(-10, 0.25, 10),
                    SpinDecayCoefficient = Any(0, 1e-7, 1),
                },
                Ground = profile.Ground() with
                {
                    Material = profile.Ground().Material with
                    {
                        NormalRestitution = Any(0, 0.6, 1),
                        SpinRestitution = Any(0, 0.8, 1),
                        SlidingFriction = Any(0, 0.5, 10),
                        RollingResistance = Any(0, 0.05, 10),
                        SpinDamping = Any(0, 0.0001, 1),
                    },
                    MinimumBounceSpeed = Any(0.001, 0.2, 10),
                    RestEnergy = Any(1e-12, 1e-4, 100),
                    Height = Any(-9e5, 0, 9e5),
                },
            };
            Simulator simulator;
            try
            {
                simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
            }
            catch (ArgumentOutOfRangeException)
            {
                // Each number is allowed, but not with the others.
                refused++;
                continue;
            }

            double up = random.Any(0.0, 1e-9, 3, 900);
            BallState state = simulator.Launch(
                new Vector3d(0, Math.Min(1e6, simulator.ContactHeight + up), 0), Any(1e-200, 20, 999) * random.Direction(), Any(1e-200, 50, 9999) * random.Direction());
            Stays(simulator, state, [0.01, 0.1, 1]);
        }

        Assert.InRange(refused, 1, 250);
    }

    /// <summary>One scene of each kind that a ball with a spin of 1e-200 rad/s once left as NaN.</summary>
    [Theory]
    [ProfileData]
    public void A_slide_without_friction_and_with_hardly_a_spin_stays_finite(Profile profile)
    {
        Scene scene = profile.Scene() with { Ground = profile.Ground() with { Material = profile.Ground().Material with { SlidingFriction = 0 } } };
        foreach (double spin in (double[])[1e-200, -1e-200])
        {
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, 0, 0), new Vector3d(spin, spin, spin));
            Assert.Equal(MotionState.Sliding, state.Motion);
            Stays(simulator, state, [0.01, 0.01, 0.01, 1, 1]);
        }
    }

    [Theory]
    [ProfileData]
    public void A_spin_that_has_hardly_a_digit_left_ends(Profile profile)
    {
        var simulator = new Simulator(profile.Scene());
        foreach (double spin in (double[])[double.Epsilon, 2e-323, 1e-322, 1e-321, 1e-310, 1e-300])
        {
            BallState state = simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(10, 3, 3), Vector3d.Up);
            state.SpinRate = spin;
            Stays(simulator, state, [0.01, 0.01, 0.3]);
        }
    }

    private static void Stays(Simulator simulator, BallState state, double[] steps)
    {
        var log = new StepLog(1);
        foreach (double step in steps)
        {
            BallState before = state;
            simulator.Step(ref state, step, log);
            Assert.True(
                state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && Math.Abs(state.Orientation.LengthSquared - 1) < 1e-6,
                $"{simulator.Scene}, {simulator.Settings.Integrator}: {before.Motion} {before.Velocity} {before.Spin} in {step} s to {state.Position} {state.Velocity} {state.Spin}");
        }
    }

    private static Vector3d Axis(int axis) => axis switch { 0 => new Vector3d(1, 0, 0), 1 => Vector3d.Up, _ => new Vector3d(0, 0, 1) };

    private static IEnumerable<Scene> Scenes() =>
        (from friction in (double[])[0, 0.5]
         from forces in (ForceSet[])[ForceSet.Published, ForceSet.Regularized, ForceSet.Constant with { SpinDecayCoefficient = 1e-4 }, ForceSet.None]
         select Scene.Published with { Forces = forces, Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { SlidingFriction = friction } } })
        .Append(new Scene());
}
