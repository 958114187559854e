using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Symmetry;

/// <summary>Reflecting a scene and a kick reflects the result to the last bit.</summary>
public sealed class MirrorTests
{
    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    [Theory]
    [MemberData(nameof(Integrators))]
    public void A_mirrored_shot_is_the_mirror_of_the_shot_through_its_whole_life(Integrator integrator)
    {
        var random = new Shots(4);
        foreach (Scene scene in Scenes())
        {
            for (int i = 0; i < 6; i++)
            {
                Vector3d velocity = random.Velocity(4, 28, 0, 40);
                Vector3d spin = random.Uniform(0, 60) * random.Direction();
                Quaterniond orientation = Quaterniond.FromRotationVector(random.Uniform(0, 3) * random.Direction());
                var position = new Vector3d(random.Uniform(-9, 9), 0.11, random.Uniform(-9, 9));
                Compare(Mirror.InX, scene, Flight.With(integrator), position, velocity, spin, orientation);
                Compare(Mirror.InZ, scene, Flight.With(integrator), position, velocity, spin, orientation);
            }
        }
    }

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void The_other_ways_to_find_events_are_symmetric_too(Profile profile, Integrator integrator)
    {
        var settings = new SolverSettings
        {
            Integrator = integrator,
            CollisionTiming = CollisionTiming.Bisection,
            CollisionTolerance = 1e-4,
            RollingTransition = RollingTransition.Heuristic,
        };
        foreach (Mirror mirror in new[] { Mirror.InX, Mirror.InZ })
        {
            Compare(mirror, profile.Scene() with { Air = new Air { Wind = new Vector3d(3, 1, -4) } }, settings, new Vector3d(1, 0.11, 2), new Vector3d(9, 6, -3), new Vector3d(20, 9, -30), Quaterniond.Identity);
        }
    }

    [Theory]
    [ProfileData]
    public void A_shot_in_the_plane_of_the_mirror_stays_in_it(Profile profile)
    {
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(profile.Scene() with { Air = new Air { Wind = new Vector3d(0, 0, 5) } }, Flight.With(integrator));
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 8, -20), new Vector3d(-50, 0, 0));
            simulator.Run(ref state, 0.005, 30, StopAt.Rest, new StepLog());
            Assert.Equal(0, state.Position.X);
            Assert.Equal(MotionState.Rest, state.Motion);
        }
    }

    /// <summary>A turn about the vertical by a right angle, where both tangential restitutions are the same.</summary>
    [Theory]
    [ProfileData]
    public void A_turned_shot_is_the_turn_of_the_shot(Profile profile)
    {
        static Vector3d Turn(Vector3d v) => new(v.Z, v.Y, -v.X);
        var scene = profile.Scene() with { Air = new Air { Wind = new Vector3d(2, 0, -3) } };
        var velocity = new Vector3d(14, 7, 3);
        var spin = new Vector3d(5, 30, -20);
        BallState a = Flight.Play(scene, SolverSettings.Default, 0.01, 30, StopAt.Rest, new Vector3d(0, 0.11, 0), velocity, spin, out _);
        BallState b = Flight.Play(
            profile.Scene() with { Air = new Air { Wind = Turn(scene.Air.Wind) } }, SolverSettings.Default, 0.01, 30, StopAt.Rest, new Vector3d(0, 0.11, 0), Turn(velocity), Turn(spin), out _);
        Assert.InRange(Vector3d.Distance(Turn(a.Position), b.Position), 0, 1e-8);
    }

    private static IEnumerable<Scene> Scenes()
    {
        yield return Scene.Published;
        yield return Scene.Published with
        {
            Air = new Air { Wind = new Vector3d(5, 0.5, -7) },
            Ground = Ground.PublishedTurf with
            {
                Material = SurfaceMaterial.PublishedTurf with
                {
                    RollingResistance = 0.1,
                    TangentialRestitution = 0.7,
                },
                TangentialRestitutionZ = -0.2,
            },
        };
        yield return Scene.Published with { Air = new Air { Wind = new Vector3d(-3, 0, 1) }, Forces = ForceSet.Regularized };
        yield return new Scene();
        yield return new Scene { Air = new Air { Wind = new Vector3d(2, 0, -4) }, Ground = Ground.Presets["publishedWetTurf"] };
        yield return Scene.Published with { Forces = ForceSet.Constant with { SpinDecayCoefficient = 1e-4 }, Ground = Ground.Presets["publishedCourt"] };
    }

    private static void Compare(
        Mirror mirror, Scene scene, SolverSettings settings, Vector3d position, Vector3d velocity, Vector3d spin, Quaterniond orientation)
    {
        var here = new Simulator(scene, settings);
        var there = new Simulator(mirror.Scene(scene), settings);
        BallState a = here.Launch(position, velocity, spin, orientation);
        BallState b = there.Launch(mirror.Polar(position), mirror.Polar(velocity), mirror.Axial(spin), mirror.Rotation(orientation));
        var logA = new StepLog();
        var logB = new StepLog();
        for (int i = 0; i < 600; i++)
        {
            here.Step(ref a, 0.02, logA);
            there.Step(ref b, 0.02, logB);
            if (!Mirrored(mirror, in a, in b))
            {
                Assert.Fail($"mirror in {mirror}, {settings.Integrator}, step {i}, from {velocity}, {spin}: {a.Position} {a.Velocity} {a.Spin} {a.Orientation} and {b.Position} {b.Velocity} {b.Spin} {b.Orientation}");
            }
        }

        Assert.Equal(logA.Events.Count, logB.Events.Count);
        Assert.Equal(logA.Evaluations, logB.Evaluations);
        for (int i = 0; i < logA.Events.Count; i++)
        {
            BallEvent x = logA.Events[i];
            BallEvent y = logB.Events[i];
            Assert.Equal(x.Kind, y.Kind);
            Assert.Equal(x.Time, y.Time);
            Assert.Equal(mirror.Polar(x.Position), y.Position);
            Assert.True(mirror.Polar(x.VelocityBefore) + Vector3d.Zero == y.VelocityBefore + Vector3d.Zero);
            Assert.True(mirror.Axial(x.Spin) + Vector3d.Zero == y.Spin + Vector3d.Zero);
        }
    }

    private static bool Mirrored(Mirror mirror, in BallState a, in BallState b)
    {
        Quaterniond q = mirror.Rotation(a.Orientation);
        Quaterniond p = b.Orientation;
        return a.Motion == b.Motion && a.Time == b.Time
            && mirror.Polar(a.Position) == b.Position
            && mirror.Polar(a.Velocity) == b.Velocity
            && mirror.Axial(a.Spin) == b.Spin
            && q.X == p.X && q.Y == p.Y && q.Z == p.Z && q.W == p.W;
    }
}
