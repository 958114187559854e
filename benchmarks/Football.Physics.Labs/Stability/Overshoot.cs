using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs.Stability;

/// <summary>Computes the step from which drag overshoots, by method, and the number of parts into which the library divides a longer step.</summary>
internal static class Overshoot
{
    private const double Speed = 200;
    private const double LongStep = 1;

    /// <summary>z = |u| Δt ½ρC_D A/m; a beach ball at 200 m/s.</summary>
    public static void AddTable(LabRun run)
    {
        LabTable table = run.Table(
            "drag overshoots from this step on (beach ball, 200 m/s, C_D 0.25)",
            "method", "reverses from z", "grows from z", "z = 1 at, ms", "reverses at, ms", "parts of a 1 s step", "speed after, m/s");
        Scene scene = Scene.Published with
        {
            Ball = BallProperties.BeachBall,
            Gravity = 0,
            Forces = ForceSet.None with { Drag = ForceLaw.Constant },
        };
        double k = 0.5 * scene.Air.Density * scene.Forces.DragCoefficient * Math.PI * scene.Ball.Radius * scene.Ball.Radius / scene.Ball.Mass;
        foreach (Integrator method in StressGenerator.Integrators)
        {
            double reverses = First(method, u => u < 0);
            double grows = First(method, u => Math.Abs(u) > 1);
            var simulator = new Simulator(scene, new SolverSettings { Integrator = method });
            BallState state = simulator.Launch(new Vector3d(0, 100, 0), new Vector3d(Speed, 0, 0), Vector3d.Zero);
            var log = new StepLog();
            simulator.Step(ref state, LongStep, log);
            table.Add(method, reverses, grows, 1e3 / (k * Speed), double.IsNaN(reverses) ? double.NaN : 1e3 * reverses / (k * Speed), log.Steps, state.Velocity.X);
        }

        table.Add("exact", double.NaN, double.NaN, double.NaN, double.NaN, null, Speed / (1 + (k * Speed * LongStep)));
    }

    /// <summary>Draws the speed after one undivided step over its length, both as shares, to show where a method reverses and increases the speed.</summary>
    public static XElement Draw()
    {
        const int Points = 300;
        const double Longest = 3;
        double[] lengths = [.. Enumerable.Range(0, Points + 1).Select(i => Longest * i / Points)];
        var chart = new Chart(new Axis("z = |u| Δt ½ρC_D A/m"), new Axis("speed after the step, as a share") { Min = -2, Max = 2 })
        {
            Title = "Drag overshoots in a step that is not divided",
        };
        foreach (Integrator method in StressGenerator.Integrators)
        {
            // Both Euler methods have the same effect on a speed: the second is dashed over the first.
            chart.Items.Add(new PolylineItem([.. lengths.Select(z => new PlotPoint(z, Step(method, z)))])
            {
                Colour = Palette.Series[(int)method],
                Label = method.ToString(),
                Dash = method == Integrator.SemiImplicitEuler ? "4 3" : "none",
            });
        }

        chart.Items.Add(new PolylineItem([.. lengths.Select(z => new PlotPoint(z, 1 / (1 + z)))]) { Colour = Palette.Ink, Label = "exact", Dash = "1 2" });
        return chart.Draw();
    }

    /// <summary>Returns the least z at which one step of u̇ = −|u| u from u = 1 is wrong.</summary>
    private static double First(Integrator method, Func<double, bool> wrong) =>
        Enumerable.Range(1, 1000).Select(i => i * 0.01).FirstOrDefault(z => wrong(Step(method, z + 1e-9)), double.NaN);

    private static double Step(Integrator method, double h)
    {
        static double F(double u) => -Math.Abs(u) * u;
        double k1 = F(1);
        double k2 = F(1 + (0.5 * h * k1));
        double k3 = F(1 + (0.5 * h * k2));
        return method switch
        {
            Integrator.Rk2 => 1 + (h * k2),
            Integrator.Rk4 => 1 + (h / 6 * (k1 + (2 * k2) + (2 * k3) + F(1 + (h * k3)))),
            _ => 1 + (h * k1),
        };
    }
}
