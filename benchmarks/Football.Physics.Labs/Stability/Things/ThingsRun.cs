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
    private readonly ThingsScene? _image;
    private readonly Simulator? _imageSimulator;
    private readonly StepLog _log = new();
    private PathSamples? _samples;
    private BallState _imageState;

    private ThingsRun(long seed, long index)
    {
        _scene = new ThingsScene(seed, index, mirrored: false);
        if (_scene.HasMirrorImage)
        {
            _image = new ThingsScene(seed, index, mirrored: true);
            _imageSimulator = new Simulator(_image.Shot.Scene, _image.Shot.Settings);
            _imageState = _imageSimulator.Launch(_image.Shot.Position, _image.Shot.Velocity, _image.Shot.Spin);
        }
    }

    /// <summary>Simulates a scene to its end, or to the first broken invariant.</summary>
    public static StressOutcome Play(long seed, long index)
    {
        var run = new ThingsRun(seed, index);
        return StressRun.Play(run._scene.Shot, run._scene.Kind.ToString(), run.Holds, run.Begin, mayBeRefused: false);
    }

    private void Begin(StressFrame frame, double time)
    {
        _scene.MoveBodies(time);
        _image?.MoveBodies(_imageState.Time);
        _samples ??= new PathSamples(frame.Simulator.World!);
        _samples.Clear();
        frame.Log.Observer = _samples;
    }

    private bool Holds(StressFrame frame) => ((FrameCheck[])[Finite, Rewound, Overlaps, Impulses, Mirrored]).All(check =>
    {
        check(frame);
        return !frame.HasFindings;
    });

    private static void Finite(StressFrame frame)
    {
        ref readonly BallState after = ref frame.After;
        double time = frame.Before.Time + frame.Length;
        frame.FindIf(!(after.Position.IsFinite && after.Velocity.IsFinite && after.Spin.IsFinite), "finite", 1, $"{after.Position}, {after.Velocity}, {after.Spin}");
        frame.FindIf(!(Math.Abs(after.Time - time) <= 1e-12 * Math.Max(1, time)), "clock", 1, $"{after.Time}, not {time}");
        frame.FindIf(frame.Log.Steps > MostPieces, "work", 1, $"{frame.Log.Steps} pieces");
    }

    /// <summary>Checks that the frame is bit-identical from a snapshot, also in the middle of a net.</summary>
    private void Rewound(StressFrame frame)
    {
        if (frame.Before.Nets == 0 && frame.Tally.Frames % 16 != 0)
        {
            return;
        }

        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in frame.Before, bytes);
        BallState again = Snapshot.Read(bytes);
        _log.Clear();
        frame.Simulator.Step(ref again, frame.Length, _log);
        frame.FindIf(!Snapshot.Same(in again, in frame.After), "rewind", 1, $"{again.Position}, not {frame.After.Position}");
    }

    private void Overlaps(StressFrame frame)
    {
        // Between objects of which one moves there may be no room for the ball: it must not enter a standing object even then.
        World world = frame.Simulator.World!;
        BallState ball = frame.After;
        int near = 0;
        double inMovers = 0;
        double inOthers = 0;
        var things = new NearThings(world, new Bounds3d(ball.Position, ball.Position).Expanded(world.Ball.Radius + Beside), ball.Time, 0);
        while (things.Next(out int i))
        {
            Collider collider = world.ByIndex[i];
            double gap = collider.At(ball.Position, ball.Time).Distance - world.Ball.Radius;
            near += gap < Beside ? 1 : 0;
            inMovers = collider.Moves ? Math.Max(inMovers, -gap) : inMovers;
            inOthers = collider.Moves ? inOthers : Math.Max(inOthers, -gap);
        }

        double depth = Math.Max(inOthers, inMovers);
        frame.FindIf(inOthers > Overlap || (inMovers > Overlap && near < 2), "overlap", depth, $"{depth} m after a frame, {ball.Motion}");
        frame.FindIf(_samples!.Deepest > Through, "passed through", _samples.Deepest, $"{_samples.Deepest} m deep on the way");
    }

    /// <summary>Checks that no impact adds energy in the frame of the object, except for the energy that its event reports as added by a bumper.</summary>
    private static void Impulses(StressFrame frame)
    {
        World world = frame.Simulator.World!;
        double mass = world.Ball.Mass;
        double inertia = world.Ball.MomentOfInertia;
        foreach (ref readonly BallEvent hit in frame.Log.Events)
        {
            if (hit.Kind != BallEventKind.Impact)
            {
                continue;
            }

            Collider collider = world.ByIndex[hit.ColliderIndex - world.FirstCollider];
            Vector3d contact = hit.Position - (world.Ball.Radius * hit.Normal);
            Vector3d with = collider.SpinVelocity(in contact, hit.Time);
            double before = (mass * (hit.VelocityBefore - with).LengthSquared) + (inertia * hit.SpinBefore.LengthSquared);
            double after = (mass * (hit.Velocity - with).LengthSquared) + (inertia * hit.Spin.LengthSquared);
            frame.FindIf(
                !(after <= ((before + (2 * hit.AddedEnergy)) * (1 + 1e-12)) + 1e-24), "impact energy", (after / before) - 1,
                $"{0.5 * before} J to {0.5 * after} J at {frame.Simulator.NameOf(hit.ColliderIndex)}");
        }
    }

    /// <summary>Checks that the mirror image of the scene gives the mirror image of the shot, bit-identical.</summary>
    private void Mirrored(StressFrame frame)
    {
        if (_image is null)
        {
            return;
        }

        _log.Clear();
        _imageSimulator!.Step(ref _imageState, frame.Length, _log);
        BallState ball = frame.After;
        Vector3d place = _image.Polar(_imageState.Position);
        Vector3d velocity = _image.Polar(_imageState.Velocity);
        frame.FindIf(
            place != ball.Position || velocity != ball.Velocity || _imageState.Spin.X != ball.Spin.X, "mirror", (place - ball.Position).Length,
            $"{place - ball.Position} m, {velocity - ball.Velocity} m/s off");
    }
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
            Collider collider = world.ByIndex[i];
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
