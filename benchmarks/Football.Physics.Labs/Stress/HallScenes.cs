using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Labs.Stress;

/// <summary>Scenes for states from outside: nets, goals, boards, tables, a knuckle force, wind. Nothing in them is moved, so threads may share them.</summary>
internal static class HallScenes
{
    private const int MostSteps = 90;

    private static readonly double[] s_steps = [1 / 60.0, 0.25, 0.004];

    public static IReadOnlyList<Simulator> All { get; } =
    [
        new(Pitch.Standard.On()),
        new(Pitch.Cage.On(Scene.Default with { Air = new Air { Wind = new Vector3d(3, 0, -7) }, Forces = ForceSet.Measured with { KnuckleSeed = 3 } })),
        new(Pitch.Futsal.On(Scene.Default with { Obstacles = [Table(5, 0.7), Table(-6, 1.1)] }), new SolverSettings { Integrator = Integrator.Rk2 }),
        new(Scene.Default),
    ];

    /// <summary>Returns the state of a moving ball of a scene: in a net, on a table, on the ground or in the air.</summary>
    public static BallState State(SeededRandom random, Simulator simulator)
    {
        IReadOnlyList<Goal> goals = simulator.Scene.Goals;
        Goal? goal = goals.Count > 0 ? goals[random.Below(goals.Count)] : null;
        Vector3d from = goal is null ? new Vector3d(0, 0.11, 0) : goal.Center + (random.Uniform(1, 9) * goal.Facing) + new Vector3d(random.Uniform(-2, 2), random.Uniform(0.11, 2), 0);
        Vector3d velocity = goal is null || random.Chance(0.3) ? random.Velocity(0, 30, 0, 60) : random.Uniform(4, 30) * (goal.Center + new Vector3d(random.Uniform(-2, 2), 1, 0) - from).Normalized();
        if (random.Chance(0.2))
        {
            // Onto a table, in scenes that have one.
            (from, velocity) = (new Vector3d(random.Uniform(-1, 1), 1.5, random.Any(5.0, -6)), random.Uniform(0, 1) * random.Heading());
        }

        BallState state = simulator.Launch(from, velocity, 60 * random.Next() * random.Direction());
        var log = new StepLog(1);
        for (int i = random.Below(MostSteps); i > 0; i--)
        {
            simulator.Step(ref state, s_steps[0] * (1 + (i % 4)), log);
        }

        return state;
    }

    /// <summary>The lengths of the steps for an accepted state, s.</summary>
    public static ReadOnlySpan<double> Steps => s_steps;

    private static Obstacle Table(double z, double high) =>
        new() { Name = "table", Shape = new BoxShape(new Vector3d(0, 0.5 * high, z), new Vector3d(1.5, 0.5 * high, 1.5)), Surface = SurfaceMaterial.Wood };
}

/// <summary>Changed kick logs: an accepted log is simulated in a scene with nets. Kicks and restarts for balls that the match lacks are rejected when due.</summary>
internal sealed class KickBytesPlayed : FuzzTarget
{
    private const double Tick = 1 / 60.0;
    private const int MostTicks = 8;
    private readonly KickLogFuzz _logs = new();

    public override string Name => "kick logs";

    public override byte[] Make(SeededRandom random, int mutations) => _logs.Make(random, mutations);

    public override bool Try(byte[] input)
    {
        if (_logs.Try(input))
        {
            return true;
        }

        KickLog log = KickLog.FromBytes(input);
        Simulator simulator = HallScenes.All[log.Count % HallScenes.All.Count];
        var runner = new FixedStepRunner(simulator, Tick);
        for (int i = 0; i < log.Count; i++)
        {
            KickInput kick = log[i];
            int before = runner.Kicks.Count;
            try
            {
                runner.Kicks.Add(new KickInput(i, kick.Velocity, kick.Spin, kick.Player, kick.Ball));
                Must(kick.Ball == 0, "a kick for a ball that the match lacks is accepted");
            }
            catch (ArgumentOutOfRangeException)
            {
                Must(kick.Ball != 0 && runner.Kicks.Count == before, "a kick is rejected, or changes the log all the same");
            }
        }

        for (int i = 0; i < log.PlaceCount; i++)
        {
            PlaceInput place = log.PlaceAt(i);
            int before = runner.Kicks.PlaceCount;
            try
            {
                runner.Kicks.Add(new PlaceInput(2 * i, place.Player, place.Ball, place.Position, place.Velocity, place.Spin, place.Orientation));
                Must(place.Ball == 0, "a restart of a ball that the match lacks is accepted");
            }
            catch (ArgumentOutOfRangeException)
            {
                Must(place.Ball != 0 && runner.Kicks.PlaceCount == before, "a restart is rejected, or changes the log all the same");
            }
        }

        for (int i = Math.Min(log.Count + log.PlaceCount, MostTicks); i >= 0; i--)
        {
            runner.Step();
            BallState state = runner.State;
            MustBeShort(simulator, ref state, Tick);
        }

        return false;
    }
}
