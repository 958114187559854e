using System.CommandLine;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs.Scenes;

/// <summary>football lab scenes: compares random seams, turning bodies, carriers, kerbs and slopes with independent references.</summary>
internal static class ScenesLab
{
    /// <summary>The number of failures shown per group.</summary>
    private const int Shown = 3;

    private static readonly SceneKind[] s_kinds = [new Seams(), new Turns(), new Carriers(), new Kerbs(), new Slopes()];

    public static Lab Create()
    {
        var lab = new Lab(
            "scenes",
            "Random seams, turning bodies, moving floors, kerbs and slopes, compared with closed forms, exact rotations and a reference integration.",
            ["football lab scenes --only kerbs --count 20 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Scenes of each kind; ten times as many seams.", 1, 10_000_000, 1000);
        Option<string?> only = lab.Only("KIND", "Run one kind", s_kinds.Select(kind => kind.Name));
        Option<long?> scene = lab.WholeOrNone("--scene", "One scene by its number, with --only.", long.MaxValue);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run =>
        {
            SceneKind[] kinds = [.. s_kinds.Where(kind => run.Get(only) is not { } name || kind.Name == name)];
            if (run.Get(scene) is { } index)
            {
                One(run, index, kinds.Length == 1 ? kinds[0] : throw new RefusedException("--scene requires --only KIND."));
                return;
            }

            Run(run, run.Get(count), kinds, run.Int(jobs));
        });
    }

    private static void One(LabRun run, long index, SceneKind kind)
    {
        SceneOutcome outcome = kind.Play(run.Seed, index);
        LabTable table = run.Table(FormattableString.Invariant($"{kind.Name} {index}"), "group", "error", "limit", "detail", "verdict");
        table.Add(outcome.Group, outcome.Error, outcome.Limit, outcome.Detail, outcome.Holds ? "holds" : "FAILED");
        run.Failed = !outcome.Holds;
    }

    private static void Run(LabRun run, long count, SceneKind[] kinds, int jobs)
    {
        LabTable table = run.Table("Random scenes, and how far off the library is", "kind", "of", "scenes", "wrong answers", "beyond the limit", "median error", "worst error", "at scene", "verdict");
        var failures = new LabTable("failures", "kind", "scene", "of", "detail");
        foreach (SceneKind kind in kinds)
        {
            SceneOutcome[] outcomes = run.Parallel(count * kind.Share, jobs, kind.Name, index => kind.Play(run.Seed, index));
            foreach (var group in outcomes.Select((outcome, index) => (Outcome: outcome, Index: index)).GroupBy(item => item.Outcome.Group).OrderBy(group => group.Key, StringComparer.Ordinal))
            {
                var worst = group.MaxBy(item => item.Outcome.Agrees ? item.Outcome.Error : -1);
                double[] errors = [.. group.Select(item => item.Outcome.Error).Order()];
                int failed = group.Count(item => !item.Outcome.Holds);
                table.Add(
                    kind.Name, group.Key, errors.Length, group.Count(item => !item.Outcome.Agrees), group.Count(item => item.Outcome.Agrees && !item.Outcome.Holds),
                    errors[errors.Length / 2], worst.Outcome.Error, worst.Index, failed == 0 ? "holds" : FormattableString.Invariant($"{failed} FAILED"));
                run.Failed |= failed > 0;
                failures.Rows.AddRange(group.Where(item => !item.Outcome.Holds).Take(Shown).Select(item => new object?[] { kind.Name, item.Index, group.Key, item.Outcome.Detail }));
            }

            run.Notes.Add($"{kind.Name}: {kind.Claim}");
        }

        if (failures.Rows.Count > 0)
        {
            run.Tables.Add(failures);
        }
    }
}

/// <summary>A kind of random scene with an independent reference.</summary>
internal abstract class SceneKind
{
    /// <summary>The largest error of the steps, as a share of the limit.</summary>
    private const double StepShare = 0.2;

    /// <summary>The largest number of parts of a step.</summary>
    private const int MostParts = 64;

    /// <summary>The name of the kind, for the option and the table.</summary>
    public abstract string Name { get; }

    /// <summary>The check, for the notes below the table.</summary>
    public abstract string Claim { get; }

    /// <summary>The number of scenes simulated per requested scene.</summary>
    public virtual int Share => 1;

    /// <summary>Simulates one scene; an exception of the library counts as a fault.</summary>
    /// <param name="seed">The seed of all scenes.</param>
    /// <param name="index">The index of the scene.</param>
    public SceneOutcome Play(long seed, long index)
    {
        try
        {
            var random = new SeededRandom(SeededRandom.Mix(seed, index));

            // The first numbers of neighbouring seeds are not independent.
            random.Next();
            return Play(random);
        }
        catch (Exception exception) when (exception is ArgumentException or InvalidOperationException or ArithmeticException or IndexOutOfRangeException)
        {
            return new SceneOutcome("thrown", false, double.PositiveInfinity, 0, exception.Message);
        }
    }

