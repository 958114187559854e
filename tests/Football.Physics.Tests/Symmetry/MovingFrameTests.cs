using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Symmetry;

/// <summary>Without air, a scene whose objects all move at one velocity is the scene that stands still, seen from a frame that moves.</summary>
public sealed class MovingFrameTests
{
    private const double Radius = 0.11;
    private const double Step = 0.01;

    private static readonly Vector3d s_frame = new(1.5, 0.2, -0.8);

    public static TheoryData<string> Scenes => ["dome", "bowl of planes", "dome and wall", "corner", "posts", "turntable", "roller"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_ball_moves_as_in_the_scene_that_stands_still(string name)
    {
        var random = new Random(name.Length);
        for (int draw = 0; draw < 6; draw++)
        {
            double Any(double low, double high) => low + ((high - low) * random.NextDouble());
            Obstacle[] things = [.. ThingsOf(name).Select((at, i) => at with { Name = $"{i}" })];
            var position = new Vector3d(Any(-0.05, 0.05), StartOf(name), Any(-0.05, 0.05));
            var velocity = new Vector3d(Any(-2, 2), name == "posts" ? 3 : 0, Any(-2, 2));
            var spin = new Vector3d(Any(-20, 20), Any(-20, 20), Any(-20, 20));
            Scene still = new() { Air = new Air { Density = 0 }, Ball = new BallProperties { Radius = Radius }, Ground = Ground.None, Obstacles = things };
            Scene moving = still with { Obstacles = [.. things.Select(at => at with { Velocity = s_frame })] };
            BallState one = Play(still, position, velocity, spin, 60, out StepLog log);
            BallState other = Play(moving, position, velocity + s_frame, spin, 60, out StepLog its);
            string when = FormattableString.Invariant($"{name}, draw {draw}: {one:R} and {other:R}, {string.Join(' ', Flight.Kinds(log))} and {string.Join(' ', Flight.Kinds(its))}");

            // Surfaces that are hit within a millisecond of each other are solved together if one moves, or one after the other.
            bool isRough = name is "dome and wall";
            double within = isRough ? 1e-2 : 1e-5;
            Assert.True(Vector3d.Distance(one.Position + (one.Time * s_frame), other.Position) < within, when);
            Assert.True(Vector3d.Distance(one.Velocity + s_frame, other.Velocity) < 10 * within, when);
            Assert.True(Vector3d.Distance(one.Spin, other.Spin) < 100 * within, when);
            Assert.True(isRough || Flight.Kinds(log).SequenceEqual(Flight.Kinds(its)), when);
        }
    }

    private static BallState Play(Scene scene, Vector3d position, Vector3d velocity, Vector3d spin, int steps, out StepLog log)
    {
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(position, velocity, spin);
        log = new StepLog();
        for (int i = 0; i < steps; i++)
        {
            simulator.Step(ref s, Step, log);
        }

        return s;
    }

    private static double StartOf(string name) => name is "posts" ? 0.5 : Radius;

    private static Obstacle[] ThingsOf(string name)
    {
        SurfaceMaterial rough = SurfaceMaterial.DryTurf with { TorsionalPatchRadius = 0.02, SpinDamping = 1e-4 };
        var floor = new Obstacle { Shape = new PlaneShape(Vector3d.Zero, new Vector3d(0.05, 1, 0).Normalized()), Surface = rough };
        var dome = new Obstacle { Shape = new SphereShape(new Vector3d(0, -8, 0), 8), Surface = rough };
        var wall = new Obstacle { Shape = new BoxShape(new Vector3d(0.6, 0, 0), new Vector3d(0.2, 1, 9)), Surface = SurfaceMaterial.Board };
        return name switch
        {
            "dome" => [dome],
            "bowl of planes" => [floor, new() { Shape = new PlaneShape(new Vector3d(-0.5, 0, 0), new Vector3d(0.5, 1, 0).Normalized()), Surface = rough }],
            "dome and wall" => [dome, wall],
            "corner" => [floor, wall, new() { Shape = new BoxShape(new Vector3d(0, 0, 0.7), new Vector3d(9, 1, 0.2)), Surface = SurfaceMaterial.Board }],
            "posts" => [floor, wall, new() { Shape = new CapsuleShape(new Vector3d(-0.5, -1, -3), new Vector3d(-0.3, 3, 3), 0.06) }, new() { Shape = new SphereShape(new Vector3d(0.1, 0, 0.7), 0.3) }],
            "turntable" => [floor with { Spin = new Vector3d(0, 3, 0) }],
            _ => [new() { Shape = new CapsuleShape(new Vector3d(0, -1, -5), new Vector3d(0, -1, 5), 1), Surface = rough, Spin = new Vector3d(0, 0, 2), Pivot = new Vector3d(0, -1, 0) }],
        };
    }
}
