using System.Diagnostics;

namespace FootballPhysics.Labs.Pipes;

/// <summary>The ground and the hollow shape that the ball rolls into.</summary>
internal enum PipeKind
{
    /// <summary>A quarter pipe that is flush with the ground.</summary>
    Pipe,

    /// <summary>A quarter pipe with a level part of its own, without ground.</summary>
    OwnFlat,

    /// <summary>A bowl with a level disc, flush with the ground.</summary>
    Bowl,

    /// <summary>A bowl without a level part, on the ground.</summary>
    RoundBowl,
}

/// <summary>The result of a roll into a pipe or a bowl.</summary>
/// <param name="Kind">The shape.</param>
/// <param name="IsWhole">True if the path of a look-ahead is complete.</param>
/// <param name="Pieces">The pieces of this path.</param>
/// <param name="Steps">The flight steps of each step of the game.</param>
/// <param name="Slowest">The time of the dearest step, s: the best of some repeats from the same state.</param>
/// <param name="Off">The largest distance of the game from the path, m.</param>
/// <param name="Sunk">The largest overlap of the ball with the shape after a step, m.</param>
/// <param name="What">The scene and the launch.</param>
internal sealed record PipeOutcome(PipeKind Kind, bool IsWhole, int Pieces, int[] Steps, double Slowest, double Off, double Sunk, string What)
{
    /// <summary>The greatest median of flight steps, and the longest step, s.</summary>
    public const double MostSteps = 30;
    public const double LongestStep = 1e-3;

    /// <summary>The overlap of a contact, m.</summary>
    public const double Touching = 1e-8;

    /// <summary>The flight steps of the middle step.</summary>
    public int Median => Steps.Order().ElementAt(Steps.Length / 2);

    public bool Holds => IsWhole && Median <= MostSteps && Sunk <= Touching;

    /// <summary>True if no step takes too long.</summary>
    public bool IsFast => Slowest <= LongestStep;
}

/// <summary>A random ball that rolls from the ground into a quarter pipe or a bowl.</summary>
internal sealed class PipeDraw : IEngineColliders
{
    public const double Duration = 2.5;
    private const double Frame = 1 / 60.0;
    private const int Repeats = 5;

    /// <summary>A step that is faster than this at the first attempt is not measured again, s.</summary>
    private const double Fast = 2e-4;

    private readonly PipeKind _kind;
    private readonly IShape _shape;
    private readonly EngineCollider? _collider;
    private readonly KinematicBody? _body;
    private readonly Simulator _simulator;
    private readonly BallState _start;
    private readonly string _what;

    private PipeDraw(SeededRandom random)
    {
        _kind = random.Any(PipeKind.Pipe, PipeKind.Pipe, PipeKind.OwnFlat, PipeKind.Bowl, PipeKind.RoundBowl);
        var ball = BallProperties.Modern;
        double r = ball.Radius;
        double radius = random.Log(0.3, 5);
        bool isBowl = _kind is PipeKind.Bowl or PipeKind.RoundBowl;
        int quarter = random.Below(4);
        Vector3d heading = random.Chance(0.6) ? quarter switch { 0 => new Vector3d(1, 0, 0), 1 => new Vector3d(-1, 0, 0), 2 => new Vector3d(0, 0, 1), _ => new Vector3d(0, 0, -1) } : random.Heading();
        double away = random.Uniform(0.05, 3);
        double disc = _kind == PipeKind.RoundBowl ? 0 : random.Uniform(1, 5);
        bool isAligned = Math.Abs(heading.X) == 1 || Math.Abs(heading.Z) == 1;
        Bounds3d bounds = !isAligned || isBowl || _kind == PipeKind.OwnFlat ? Bounds3d.Everywhere : Beyond(away * heading, heading);
        _shape = new HollowWall(radius, isBowl ? Vector3d.Zero : away * heading, isBowl ? Vector3d.Zero : heading, disc) { Bounds = bounds };
        SurfaceMaterial turf = random.Any(SurfaceMaterial.MatchTurf, SurfaceMaterial.DryTurf, SurfaceMaterial.Concrete);
        SurfaceMaterial surface = random.Chance(0.3) ? turf : random.Any(SurfaceMaterial.Wood, SurfaceMaterial.Concrete, SurfaceMaterial.Indoor);
        var scene = new FootballPhysics.Scene { Ball = ball, Ground = _kind == PipeKind.OwnFlat ? Ground.None : Ground.Of(turf) };
        int carrier = random.Below(3);
        if (carrier == 0)
        {
            _collider = new EngineCollider("pipe", _shape, surface);
            scene = scene with { EngineColliders = this };
        }
        else if (carrier == 1)
        {
            var bodies = new KinematicBodies();
            _body = bodies.Add("pipe", _shape, surface);
            scene = scene with { Bodies = bodies };
            _body.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero, 0);
        }
        else
        {
            scene = scene with { Obstacles = [new Obstacle { Name = "pipe", Shape = _shape, Surface = surface }] };
        }

