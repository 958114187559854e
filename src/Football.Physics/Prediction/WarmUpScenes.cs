namespace FootballPhysics.Prediction;

/// <summary>Separate scenes in which a warm-up runs rare code paths, so that no frame of a game has to compile them.</summary>
internal static class WarmUpScenes
{
    private const double Frame = 1.0 / 60.0;
    private const int PressedFrames = 60;
    private const int ShotFrames = 240;
    private const double PushedMass = 75;

    /// <summary>An immovable player presses a ball against a board, a movable one is pushed away, and two objects squeeze the ball.</summary>
    public static void Press(SolverSettings settings, StepLog log)
    {
        var press = new Obstacle { Name = "press", Shape = new SphereShape(new Vector3d(0, 0.2, 0.4), 0.25), Velocity = new Vector3d(0, 0, -1) };
        var wall = new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -0.3), new Vector3d(0, 0, 1)) };
        var squeezing = new Simulator(new Scene { Obstacles = [wall, press] }, settings);
        BallState ball = squeezing.Launch(new Vector3d(0.02, squeezing.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
        Play(squeezing, ref ball, PressedFrames, log);

        // Use a board with and without wind, and a corner. The last scenes need the general solver for several contacts, and two balls.
        var side = new Obstacle { Name = "side", Shape = new PlaneShape(new Vector3d(-0.5, 0, 0), new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.Board };
        var corner = new Scene { Obstacles = [side], Air = new Air { Wind = new Vector3d(-6, 0, -3) } };
        Walk(new Scene(), settings, double.PositiveInfinity, 1, log);
        Walk(new Scene(), settings, PushedMass, 1, log);
        Walk(new Scene { Air = new Air { Wind = new Vector3d(1, 0, -6.5) } }, settings, double.PositiveInfinity, 1, log);
        Walk(corner, settings, double.PositiveInfinity, 1, log);
        Walk(Scene.Published with { Obstacles = [side] }, settings, double.PositiveInfinity, 1, log);
        Walk(corner, settings, PushedMass, 2, log);
        Walk(new Scene(), settings, double.PositiveInfinity, 2, log);

        // Valleys with two and three slopes, in which the ball comes to rest.
        Obstacle[] slopes =
        [
            new Obstacle { Name = "left", Shape = new PlaneShape(Vector3d.Zero, new Vector3d(1, 1, 0)) },
            new Obstacle { Name = "right", Shape = new PlaneShape(Vector3d.Zero, new Vector3d(-1, 1, 0)) },
            new Obstacle { Name = "end", Shape = new PlaneShape(Vector3d.Zero, new Vector3d(0, 1, 1)) },
        ];
        var windy = new Air { Wind = new Vector3d(0, 0, -6) };
        for (int count = 2; count <= slopes.Length; count++)
        {
            var hollow = new Simulator(new Scene { Obstacles = slopes[..count], Air = windy }, settings);
            ball = hollow.Launch(new Vector3d(0.01, 0.3, 0.1), Vector3d.Zero, Vector3d.Zero);
            Play(hollow, ref ball, 3 * PressedFrames, log);
        }
    }

    /// <summary>A player walks at a ball in front of a board until it is squeezed; then the ball is kicked at a movable box.</summary>
    /// <remarks>A player of finite mass turns, and is pushed away.</remarks>
    private static void Walk(Scene scene, SolverSettings settings, double mass, int count, StepLog log)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot, mass);
        var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.35), new Vector3d(5, 0.5, 0.05)), Surface = SurfaceMaterial.Board };
        var box = new Obstacle { Name = "box", Shape = new BoxShape(new Vector3d(0.8, 0.2, 0.3), new Vector3d(0.2, 0.2, 0.2)), Surface = SurfaceMaterial.Wood, Mass = 5 };
        var simulator = new Simulator(scene with { Bodies = bodies, Obstacles = [board, box, .. scene.Obstacles] }, settings);
        var group = new BallGroup(simulator, count);
        var path = new Trajectory();
        var look = new LookAheadRequest { Duration = PressedFrames * Frame };
        var balls = new BallState[count];
        for (int i = 0; i < count; i++)
        {
            balls[i] = simulator.Launch(new Vector3d(0.3 * i, simulator.ContactHeight, 0.1 * i), Vector3d.Zero, Vector3d.Zero);
        }

        BallState start = balls[0];
        var at = new Vector3d(0.04, 0, 1.2);
        var turn = new Vector3d(0, count > 1 ? 3 : 0, 0);
        for (int i = 0; i < 4 * PressedFrames; i++)
        {
            if (i == 3 * PressedFrames)
            {
                simulator.Kick(ref balls[0], new Vector3d(6, 0.5, 1), Vector3d.Zero);
            }

            Vector3d velocity = at.Z > -0.2 ? new Vector3d(0, 0, -1.5) : Vector3d.Zero;
            player.MoveTo(at, Quaterniond.Identity, velocity, turn, balls[0].Time);
            at += Frame * velocity;
            if (i % PressedFrames == 0)
            {
                simulator.LookAhead(in balls[0], look, path);
            }

            log.Clear();
            group.Step(balls, Frame, log);
        }

        // Look ahead from the initial state, with the player at his final position.
        simulator.LookAhead(in start, look, path);
    }

    /// <summary>A shot into a goal: mouth, line, nets, and rest in the net.</summary>
    public static void Net(SolverSettings settings, StepLog log)
    {
        var simulator = new Simulator(new Scene { Goals = [new Goal { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1) }] }, settings);
        BallState ball = simulator.Launch(new Vector3d(0.5, simulator.ContactHeight, 3), new Vector3d(0, 2, -15), Vector3d.Zero);
        Play(simulator, ref ball, ShotFrames, log);
        simulator.Kick(ref ball, new Vector3d(1, 2, 3), Vector3d.Zero);
        Play(simulator, ref ball, PressedFrames, log);
        ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 3), new Vector3d(-12, 1, -12), Vector3d.Zero);
        Play(simulator, ref ball, PressedFrames, log);
    }

    /// <summary>Three balls: two collide in the air and come to rest on the third.</summary>
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
