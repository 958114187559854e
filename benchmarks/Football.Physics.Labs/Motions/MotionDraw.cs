using FootballPhysics.Labs.Scenes;

namespace FootballPhysics.Labs.Motions;

/// <summary>What became of the balls of a random scene.</summary>
/// <param name="Kind">The things in the scene, and whether there are several balls.</param>
/// <param name="Changes">The steps in which the motion of a ball changed.</param>
/// <param name="Uncounted">Of these, the steps that only count some of their events, because there are too many.</param>
/// <param name="Missing">The changes without an event.</param>
/// <param name="First">The first of them.</param>
internal readonly record struct MotionOutcome(string Kind, int Changes, int Uncounted, int Missing, string First);

/// <summary>A random scene with a ball or several among spheres, boxes, capsules and boards, which stand still or move: each change of a motion between two steps has its event.</summary>
internal sealed class MotionDraw
{
    private const double Duration = 1.2;

    private readonly ScenePieces _pieces;
    private readonly BallGroup _group;
    private readonly BallState[] _states;
    private readonly double _step;
    private readonly SeededRandom _random;
    private Vector3d _position;
    private Vector3d _velocity;
    private Vector3d _spin;
    private Quaterniond _orientation = Quaterniond.Identity;
    private int _changes;
    private int _uncounted;
    private int _missing;
    private string _first = "";

    private MotionDraw(SeededRandom random)
    {
        _random = random;
        _pieces = new ScenePieces(random.Any(PieceKind.Obstacles, PieceKind.Bodies, PieceKind.Colliders));
        int count = 1 + random.Below(4);
        for (int i = 0; i < count; i++)
        {
            Add();
        }

        Scene profile = random.Chance(0.5) ? new Scene { Air = new Air { Wind = random.Chance(0.3) ? random.Uniform(0, 12) * random.Heading() : Vector3d.Zero } } : Scene.Published;
        Scene scene = _pieces.In(random.Chance(0.3) ? Pitch.Standard.On(profile) : profile);
        var settings = new SolverSettings { Integrator = random.Any(Integrator.Rk4, Integrator.Rk4, Integrator.Rk2) };
        _group = new BallGroup(new Simulator(scene, settings), random.Chance(0.6) ? 1 : 2 + random.Below(3));
        _step = random.Any(1 / 60.0, 1 / 60.0, 1 / 30.0, 1 / 144.0, 2e-3);
        _states = new BallState[_group.Count];
        for (int i = 0; i < _states.Length; i++)
        {
            _states[i] = Launch(scene.Ball.Radius, i);
        }

        if (_pieces.Kind != PieceKind.Obstacles)
        {
            Turn();
        }
    }

