namespace Football.Physics;

/// <summary>Compiles what a game is about to use, and makes its tables, so that no frame has to.</summary>
/// <remarks>
/// Where code is compiled just in time, the first impact, the first roll and the first search cost milliseconds each. Call these while a level
/// loads; nothing that can be seen changes. Forces of a game's own are asked meanwhile. A runtime compiles in full what runs often, but counts from
/// a tenth of a second later: called once more by the end of the loading, they make the first roll and the first look-ahead several times faster.
/// </remarks>
public static class WarmUps
{
    /// <summary>A frame, s, and how many of them a ball has to come to rest in.</summary>
    private const double Frame = 1.0 / 60.0;
    private const int MostFrames = 1200;

    /// <summary>Frames of a ball among several things.</summary>
    private const int SqueezedFrames = 60;

    /// <summary>Steps, impacts, slides, rolls and looks ahead with balls that nobody sees.</summary>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void WarmUp(this Simulator simulator)
    {
        if (simulator is null)
        {
            throw new ArgumentNullException(nameof(simulator));
        }

        var ball = new Ball(simulator);
        var path = new Trajectory();
        var look = new LookAheadRequest();
        foreach ((Vector3d velocity, Vector3d spin) in Kicks())
        {
            ball.Place(new Vector3d(0, simulator.ContactHeight, 0));
            ball.Kick(velocity, spin);
            simulator.LookAhead(ball.State, look, path);
            for (int i = 0; i < MostFrames && ball.Motion != MotionState.Stopped; i++)
            {
                ball.Step(Frame);
            }

            path.TryGetCrossing(new Plane3d(new Vector3d(0, 0, -5), new Vector3d(0, 0, 1)), out PathPoint at);
            path.ClosestApproach(at.Position);
        }

        if (!simulator.World.IsBare)
        {
            Squeeze(simulator.Settings);
        }
    }

    /// <summary>Presses a ball against a wall and the ground, in a scene of its own: on several contacts, and squeezed.</summary>
    private static void Squeeze(SolverSettings settings)
    {
        var press = new Obstacle { Name = "press", Shape = new SphereShape(new Vector3d(0, 0.2, 0.4), 0.25), Velocity = new Vector3d(0, 0, -1) };
        var wall = new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -0.3), new Vector3d(0, 0, 1)) };
        var ball = new Ball(new Simulator(new Scene { Obstacles = [wall, press] }, settings));
        ball.Place(new Vector3d(0.02, 0.11, 0));
        for (int i = 0; i < SqueezedFrames; i++)
        {
            ball.Step(Frame);
        }
    }

    /// <summary>Finds kicks of every kind that nobody plays.</summary>
    /// <param name="aimer">The aimer.</param>
    /// <exception cref="ArgumentNullException"><paramref name="aimer"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void WarmUp(this Aimer aimer)
    {
        if (aimer is null)
        {
            throw new ArgumentNullException(nameof(aimer));
        }

        double contact = aimer.Context.Game.ContactHeight;
        var request = new AimRequest
        {
            From = new Vector3d(0, contact, 0),
            Target = new Vector3d(1, contact + 1, -18),
            TopSpin = -10,
            SideSpin = 20,
            MaximumElevationDegrees = 80,
        };
        aimer.Find(request);
        AimResult high = aimer.Find(request with { Arc = AimArc.High });
        aimer.Find(request with { Speed = 8 });
        aimer.Find(request with { Through = new Vector3d(1, contact + 2, -9) });
        aimer.Find(request with { Target = new Vector3d(0, contact, -15), MaximumElevationDegrees = 0 });
        aimer.FindSlowest(request);
        aimer.FindAtTime(request, high.Time);
    }

    /// <summary>Flies a group of balls that nobody sees.</summary>
    /// <param name="batch">The batch; not at work.</param>
    /// <exception cref="ArgumentNullException"><paramref name="batch"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void WarmUp(this BallBatch batch)
    {
        if (batch is null)
        {
            throw new ArgumentNullException(nameof(batch));
        }

        const int Count = 64;
        double contact = batch.Scene.Ground.Height + batch.Scene.Ball.Radius;
        var launches = new BatchLaunches(Count);
        for (int i = 0; i < Count; i++)
        {
            launches.Position[i] = new Vector3d(0, contact, 0);
            launches.Velocity[i] = new Vector3d(0, 3 + (0.1 * i), -12 - (0.2 * i));
            launches.Spin[i] = new Vector3d(0, 0.5 * i, 0);
        }

        batch.Fly(launches, new BatchFlights(Count), Count);
    }

    /// <summary>Finds a group of kicks that nobody plays.</summary>
    /// <param name="aimer">The aimer; not at work.</param>
    /// <exception cref="ArgumentNullException"><paramref name="aimer"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void WarmUp(this BatchAimer aimer)
    {
        if (aimer is null)
        {
            throw new ArgumentNullException(nameof(aimer));
        }

        const int Count = 64;
        double contact = aimer.Scene.Ground.Height + aimer.Scene.Ball.Radius;
        var aims = new BatchAims(Count);
        for (int i = 0; i < Count; i++)
        {
            aims.Set(i, new Vector3d(0, contact, 0), new Vector3d(0.1 * i, contact + 1, -15), 18 + (0.1 * i), -5, 0.5 * i);
        }

        aimer.Find(aims, new BatchKicks(Count), Count);
    }

    /// <summary>A shot, a drive without spin, a pass along the ground.</summary>
    private static (Vector3d Velocity, Vector3d Spin)[] Kicks() =>
    [
        (new Vector3d(2, 7, -22), new Vector3d(10, 30, 0)),
        (new Vector3d(0, 2, -12), Vector3d.Zero),
        (new Vector3d(0, 0, -8), Vector3d.Zero),
    ];
}