    /// <summary>Draws and simulates one scene.</summary>
    protected abstract SceneOutcome Play(SeededRandom random);

    /// <summary>Returns the number of parts into which the steps of a scene are divided, so that their own error is a small share of the limit. The remaining error is that of the contact.</summary>
    /// <param name="limit">The limit, m or m/s.</param>
    /// <param name="ofSteps">Returns the difference between a run with this many parts and one with four times as many.</param>
    protected static int Divide(double limit, Func<int, double> ofSteps)
    {
        int parts = 1;
        while (parts < MostParts && !(ofSteps(parts) <= StepShare * limit))
        {
            parts *= 2;
        }

        return parts;
    }
}

/// <summary>The result of the library in one scene, compared with an independent reference.</summary>
/// <param name="Group">The group of scenes that are counted together.</param>
/// <param name="Agrees">True if the library gives the same yes or no: hits, climbs, rests.</param>
/// <param name="Error">The error of a number; 0 if only a yes or no is compared.</param>
/// <param name="Limit">The largest allowed error.</param>
/// <param name="Detail">Numbers for finding the fault.</param>
internal readonly record struct SceneOutcome(string Group, bool Agrees, double Error, double Limit, string Detail)
{
    /// <summary>True if the library is right.</summary>
    public bool Holds => Agrees && Error <= Limit;
}

/// <summary>The part of the library that holds the shapes of a scene.</summary>
internal enum PieceKind
{
    Obstacles,
    Bodies,
    Colliders,
}

/// <summary>Shapes that share one rigid motion about the origin of their frame: as obstacles, as bodies that the game moves, or as colliders of an engine.</summary>
/// <param name="kind">The kind of the pieces.</param>
internal sealed class ScenePieces(PieceKind kind) : IEngineColliders
{
    private readonly List<(IShape Shape, SurfaceMaterial Surface)> _pieces = [];
    private readonly List<EngineCollider> _colliders = [];
    private readonly KinematicBodies _bodies = new();
    private double _reach;

    public PieceKind Kind { get; } = kind;

    /// <summary>The log of the last step.</summary>
    public StepLog Log { get; } = new();

    public double Time { get; private set; }

    public double MaximumSpeed { get; private set; }

    /// <summary>Adds a shape in the common frame.</summary>
    public void Add(IShape shape, SurfaceMaterial surface)
    {
        string name = FormattableString.Invariant($"piece {_pieces.Count}");
        _pieces.Add((shape, surface));
        Bounds3d box = shape.Bounds;
        _reach = Math.Max(_reach, Math.Max(box.Min.Length, box.Max.Length));
        if (Kind == PieceKind.Bodies)
        {
            _bodies.Add(name, shape, surface);
        }
        else if (Kind == PieceKind.Colliders)
        {
            _colliders.Add(new EngineCollider(name, shape, surface));
        }
    }

    /// <summary>Returns the scene with all shapes in it. Obstacles begin at the origin and keep this motion; their spin moves the surface only.</summary>
    public Scene In(Scene scene, Vector3d velocity = default, Vector3d spin = default) => Kind switch
    {
        PieceKind.Obstacles => scene with
        {
            Obstacles = [.. scene.Obstacles, .. _pieces.Select((piece, i) => new Obstacle
            {
                Name = FormattableString.Invariant($"piece {i}"), Shape = piece.Shape, Surface = piece.Surface, Velocity = velocity, Spin = spin,
            })],
        },
        PieceKind.Bodies => scene with { Bodies = _bodies },
        PieceKind.Colliders => scene with { EngineColliders = this },
        _ => throw new InvalidOperationException($"{Kind} is no kind of piece"),
    };

    /// <summary>Sets bodies and colliders for the next step; obstacles move by themselves.</summary>
    public void MoveTo(in Vector3d position, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin, double time)
    {
        Time = time;
        MaximumSpeed = velocity.Length + (_reach * spin.Length);
        foreach (KinematicBody body in _bodies)
        {
            body.MoveTo(position, orientation, velocity, spin, time);
        }

        foreach (EngineCollider collider in _colliders)
        {
            collider.MoveTo(position, orientation, velocity, spin);
        }
    }

    /// <summary>Sets bodies and colliders, and steps a ball.</summary>
    public void Step(Simulator simulator, ref BallState ball, double duration, in Vector3d position, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin)
    {
        MoveTo(position, orientation, velocity, spin, ball.Time);
        Log.Clear();
        simulator.Step(ref ball, duration, Log);
    }

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        // Reporting more colliders than the sphere touches is harmless.
        foreach (EngineCollider collider in _colliders)
        {
            hits.Add(collider);
        }
    }
}
