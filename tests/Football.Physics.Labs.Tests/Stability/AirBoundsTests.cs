using FootballPhysics.Labs.Stability;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>The bounds of the air that the stress matrix reckons with, against the laws and their slopes by differences.</summary>
public sealed class AirBoundsTests
{
    private const double Width = 0.02;
    private const double Difference = 1e-3;

    private static readonly double[] s_speeds = [0.3, 2, 5, 7.5, 9, 10, 11, 11.7, 12, 12.1, 12.3, 12.5, 13, 14, 16, 17.5, 19, 25, 40, 60];
    private static readonly double[] s_spins = [0.1, 1, 5.3, 7, 12, 30, 80, 200, 600];

    public static TheoryData<ForceLaw, AerodynamicModel> Laws() => new()
    {
        { ForceLaw.Empirical, AerodynamicModel.Published },
        { ForceLaw.Empirical, AerodynamicModel.Regularized },
        { ForceLaw.Constant, AerodynamicModel.Published },
    };

    [Theory]
    [MemberData(nameof(Laws))]
    public void Drag_keeps_within_its_bounds(ForceLaw law, AerodynamicModel form) => Holds(
        ForceSet.Published with { Drag = law, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None, Coefficients = form },
        (simulator, speed, spin) =>
        {
            simulator.AirFactors(speed, spin, out double drag, out _);
            return drag * speed;
        },
        (_, slope, perSpeed) => Math.Max(slope, perSpeed));

    [Theory]
    [MemberData(nameof(Laws))]
    public void The_Magnus_force_keeps_within_its_bounds(ForceLaw law, AerodynamicModel form) => Holds(
        ForceSet.Published with { Drag = ForceLaw.None, Magnus = law, SpinDecay = ForceLaw.None, Coefficients = form },
        (simulator, speed, spin) =>
        {
            simulator.AirFactors(speed, spin, out _, out double lift);
            return lift * speed;
        },
        (_, slope, perSpeed) => 0.5 * Math.Abs(slope - perSpeed));

    [Fact]
    public void The_spin_decays_no_faster_than_its_bound()
    {
        foreach (ForceLaw law in (ForceLaw[])[ForceLaw.Empirical, ForceLaw.Constant])
        {
            Scene scene = SceneOf(ForceSet.None with { Coefficients = AerodynamicModel.Published, SpinDecay = law, SpinDecayCoefficient = 1e-4 });
            var bounds = new AirBounds(scene);
            var simulator = new Simulator(scene);
            foreach (double speed in s_speeds)
            {
                foreach (double spin in s_spins)
                {
                    BallState state = simulator.Launch(new Vector3d(0, 50, 0), new Vector3d(speed, 0, 0), new Vector3d(0, spin, 0));
                    simulator.Step(ref state, 1e-5, new StepLog());
                    double share = (spin - state.Spin.Length) / spin / 1e-5;
                    double surface = scene.Ball.Radius * spin;
                    Assert.InRange(share / bounds.SpinDecay(speed, surface, surface), 0.3, 1.01);
                }
            }
        }
    }

    private static void Holds(ForceSet forces, Func<Simulator, double, double, double> acceleration, Func<double, double, double, double> stretch)
    {
        Scene scene = SceneOf(forces with { DragCoefficient = 0.4, MagnusCoefficient = -0.3 });
        var bounds = new AirBounds(scene);
        var simulator = new Simulator(scene);
        double r = scene.Ball.Radius;
        double closest = 0;
        foreach (double middle in s_speeds)
        {
            foreach (double spin in s_spins)
            {
                AirBound bound = bounds.Over(middle * (1 - Width), middle * (1 + Width), r * spin * (1 - Width), r * spin * (1 + Width));
                foreach (double share in (double[])[-0.9, -0.5, 0, 0.5, 0.9])
                {
                    double speed = middle * (1 + (share * Width));
                    double h = Difference * speed;
                    if (forces.Coefficients == AerodynamicModel.Published && Jumps(speed, h, r * spin))
                    {
                        continue;
                    }

                    double at = acceleration(simulator, speed, spin);
                    double below = acceleration(simulator, speed - h, spin);
                    double above = acceleration(simulator, speed + h, spin);
                    double slope = (above - below) / (2 * h);
                    double bend = (above - (2 * at) + below) / (h * h);
                    double bySpin = (acceleration(simulator, speed, spin * (1 + Difference)) - acceleration(simulator, speed, spin * (1 - Difference))) / (2 * Difference);
                    string what = $"{speed} m/s, {spin} rad/s";
                    Within(at, bound.Size, $"size at {what}");
                    Within(slope, bound.Slope, $"slope at {what}");
                    Within(at / speed, bound.Slope, $"turn at {what}");
                    Within(stretch(at, slope, at / speed), bound.Stretch, $"stretch at {what}");
                    Within(bend, bound.Curvature, $"curvature at {what}");
                    Within(bySpin, bound.BySpin, $"change by spin at {what}");
                    closest = Math.Max(closest, Math.Abs(at) / bound.Size);
                }
            }
        }

        Assert.InRange(closest, 0.8, 1.0001);
    }

    /// <summary>A ten-thousandth is for the differences.</summary>
    private static void Within(double actual, double bound, string what) =>
        Assert.True(Math.Abs(actual) <= (bound * 1.0001) + 1e-5, $"{what}: {actual}, bound {bound}");

    private static bool Jumps(double speed, double h, double surface) =>
        Math.Abs(speed - 12.19) < 2 * h || Math.Abs((surface / speed) - 0.05) < 4 * Difference * 0.05;

    private static Scene SceneOf(ForceSet forces) => Scene.Published with { Ball = new BallProperties { Mass = 0.3, Radius = 0.15 }, Forces = forces };
}