        _simulator = new Simulator(scene);
        double speed = random.Uniform(1, 20);
        double angle = random.Chance(0.4) ? 0 : random.Uniform(-1.3, 1.3);
        Vector3d across = Vector3d.Cross(Vector3d.Up, heading);
        Vector3d velocity = speed * ((Math.Cos(angle) * heading) + (Math.Sin(angle) * across));
        Vector3d from = isBowl ? random.Uniform(0, 0.5) * disc * random.Heading() : Vector3d.Zero;
        Vector3d spin = random.Chance(0.7) ? Vector3d.Cross(Vector3d.Up, velocity) / r : random.Uniform(0, 60) * random.Direction();
        bool drops = random.Chance(0.15);
        _start = _simulator.Launch(from + ((r + (drops ? random.Uniform(0, 0.5) : 0)) * Vector3d.Up), velocity, spin);
        _what = FormattableString.Invariant($"{_kind}, radius {radius:0.###} m, {(carrier == 0 ? "engine collider" : carrier == 1 ? "body" : "obstacle")}, {speed:0.##} m/s, foot {away:0.###}, heading {heading}, disc {disc:0.###}, from {from}, velocity {velocity}, spin {spin}");
    }

    /// <summary>Draws and plays a ball.</summary>
    /// <param name="seed">The seed of all balls.</param>
    /// <param name="index">The number of the ball.</param>
    public static PipeOutcome Play(long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        random.Next();
        return new PipeDraw(random).Play();
    }

    double IEngineColliders.Time => 0;

    double IEngineColliders.MaximumSpeed => 0;

    void IEngineColliders.Cast(in SphereCast cast, EngineHits hits)
    {
        if (_collider is not null)
        {
            _collider.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            hits.Add(_collider);
        }
    }

    private PipeOutcome Play()
    {
        var path = new Trajectory();
        _simulator.LookAhead(in _start, new LookAheadRequest { Duration = Duration, StopAt = StopAt.Time }, path);
        int count = (int)Math.Round(Duration / Frame);
        int[] steps = new int[count];
        double slowest = 0;
        double off = 0;
        double sunk = 0;
        var log = new StepLog();
        BallState state = _start;
        for (int i = 0; i < count; i++)
        {
            BallState before = state;
            double best = double.PositiveInfinity;
            for (int k = 0; k < Repeats && (k == 0 || best > Fast); k++)
            {
                state = before;
                log.Clear();
                _body?.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero, state.Time);
                long began = Stopwatch.GetTimestamp();
                _simulator.Step(ref state, Frame, log);
                best = Math.Min(best, Stopwatch.GetElapsedTime(began).TotalSeconds);
            }

            steps[i] = (int)log.Steps;
            slowest = Math.Max(slowest, best);
            off = Math.Max(off, Vector3d.Distance(state.Position, path.PositionAt(Math.Min(state.Time, path.EndTime))));
            sunk = Math.Max(sunk, _simulator.Scene.Ball.Radius - _shape.At(state.Position).Distance);
        }

        return new PipeOutcome(_kind, path.IsComplete, path.Pieces.Length, steps, slowest, off, sunk, _what);
    }

    private static Bounds3d Beyond(in Vector3d foot, in Vector3d heading)
    {
        const double Far = 1e6;
        return new Bounds3d(
            new Vector3d(heading.X > 0.5 ? foot.X : -Far, -Far, heading.Z > 0.5 ? foot.Z : -Far),
            new Vector3d(heading.X < -0.5 ? foot.X : Far, Far, heading.Z < -0.5 ? foot.Z : Far));
    }
}
