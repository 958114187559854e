using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>
/// On flat ground a step that nothing ends is taken whole; with a force of the game's own it is taken in pieces. Where that force is none, both are one motion.
/// </summary>
public sealed class WholeStepTests
{
    [Theory]
    [ProfileData(0, 0)]
    [ProfileData(0, 25)]
    [ProfileData(0.15, 0)]
    [ProfileData(0.15, 25)]
    [ProfileData(-0.3, 25)]
    public void A_force_that_is_none_changes_nothing(Profile profile, double slope, double about)
    {
        Scene scene = profile.Scene();
        var normal = new Vector3d(Math.Sin(slope), Math.Cos(slope), 0);
        scene = scene with
        {
            Air = new Air { Wind = new Vector3d(7, -5, 3) },
            Ground = scene.Ground with { Material = scene.Ground.Material with { SpinDamping = 1e-4 }, Normal = normal },
        };
        Scene nudged = scene with { Forces = scene.Forces with { CustomForces = [new Nothing()] } };
        Vector3d along = new Vector3d(normal.Y, -normal.X, 0);
        Vector3d across = Vector3d.Cross(in along, in normal);
        foreach (double speed in (double[])[4, 9])
        {
            Vector3d velocity = speed * ((0.6 * along) + (0.8 * across));
            Vector3d rolling = (Vector3d.Cross(in normal, in velocity) / Flight.Radius) + (about * normal);
            Same(scene, nudged, normal, velocity, rolling);
            Same(scene, nudged, normal, velocity, (0.1 * rolling) + (about * normal) + (20 * along));
        }
    }

    /// <summary>One step, from random slides and rolls on random planes and materials: the plane form is the law of any surface.</summary>
    [Theory]
    [ProfileData(Integrator.Euler)]
    [ProfileData(Integrator.SemiImplicitEuler)]
    [ProfileData(Integrator.Rk2)]
    [ProfileData(Integrator.Rk4)]
    public void The_plane_form_is_the_law_of_any_surface_over_its_domain(Profile profile, Integrator integrator)
    {
        var random = new Random(5);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        int compared = 0;
        for (int i = 0; i < 400; i++)
        {
            double slope = i % 3 == 0 ? 0 : Between(-0.5, 0.5);
            var normal = new Vector3d(Math.Sin(slope), Math.Cos(slope), 0);
            Scene scene = profile.Scene();
            SurfaceMaterial material = scene.Ground.Material with
            {
                SlidingFriction = Between(0.1, 1),
                RollingResistance = Between(0, 0.1),
                RollingResistancePerSpeed = Between(0, 0.01),
                SpinDamping = Between(0, 2e-4),
                TorsionalPatchRadius = Between(0, 0.02),
            };
            scene = scene with { Air = new Air { Wind = Between(0, 8) * Any(random) }, Ground = scene.Ground with { Material = material, Normal = normal } };
            Scene nudged = scene with { Forces = scene.Forces with { CustomForces = [new Nothing()] } };
            Vector3d any = Any(random);
            Vector3d velocity = Between(0.5, 35) * (any - (Vector3d.Dot(in any, in normal) * normal)).Normalized();
            Vector3d spin = (Vector3d.Cross(in normal, in velocity) / Flight.Radius) + (Between(-40, 40) * normal);
            spin = i % 2 == 0 ? spin : (Between(-1, 0.8) * spin) + (Between(-30, 30) * Any(random));
            compared += IsSameStep(scene, nudged, integrator, Flight.Radius / normal.Y * Vector3d.Up, velocity, spin) ? 1 : 0;
        }

        Assert.InRange(compared, 250, 400);
    }

    private static Vector3d Any(Random random) =>
        new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();

    /// <summary>Compares one step, where the pieces take it as one without an event.</summary>
    private static bool IsSameStep(Scene scene, Scene nudged, Integrator integrator, Vector3d start, Vector3d velocity, Vector3d spin)
    {
        var simulators = new[] { new Simulator(scene, Flight.With(integrator)), new Simulator(nudged, Flight.With(integrator)) };
        StepLog[] logs = [new(), new()];
        BallState[] states = [.. simulators.Select((simulator, i) =>
        {
            BallState state = simulator.Launch(start, velocity, spin);
            simulator.Step(ref state, 0.005, logs[i]);
            return state;
        })];
        if (logs.Any(log => log.Events.Count > 0 || log.Steps != 1) || states[0].Motion is not (MotionState.Rolling or MotionState.Sliding))
        {
            return false;
        }

        Assert.InRange(Vector3d.Distance(states[0].Position, states[1].Position), 0, 1e-9);
        Assert.InRange(Vector3d.Distance(states[0].Velocity, states[1].Velocity), 0, 1e-8);
        Assert.InRange(Vector3d.Distance(states[0].Spin, states[1].Spin), 0, 1e-7);

        // With Rk4, the plane form adds only two terms of the rotation's series while the axis turns little.
        Assert.InRange(Differences.Rotation(states[0].Orientation, states[1].Orientation), 0, integrator == Integrator.Rk4 ? 1e-5 : 1e-9);
        return true;
    }

    private static void Same(Scene scene, Scene nudged, in Vector3d normal, in Vector3d velocity, in Vector3d spin)
    {
        Vector3d start = Flight.Radius / normal.Y * Vector3d.Up;
        BallState whole = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.0025, 0.25, StopAt.Time, start, velocity, spin, out StepLog log);
        BallState pieces = Flight.Play(nudged, Flight.With(Integrator.Rk4), 0.0025, 0.25, StopAt.Time, start, velocity, spin, out StepLog asked);
        Assert.Equal(Flight.Kinds(asked), Flight.Kinds(log));
        Assert.Equal(pieces.Motion, whole.Motion);
        Assert.InRange(Vector3d.Distance(pieces.Position, whole.Position), 0, 1e-8);
        Assert.InRange(Vector3d.Distance(pieces.Velocity, whole.Velocity), 0, 1e-7);
        Assert.InRange(Vector3d.Distance(pieces.Spin, whole.Spin), 0, 1e-6);
        Assert.InRange(Differences.Rotation(pieces.Orientation, whole.Orientation), 0, 1e-6);
    }

    private sealed class Nothing : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
        }
    }
}
