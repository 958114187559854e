using FootballPhysics.Netcode;

// A simulation of the golden file among objects: balls, a scene, and the motion of its objects.

namespace FootballPhysics.Golden;

internal sealed class GoldenPlay
{
    private readonly List<(Vector3d Position, Vector3d Velocity, Vector3d Spin)> _balls = new List<(Vector3d, Vector3d, Vector3d)>();
    private readonly List<(double Time, int Ball, Vector3d Velocity, Vector3d Spin)> _kicks = new List<(double, int, Vector3d, Vector3d)>();

    public GoldenPlay(Scene scene, double duration)
    {
        Scene = scene;
        Duration = duration;
    }

    public Scene Scene { get; }

    /// <summary>A multiple of 0.1 s.</summary>
    public double Duration { get; }

    /// <summary>Places the bodies and engine colliders at a time, before each step; null if nothing moves.</summary>
    public Action<double>? Move { get; set; }

    /// <summary>The kind of each ball; null if all are the ball of the scene.</summary>
    public BallProperties[]? Kinds { get; set; }

    /// <summary>The methods that locate events.</summary>
    public SolverSettings Settings { get; set; } = SolverSettings.Default;

    /// <summary>True if the only ball is in a group too.</summary>
    public bool IsGroup { get; set; }

    /// <summary>The integrator; null for that of the variant.</summary>
    public Integrator? Integrator { get; set; }

    /// <summary>True if all states are read from bytes after every 0.3 s.</summary>
    public bool Restores { get; set; }

    /// <summary>The scene of the second half; null for the same.</summary>
    public Scene? Then { get; set; }

    /// <summary>Adds a ball.</summary>
    public GoldenPlay Ball(Vector3d position, Vector3d velocity = default, Vector3d spin = default)
    {
        _balls.Add((position, velocity, spin));
        return this;
    }

    /// <summary>Adds a ball that rolls without slip on level ground.</summary>
    public GoldenPlay Roll(double x, double z, double vx, double vz)
    {
        double radius = Scene.Ball.Radius;
        return Ball(new Vector3d(x, radius, z), new Vector3d(vx, 0, vz), new Vector3d(vz / radius, 0, -vx / radius));
    }

    /// <summary>Kicks a ball at a time.</summary>
    public GoldenPlay Kick(double time, Vector3d velocity, Vector3d spin = default, int ball = 0)
    {
        _kicks.Add((time, ball, velocity, spin));
        return this;
    }

    /// <summary>Returns the hash of all states, events and drawn poses.</summary>
    /// <param name="rate">Steps per second; a multiple of 10.</param>
    /// <param name="met">Gets the kinds of events, and the names of everything that a ball touched.</param>
    public ulong Run(int rate, ISet<string> met)
    {
        double step = 1.0 / rate;
        SolverSettings settings = Integrator is { } integrator ? Settings with { Integrator = integrator } : Settings;
        FixedStepRunner runner = Kinds is not null ? new FixedStepRunner(new BallGroup(Scene, Kinds, settings), step)
            : _balls.Count > 1 || IsGroup ? new FixedStepRunner(new BallGroup(new Simulator(Scene, settings), _balls.Count), step)
            : new FixedStepRunner(new Simulator(Scene, settings), step);
        runner.MoveBodies = Move;
        Move?.Invoke(0);
        runner.RestoreAll(0, _balls.Select((ball, i) => SimulatorOf(runner, i).Launch(ball.Position, ball.Velocity, ball.Spin)).ToArray());
        foreach ((double time, int ball, Vector3d velocity, Vector3d spin) in _kicks)
        {
            runner.Kicks.Add(new KickInput(TicksOf(time, rate), velocity, spin, 0, ball));
        }

        ulong hash = 0;
        long ticks = TicksOf(Duration, rate);
        while (runner.Tick < ticks)
        {
            runner.Step();
            hash = Mix(hash, runner);
            if (Restores && runner.Tick % (rate * 3 / 10) == 0)
            {
                runner.RestoreAll(runner.Tick, Enumerable.Range(0, _balls.Count).Select(i => Read(runner.StateOf(i))).ToArray());
            }

            if (Then is not null && runner.Tick == ticks / 2)
            {
                runner.Simulator = new Simulator(Then, settings);
            }

            for (int i = 0; i < runner.Events.Count; i++)
            {
                BallEvent happened = runner.Events[i];
                met.Add(happened.Kind.ToString());
                met.Add(SimulatorOf(runner, happened.Ball).NameOf(happened.ColliderIndex) ?? "ground");
            }
        }

        return hash;
    }

    private static ulong Mix(ulong hash, FixedStepRunner runner)
    {
        hash = GoldenShots.MixStep(hash, runner);
        for (int i = 1; i < (runner.Group?.Count ?? 1); i++)
        {
            BallState state = runner.StateOf(i);
            BallPose pose = runner.PoseAt(0.375, i);
            hash = GoldenShots.Mix(hash, Snapshot.Hash(state));
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, pose.Position), pose.Orientation.X);
        }

        for (int i = 0; i < runner.Events.Count; i++)
        {
            BallEvent happened = runner.Events[i];
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, (ulong)happened.Ball), (ulong)happened.ColliderIndex);
        }

        return hash;
    }

    private static BallState Read(BallState state)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(state, bytes);
        return Snapshot.Read(bytes);
    }

    private static Simulator SimulatorOf(FixedStepRunner runner, int ball)
    {
        return runner.Group?.SimulatorOf(ball) ?? runner.Simulator;
    }

    private static long TicksOf(double time, int rate)
    {
        return (long)((time * rate) + 0.5);
    }
}
