using System.Reflection;
using System.Runtime.Loader;
using System.Runtime;

namespace FootballPhysics.Tests.Game;

/// <summary>Plays a scene right after its warm-up, in copies of this assembly and of the library in which no method is compiled yet.</summary>
internal static class FirstPlay
{
    private const double Frame = 1.0 / 60.0;
    private const int Frames = 240;

    /// <summary>Returns how many methods the play compiles.</summary>
    public static long Compiles(string kind)
    {
        var copy = new Copy();
        Type type = copy.LoadFromAssemblyPath(typeof(FirstPlay).Assembly.Location).GetType(typeof(FirstPlay).FullName!, throwOnError: true)!;
        return (long)type.GetMethod(nameof(WarmUpAndPlay), BindingFlags.Static | BindingFlags.NonPublic)!.Invoke(null, [kind])!;
    }

    private static long WarmUpAndPlay(string kind)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot, kind.Contains("mass", StringComparison.Ordinal) ? 75 : double.PositiveInfinity);
        Simulator simulator = SimulatorOf(kind, bodies);
        simulator.WarmUp();
        var group = new BallGroup(simulator, 2);
        var path = new Trajectory();
        var log = new StepLog();

        // Compiles this method itself.
        Play(kind, simulator, group, player, path, log, 0);
        long before = JitInfo.GetCompiledMethodCount(currentThread: true);
        Play(kind, simulator, group, player, path, log, Frames);
        return JitInfo.GetCompiledMethodCount(currentThread: true) - before;
    }

    private static Simulator SimulatorOf(string kind, KinematicBodies bodies)
    {
        Obstacle board = Board("board", new BoxShape(new Vector3d(0, 0.5, -5.05), new Vector3d(50, 0.5, 0.05)));
        Obstacle[] obstacles = kind.Contains("corner", StringComparison.Ordinal) ? [board, Board("side", new BoxShape(new Vector3d(-0.2, 0.5, 0), new Vector3d(0.05, 0.5, 50)))]
            : kind.Contains("gutter", StringComparison.Ordinal) ? [Slope("left", 1), Slope("right", -1)]
            : [board];
        Scene scene = Pitch.Stadium.On(new Scene { Bodies = bodies, Obstacles = obstacles });
        scene = kind.Contains("published", StringComparison.Ordinal) ? Scene.Published with { Bodies = bodies, Obstacles = obstacles } : scene;
        scene = kind.Contains("net", StringComparison.Ordinal) ? scene with { Goals = [new Goal { Center = new Vector3d(0, 0, -4), Facing = new Vector3d(0, 0, 1) }] } : scene;
        return new Simulator(kind.Contains("wind", StringComparison.Ordinal) ? scene with { Air = scene.Air with { Wind = new Vector3d(1, 0, -6.5) } } : scene);
    }

    private static Obstacle Board(string name, IShape shape) => new() { Name = name, Shape = shape, Surface = SurfaceMaterial.Board };

    private static Obstacle Slope(string name, double side) => Board(name, new PlaneShape(new Vector3d(0, 0.05, -4.7), new Vector3d(side, 1, 0)));

    /// <summary>A player presses the ball to the board; then it is kicked.</summary>
    private static void Play(string kind, Simulator simulator, BallGroup group, KinematicBody player, Trajectory path, StepLog log, int frames)
    {
        bool isGroup = kind.Contains("group", StringComparison.Ordinal);
        bool isShot = kind.Contains("net", StringComparison.Ordinal);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, -4.7), Vector3d.Zero, Vector3d.Zero);
        ball = isShot ? simulator.Launch(new Vector3d(1, 0.11, -3), new Vector3d(1, 4, -15), Vector3d.Zero) : ball;
        BallState[] balls = [ball, simulator.Launch(new Vector3d(0.3, 0.11, -4.6), Vector3d.Zero, Vector3d.Zero)];
        var at = new Vector3d(0.04, 0, -3.5);
        for (int i = 0; i < frames; i++)
        {
            Vector3d velocity = at.Z > -4.9 ? new Vector3d(0, 0, -1.5) : Vector3d.Zero;
            player.MoveTo(at, velocity, balls[0].Time);
            at += Frame * velocity;
            log.Clear();
            if (i == 2 * Frames / 3)
            {
                simulator.Kick(ref balls[0], new Vector3d(2, 2, -4), Vector3d.Zero);
                simulator.LookAhead(in balls[0], new LookAheadRequest { Duration = 0.3 }, path);
            }

            if (isGroup)
            {
                group.Step(balls, Frame, log);
            }
            else
            {
                simulator.Step(ref balls[0], Frame, log);
            }
        }
    }

    /// <summary>Loads this assembly and the library again; the runtime and all else is shared.</summary>
    private sealed class Copy() : AssemblyLoadContext(nameof(FirstPlay))
    {
        protected override Assembly? Load(AssemblyName assemblyName) =>
            assemblyName.Name == typeof(Simulator).Assembly.GetName().Name ? LoadFromAssemblyPath(typeof(Simulator).Assembly.Location) : null;
    }
}
