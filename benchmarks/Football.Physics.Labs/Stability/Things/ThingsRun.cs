using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Stability.Things;

/// <summary>Simulates a scene with objects, next to its mirror image, and checks the invariants frame by frame.</summary>
internal sealed class ThingsRun
{
    /// <summary>The deepest overlap after a frame, m.</summary>
    private const double Overlap = 1e-9;

    /// <summary>The deepest overlap on the path, m, by dense samples; a ball that is deeper passes through.</summary>
    private const double Through = 5e-3;

    /// <summary>Objects that are closer than this, m, are next to the ball.</summary>
    private const double Beside = 0.02;

    /// <summary>The limit of pieces per frame.</summary>
    private const int MostPieces = 20_000;

    private readonly ThingsScene _scene;
    private readonly Simulator _simulator;
    private readonly World _world;
    private readonly StepLog _log = new(256);
    private readonly PathSamples _samples;
    private readonly ThingsScene? _image;
    private readonly Simulator? _imageSimulator;
    private readonly StepLog _imageLog = new(256);
    private BallState _state;
    private Tally _tally;
    private BallState _imageState;

    private ThingsRun(long seed, long index)
    {
        _scene = new ThingsScene(seed, index, mirrored: false);
        var settings = new SolverSettings { Integrator = _scene.Integrator };
        _simulator = new Simulator(_scene.Scene, settings);
        _world = _simulator.World!;
        _samples = new PathSamples(_world);
        _log.Observer = _samples;
        _state = _simulator.Launch(_scene.Position, _scene.Velocity, _scene.Spin);
        if (_scene.HasMirrorImage)
        {
            _image = new ThingsScene(seed, index, mirrored: true);
            _imageSimulator = new Simulator(_image.Scene, settings);
            _imageState = _imageSimulator.Launch(_image.Position, _image.Velocity, _image.Spin);
        }
    }

    /// <summary>Simulates a scene to its end, or to the first broken invariant.</summary>
    public static StressOutcome Play(long seed, long index)
    {
        var run = new ThingsRun(seed, index);
        Finding? failure = null;
        try
        {
            foreach (double dt in run._scene.Frames)
            {
                failure ??= run.Frame(dt);
            }
        }
        catch (Exception e)
        {
            failure = new Finding("exception", $"{e.GetType().Name}: {e.Message}");
        }

        return new StressOutcome(
            run._scene.Kind.ToString(), run._scene.Integrator, run._tally with { Scenes = 1, Failed = failure is null ? 0 : 1 }, failure is null ? [] : [failure]);
    }

    private Finding? Frame(double dt)
    {
        _scene.MoveBodies(_state.Time);
        _image?.MoveBodies(_imageState.Time);
        _log.Clear();
        _samples.Clear();
        BallState before = _state;
        _simulator.Step(ref _state, dt, _log);
        _tally += Tally.Of(_log) with { InNets = before.Nets != 0 ? 1 : 0 };
        return Finite(before.Time + dt) ?? Rewound(in before, dt) ?? Overlaps() ?? Impulses() ?? Mirrored(dt);
    }

    private Finding? Finite(double time) =>
        !(_state.Position.IsFinite && _state.Velocity.IsFinite && _state.Spin.IsFinite) ? Fail("finite", $"{_state.Position}, {_state.Velocity}, {_state.Spin}")
        : !(Math.Abs(_state.Time - time) <= 1e-12 * Math.Max(1, time)) ? Fail("clock", $"{_state.Time}, not {time}")
        : _log.Steps > MostPieces ? Fail("work", $"{_log.Steps} pieces")
        : null;

