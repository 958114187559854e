using FootballPhysics.Tests.Support;
using FootballPhysics.Tests.Things;

namespace FootballPhysics.Tests.Motion;

/// <summary>Explicit Euler comes down from a hop faster than it went up. Bounces end all the same: on objects, and on slopes.</summary>
public sealed class HopTests
{
    private const double Radius = 0.11;

    public static TheoryData<string, double> Supports()
    {
        var cases = new TheoryData<string, double>();
        foreach (string support in new[] { "table", "body", "engine", "slope", "heights" })
        {
            foreach (double dt in new[] { 0.001, 0.005, 1 / 60.0, 0.05 })
            {
                cases.Add(support, dt);
            }
        }

        return cases;
    }

    [Theory]
    [MemberData(nameof(Supports))]
    public void Every_method_s_bounces_end(string support, double dt)
    {
        foreach (SurfaceMaterial material in new[] { SurfaceMaterial.MatchTurf, SurfaceMaterial.Wood, SurfaceMaterial.Concrete, SurfaceMaterial.MatchTurf with { NormalRestitution = 0.9, GrazingRestitutionGain = 0 } })
        {
            foreach (Integrator integrator in new[] { Integrator.Euler, Integrator.SemiImplicitEuler, Integrator.Rk2, Integrator.Rk4 })
            {
                var scene = new Scene { Ground = Ground.None };
                PosedCollider? posed = null;
                var table = new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(200, 0.5, 200));
                switch (support)
                {
                    case "table":
                        scene = scene with { Obstacles = [new Obstacle { Name = "table", Shape = table, Surface = material }] };
                        break;
                    case "body":
                    case "engine":
                        posed = PosedCollider.In(ref scene, table, material, support == "engine");
                        break;
                    case "slope":
                        scene = scene with { Ground = Ground.Of(material) with { Height = 1, Normal = new Vector3d(0.1, 1, 0).Normalized() } };
                        break;
                    default:
                        var heights = new double[9, 9];
                        for (int i = 0; i < 81; i++)
                        {
                            heights[i / 9, i % 9] = 1 + (0.2 * Math.Sin(1 + i));
                        }

                        scene = scene with { Ground = Ground.Of(material) with { Heights = HeightField.FromControlValues(-40, -40, 10, heights) } };
                        break;
                }

                var simulator = new Simulator(scene, Flight.With(integrator));
                BallState state = simulator.Launch(new Vector3d(0, 1 + Radius + 0.5, 0), new Vector3d(0.3, 0, 0.1), default);
                var log = new StepLog();
                double last = 0;
                while (state.Time < 60 && state.Motion != MotionState.Rest)
                {
                    posed?.MoveTo(default, Quaterniond.Identity, default, default, state.Time);
                    log.Clear();
                    simulator.Step(ref state, dt, log);
                    last = state.Motion == MotionState.Airborne ? state.Time : last;
                }

                Assert.True(last < 40, $"{integrator} on {material.NormalRestitution}: in the air at {last} s");
            }
        }
    }
}