    /// <summary>Draws and plays a scene.</summary>
    /// <param name="seed">The seed of all scenes.</param>
    /// <param name="index">The number of the scene.</param>
    public static MotionOutcome Play(long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));

        // The first numbers of neighbouring seeds are not independent.
        random.Next();
        return new MotionDraw(random).Play();
    }

    /// <summary>True if a step's events explain a motion at its end. An impact may lift a ball off its surface, but does not lay it down.</summary>
    /// <param name="before">The ball before the step.</param>
    /// <param name="after">The ball after it.</param>
    /// <param name="events">The events of the step.</param>
    /// <param name="ball">The index of the ball.</param>
    public static bool Explains(in BallState before, in BallState after, EventBuffer events, int ball)
    {
        MotionState named = before.Motion;
        bool mayFly = named == MotionState.Airborne;
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent happened = ref events[i];
            if (happened.Ball != ball)
            {
                continue;
            }

            mayFly |= happened.Kind == BallEventKind.Impact;
            MotionState? now = happened.Kind switch
            {
                BallEventKind.Slide => MotionState.Sliding,
                BallEventKind.Roll => MotionState.Rolling,
                BallEventKind.Rest => MotionState.Rest,
                BallEventKind.ContactEnd => MotionState.Airborne,
                BallEventKind.Pinned => happened.ColliderIndex < 0 ? MotionState.Airborne : MotionState.Pinned,
                _ => null,
            };
            if (now is { } motion)
            {
                named = motion;
                mayFly = motion == MotionState.Airborne;
            }
        }

        return after.Motion == named || (after.Motion == MotionState.Airborne && mayFly);
    }

    private MotionOutcome Play()
    {
        var log = new StepLog();
        var before = new BallState[_states.Length];
        for (int step = 0; step * _step < Duration; step++)
        {
            double time = _states[0].Time;
            if (_pieces.Kind != PieceKind.Obstacles)
            {
                // Now and then, the things stop or go on.
                if (_random.Chance(0.03))
                {
                    Turn();
                }

                _pieces.MoveTo(_position, _orientation, _velocity, _spin, time);
            }

            log.Clear();
            Array.Copy(_states, before, before.Length);
            _group.Step(_states, _step, log);
            _position += _step * _velocity;
            _orientation = Turned(_step);
            for (int i = 0; i < _states.Length; i++)
            {
                Watch(in before[i], in _states[i], log, i);
            }
        }

        return new MotionOutcome($"{_pieces.Kind}, {(_states.Length == 1 ? "one ball" : "several balls")}", _changes, _uncounted, _missing, _first);
    }

    private void Watch(in BallState before, in BallState after, StepLog log, int ball)
    {
        bool isCounted = log.UnreportedImpacts == 0 && log.Events.Dropped == 0;
        _changes += before.Motion != after.Motion ? 1 : 0;
        if (Explains(in before, in after, log.Events, ball))
        {
            return;
        }

        // A crowded step counts events instead of reporting them.
        _uncounted += isCounted ? 0 : 1;
        _missing += isCounted ? 1 : 0;
        if (_first.Length == 0)
        {
            string events = string.Join(' ', log.Events.Span.ToArray().Where(item => item.Ball == ball).Select(item => FormattableString.Invariant($"{item.Kind}@{item.Time:0.0000}")));
            _first = FormattableString.Invariant($"ball {ball}, {before.Time:0.0000} s: {before.Motion} to {after.Motion}, events: {events}");
        }
    }

    private Quaterniond Turned(double time)
    {
        double rate = _spin.Length;
        return rate > 0 ? (Quaterniond.FromAxisAngle(_spin / rate, rate * time) * _orientation).Normalized() : _orientation;
    }

    private void Turn()
    {
        _velocity = _random.Chance(0.4) ? Vector3d.Zero : _random.Uniform(0, 3) * _random.Heading();
        _spin = _random.Chance(0.6) ? Vector3d.Zero : new Vector3d(0, _random.Uniform(-3, 3), 0);
    }

    /// <summary>Adds a thing in the way: a sphere or a capsule that may press the ball onto the ground, a box, a board, or a low plate that carries the ball.</summary>
    private void Add()
    {
        SurfaceMaterial surface = _random.Any(SurfaceMaterial.Board, SurfaceMaterial.Boot, SurfaceMaterial.Concrete, SurfaceMaterial.Glove, SurfaceMaterial.PublishedTurf) with
        {
            NormalRestitution = _random.Uniform(0, 0.9),
        };
        Vector3d at = (_random.Uniform(0.3, 2.5) * new Vector3d(1, 0, 0)) + new Vector3d(0, 0, _random.Uniform(-0.6, 0.6));
        double radius = _random.Uniform(0.05, 0.3);
        IShape shape = _random.Below(5) switch
        {
            0 or 1 => new SphereShape(at + new Vector3d(0, _random.Uniform(0, 0.11 + radius), 0), radius),
            2 => new CapsuleShape(at + new Vector3d(0, _random.Uniform(0, 0.3), -0.4), at + new Vector3d(0, _random.Uniform(0, 0.3), 0.4), 0.5 * radius),
            3 => new BoxShape(at + new Vector3d(0, 0.3, 0), new Vector3d(0.1, 0.3, 0.5)),
            _ => new BoxShape(at + new Vector3d(0, 0.01, 0), new Vector3d(0.4, _random.Uniform(0.01, 0.03), 0.4)),
        };
        _pieces.Add(shape, surface);
    }

    /// <summary>Launches a ball on the ground, rolling or sliding, or above it.</summary>
    private BallState Launch(double radius, int index)
    {
        double speed = _random.Any(0, 0.3, 1, 3, 6) * _random.Next();
        var velocity = new Vector3d(speed, 0, _random.Uniform(-0.3, 0.3) * speed);
        Vector3d spin = _random.Chance(0.5) ? Vector3d.Cross(Vector3d.Up, velocity) / radius : _random.Uniform(0, 30) * _random.Direction();

        // Most balls start in front of the things, and some among them.
        double x = _random.Chance(0.7) ? -0.5 * index : _random.Uniform(0, 2.5);
        var place = new Vector3d(x, radius + (_random.Chance(0.6) ? 0 : _random.Uniform(0, 1)), _random.Uniform(-0.3, 0.3));
        return _group.SimulatorOf(index).Launch(place, velocity, spin);
    }
}