    /// <summary>Checks that the frame is bit-identical from a snapshot, also in the middle of a net.</summary>
    private Finding? Rewound(in BallState before, double dt)
    {
        if (before.Nets == 0 && _tally.Frames % 16 != 0)
        {
            return null;
        }

        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in before, bytes);
        BallState again = Snapshot.Read(bytes);
        _imageLog.Clear();
        _simulator.Step(ref again, dt, _imageLog);
        return Snapshot.Same(in again, in _state) ? null : Fail("rewind", $"{again.Position}, not {_state.Position}");
    }

    private Finding? Overlaps()
    {
        // Between objects of which one moves there may be no room for the ball: it must not enter a standing object even then.
        int near = 0;
        double inMovers = 0;
        double inOthers = 0;
        var things = new NearThings(_world, new Bounds3d(_state.Position, _state.Position).Expanded(_world.Ball.Radius + Beside), _state.Time, 0);
        while (things.Next(out int i))
        {
            Collider collider = _world.Colliders[i];
            double gap = collider.At(_state.Position, _state.Time).Distance - _world.Ball.Radius;
            near += gap < Beside ? 1 : 0;
            inMovers = collider.Moves ? Math.Max(inMovers, -gap) : inMovers;
            inOthers = collider.Moves ? inOthers : Math.Max(inOthers, -gap);
        }

        return inOthers > Overlap || (inMovers > Overlap && near < 2) ? Fail("overlap", $"{Math.Max(inOthers, inMovers)} m after a frame, {_state.Motion}")
            : _samples.Deepest > Through ? Fail("passed through", $"{_samples.Deepest} m deep on the way")
            : null;
    }

    /// <summary>Checks that no impact adds energy in the frame of the object, except for the energy that its event reports as added by a bumper.</summary>
    private Finding? Impulses()
    {
        double mass = _world.Ball.Mass;
        double inertia = _world.Ball.MomentOfInertia;
        for (int i = 0; i < _log.Events.Count; i++)
        {
            BallEvent hit = _log.Events[i];
            if (hit.Kind != BallEventKind.Impact)
            {
                continue;
            }

            Collider collider = _world.Colliders[hit.ColliderIndex - _world.FirstCollider];
            Vector3d contact = hit.Position - (_world.Ball.Radius * hit.Normal);
            Vector3d with = collider.SpinVelocity(in contact, hit.Time);
            double before = (mass * (hit.VelocityBefore - with).LengthSquared) + (inertia * hit.SpinBefore.LengthSquared);
            double after = (mass * (hit.Velocity - with).LengthSquared) + (inertia * hit.Spin.LengthSquared);
            if (!(after <= ((before + (2 * hit.AddedEnergy)) * (1 + 1e-12)) + 1e-24))
            {
                return Fail("impact energy", $"{0.5 * before} J to {0.5 * after} J at {_simulator.NameOf(hit.ColliderIndex)}");
            }
        }

        return null;
    }

    /// <summary>Checks that the mirror image of the scene gives the mirror image of the shot, bit-identical.</summary>
    private Finding? Mirrored(double dt)
    {
        if (_image is null)
        {
            return null;
        }

        _imageLog.Clear();
        _imageSimulator!.Step(ref _imageState, dt, _imageLog);
        Vector3d place = _image.Polar(_imageState.Position);
        Vector3d velocity = _image.Polar(_imageState.Velocity);
        return place == _state.Position && velocity == _state.Velocity && _imageState.Spin.X == _state.Spin.X
            ? null
            : Fail("mirror", $"{place - _state.Position} m, {velocity - _state.Velocity} m/s off, frame {_tally.Frames}");
    }

    private static Finding Fail(string check, FormattableString detail) => new(check, FormattableString.Invariant(detail));
}

/// <summary>Random scenes with obstacles, bodies, nets and slopes.</summary>
internal sealed class ThingsSet(long seed) : SceneSet
{
    public override string Name => "things";

    public override long ByDefault => 20_000;

    public override StressOutcome Play(long scene) => ThingsRun.Play(seed, scene);

    public override void Show(long scene, StressOutcome outcome, LabRun run)
    {
        run.Table(FormattableString.Invariant($"scene {scene}"), "kind", "frames", "impacts", "most pieces a frame", "verdict")
            .Add(outcome.Kind, outcome.Tally.Frames, outcome.Tally.Impacts, outcome.Tally.MostSteps, outcome.Verdict);
    }

    public override void Show(StressResults results, long count, LabRun run)
    {
        LabTable table = run.Table(
            FormattableString.Invariant($"{count} scenes with things: does every invariant hold?"),
            "scenes", "how many", "verdict", "frames", "impacts", "frames in nets", "most pieces a frame");
        foreach (string kind in Enum.GetNames<ThingsKind>())
        {
            Tally row = results.Of(kind);
            table.Add(kind, row.Scenes, row.Failed == 0 ? "holds" : row.Verdict, row.Frames, row.Impacts, row.InNets, row.MostSteps);
        }

        ShowFailures(results, run);
        run.Notes.Add("Checked after every frame: no overlap beyond 1e-9 m, nothing passed through on the way, no impact that gives energy in the frame of what was hit, "
            + "bounded work, the mirror image to the last bit (but on uneven ground), and the frame played again from a snapshot to the last bit, always in nets.");
    }
}

/// <summary>Samples the depth of a ball in all objects along its path, to check that it passes through none.</summary>
internal sealed class PathSamples(World world) : PieceObserver
{
    /// <summary>The number of samples per piece.</summary>
    private const int Samples = 8;

    public override bool WantsEndAcceleration => true;

    /// <summary>The greatest depth in any object, m.</summary>
    public double Deepest { get; private set; }

    public void Clear() => Deepest = 0;

    public override bool Add(in PathSegment piece)
    {
        // Moving objects may overlap a squeezed ball. Sample only objects that are close enough to the path for the ball to reach them.
        Vector3d middle = 0.5 * (piece.StartPosition + piece.EndPosition);
        double around = (0.5 * (piece.EndPosition - piece.StartPosition).Length) + (0.25 * piece.Length * (piece.EndVelocity - piece.StartVelocity).Length) + 0.5;
        var near = new NearThings(world, new Bounds3d(in middle, in middle).Expanded(around), piece.Time, piece.Length);
        while (near.Next(out int i))
        {
            Collider collider = world.Colliders[i];
            if (collider.Moves ? piece.Motion == MotionState.Pinned : collider.At(in middle).Distance > around)
            {
                continue;
            }

            for (int k = 1; k <= Samples; k++)
            {
                double time = piece.Time + (piece.Length * k / Samples);
                Vector3d place = piece.PositionAt(time);
                Deepest = Math.Max(Deepest, world.Ball.Radius - collider.At(in place, time).Distance);
            }
        }

        return false;
    }
}
