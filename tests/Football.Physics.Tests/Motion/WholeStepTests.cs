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
