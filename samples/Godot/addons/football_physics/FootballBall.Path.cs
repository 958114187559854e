#nullable enable
using System;
using Godot;

namespace FootballPhysics.GodotAddon;

public partial class FootballBall
{
    private readonly StepLog _log = new();
    private Vector3[] _path = Array.Empty<Vector3>();
    private FootballScene? _preview;
    private FootballDrawing? _previewDrawing;
    private MeshInstance3D? _previewLine;
    private int _previewStamp;
    private int _previewDrawn;

    /// <summary>The speed of the kick that the editor shows, m/s; a hard shot has 30.</summary>
    [ExportGroup("Kick that the editor shows", "Kick")]
    [Export(PropertyHint.Range, "0,60,0.1,suffix:m/s")]
    public float KickSpeed { get; set; } = 25;

    /// <summary>Its elevation, degrees above the horizontal.</summary>
    [Export(PropertyHint.Range, "-90,90,0.1,suffix:°")]
    public float KickElevation { get; set; } = 15;

    /// <summary>Its heading, degrees to the right of forward (−z).</summary>
    [Export(PropertyHint.Range, "-180,180,0.1,suffix:°")]
    public float KickHeading { get; set; }

    /// <summary>Its top spin, rad/s: positive dips, negative is backspin.</summary>
    [Export(PropertyHint.Range, "-200,200,0.1,suffix:rad/s")]
    public float KickTopSpin { get; set; }

    /// <summary>Its side spin, rad/s: positive bends to the left.</summary>
    [Export(PropertyHint.Range, "-200,200,0.1,suffix:rad/s")]
    public float KickSideSpin { get; set; }

    /// <summary>The duration of the path that the editor shows, s.</summary>
    [Export(PropertyHint.Range, "0.1,20,0.1,suffix:s")]
    public float KickShown { get; set; } = 3;

    /// <summary>The direction of the kick that the editor shows.</summary>
    public Vector3 KickDirection
    {
        get
        {
            (float sinUp, float cosUp) = MathF.SinCos(Mathf.DegToRad(KickElevation));
            (float sinRight, float cosRight) = MathF.SinCos(Mathf.DegToRad(KickHeading));
            return new Vector3(cosUp * sinRight, sinUp, -cosUp * cosRight);
        }
    }

    /// <summary>Predicts the path of the ball without keepers: one point per step of the ball, beginning with the current position. Allocates nothing.</summary>
    /// <param name="points">Receives the points.</param>
    /// <returns>The number of points written. It is smaller than the length of the span if the ball comes to rest.</returns>
    public int PredictPath(Span<Vector3> points)
    {
        FixedStepRunner runner = Runner;
        ApplyChanges();
        _scene!.CollidersAreAt(runner.State.Time + _clock.Left, GreatestSpeed);
        return Follow(_scene.Stage.Ahead, _scene.Stage.PredictionState(runner.State), runner.TimeStep, points);
    }

    /// <summary>Predicts the path of a kick from the ball's position, while the game runs. Allocates nothing.</summary>
    /// <param name="velocity">Velocity, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="points">Receives the points.</param>
    /// <returns>The number of points written.</returns>
    public int PredictKick(Vector3 velocity, Vector3 spin, Span<Vector3> points)
    {
        FixedStepRunner runner = Runner;
        ApplyChanges();
        _scene!.CollidersAreAt(runner.State.Time + _clock.Left, GreatestSpeed);
        BallState state = _scene.Stage.PredictionState(runner.State);
        _scene.Stage.Ahead.Kick(ref state, GodotFrame.FromGodot(velocity), GodotFrame.SpinFromGodot(spin));
        return Follow(_scene.Stage.Ahead, state, runner.TimeStep, points);
    }

    /// <summary>Predicts the path of the kick that the editor shows, from the ball's position, without a running game. It follows changes of the preset, goals, walls and bodies.</summary>
    /// <param name="points">Receives the points.</param>
    /// <returns>The number of points written.</returns>
    public int PreviewPath(Span<Vector3> points)
    {
        int stamp = Stamp();
        if (_preview is null || stamp != _previewStamp)
        {
            _preview = NewScene();
            _previewStamp = stamp;
        }

        Simulator ahead = _preview.Stage.Ahead;
        BallState state = ahead.Launch(GodotFrame.FromGodot(GlobalPosition), default, default);
        Vector3d direction = GodotFrame.FromGodot(KickDirection);
        ahead.Kick(ref state, (KickSpeed / direction.Length) * direction, KickVectors.Spin(direction, KickTopSpin, KickSideSpin));
        return Follow(ahead, state, _runner?.TimeStep ?? 1.0 / Engine.PhysicsTicksPerSecond, points);
    }

    /// <summary>Returns the predicted path as an array, for GDScript.</summary>
    /// <param name="count">The maximum number of points; above 0.</param>
    public Vector3[] PathAhead(int count)
    {
        var points = new Vector3[count];
        return points[..PredictPath(points)];
    }

    /// <summary>Draws the kick in the editor, and updates it after changes.</summary>
    private void DrawPreview()
    {
        int drawn = HashCode.Combine(
            HashCode.Combine(KickSpeed, KickElevation, KickHeading, KickTopSpin, KickSideSpin, KickShown),
            Stamp(),
            GlobalTransform);
        if (drawn == _previewDrawn)
        {
            return;
        }

        _previewDrawn = drawn;
        DrawSkin();
        _previewDrawing ??= new FootballDrawing(this);
        _previewLine ??= _previewDrawing.AddLine(new Color(1, 0.92f, 0.016f));
        int room = 1 + (int)(KickShown * Engine.PhysicsTicksPerSecond);
        if (_path.Length != room)
        {
            _path = new Vector3[room];
        }

        try
        {
            FootballDrawing.Trace(_previewLine, _path.AsSpan(0, PreviewPath(_path)));
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            FootballDrawing.Trace(_previewLine, default);
            GD.PushError($"{Name}: {refusal.Message}");
        }
    }

    private int Follow(Simulator simulator, BallState state, double timeStep, Span<Vector3> points)
    {
        int count = 0;
        while (count < points.Length)
        {
            points[count++] = GodotFrame.ToGodot(state.Position);
            if (state.Motion == MotionState.Rest)
            {
                break;
            }

            _log.Clear();
            simulator.Step(ref state, timeStep, _log);
        }

        return count;
    }
}
