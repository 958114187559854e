namespace FootballPhysics;

/// <summary>Scenes of their own in which a warm-up plays what seldom happens: so that no frame of a game has to compile its code.</summary>
internal static class WarmUpScenes
{
    private const double Frame = 1.0 / 60.0;
    private const int PressedFrames = 60;
    private const int ShotFrames = 240;

    /// <summary>A player without end walks at a ball before a board, and stands; one of finite mass is pushed; what two things squeeze has no room.</summary>
    public static void Press(SolverSettings settings, StepLog log)
    {
        var press = new Obstacle { Name = "press", Shape = new SphereShape(new Vector3d(0, 0.2, 0.4), 0.25), Velocity = new Vector3d(0, 0, -1) };
        var wall = new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -0.3), new Vector3d(0, 0, 1)) };
        var squeezing = new Simulator(new Scene { Obstacles = [wall, press] }, settings);
        BallState ball = squeezing.Launch(new Vector3d(0.02, squeezing.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
        Play(squeezing, ref ball, PressedFrames, log);

        // A board at the ball, a player who comes, and another one who is pushed off. In the end all stand, and the ball rests among them.
        foreach (double mass in (double[])[double.PositiveInfinity, 75])
        {
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot, mass);
            var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.35), new Vector3d(5, 0.5, 0.05)), Surface = SurfaceMaterial.Board };
            var box = new Obstacle { Name = "box", Shape = new BoxShape(new Vector3d(0.8, 0.2, 0.3), new Vector3d(0.2, 0.2, 0.2)), Surface = SurfaceMaterial.Wood, Mass = 5 };
            var simulator = new Simulator(new Scene { Bodies = bodies, Obstacles = [board, box] }, settings);
            ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
            var at = new Vector3d(0.04, 0, 1);
            for (int i = 0; i < 3 * PressedFrames; i++)
            {
                Vector3d velocity = at.Z > 0.1 ? new Vector3d(0, 0, -1.5) : Vector3d.Zero;
                player.MoveTo(at, velocity, ball.Time);
                at += Frame * velocity;
                Play(simulator, ref ball, 1, log);
            }

            // Onto the box, which gives way.
            simulator.Kick(ref ball, new Vector3d(6, 0.5, 1), Vector3d.Zero);
            Play(simulator, ref ball, PressedFrames, log);
        }
    }

    /// <summary>A shot into a goal: mouth, line, nets, and rest in them.</summary>
    public static void Net(SolverSettings settings, StepLog log)
    {
        var simulator = new Simulator(new Scene { Goals = [new Goal { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1) }] }, settings);
        BallState ball = simulator.Launch(new Vector3d(0.5, simulator.ContactHeight, 3), new Vector3d(0, 2, -15), Vector3d.Zero);
        Play(simulator, ref ball, ShotFrames, log);
        ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 3), new Vector3d(-12, 1, -12), Vector3d.Zero);
        Play(simulator, ref ball, PressedFrames, log);
    }

    /// <summary>Three balls, of which two meet in the air, and come to lie on the third.</summary>
    public static void Group(SolverSettings settings, StepLog log)
    {
        var simulator = new Simulator(null, settings);
        var group = new BallGroup(simulator, 3);
        BallState[] balls =
        [
            simulator.Launch(new Vector3d(-1, 0.6, 0), new Vector3d(4, 0, 0), Vector3d.Zero),
            simulator.Launch(new Vector3d(1, 0.6, 0.02), new Vector3d(-4, 0, 0), Vector3d.Zero),
            simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0.03), Vector3d.Zero, Vector3d.Zero),
        ];
        for (int i = 0; i < PressedFrames; i++)
        {
            log.Clear();
            group.Step(balls, Frame, log);
        }

        group.LookAhead(balls, new LookAheadRequest { Duration = 0.2 }, [new Trajectory(), new Trajectory(), new Trajectory()]);
    }

    private static void Play(Simulator simulator, ref BallState ball, int frames, StepLog log)
    {
        for (int i = 0; i < frames; i++)
        {
            log.Clear();
            simulator.Step(ref ball, Frame, log);
        }
    }
}
