#if TOOLS
#nullable enable
using System;
using System.Globalization;
using FootballPhysics.Engines;
using FootballPhysics.Netcode;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Plays a recording, seeks to any tick, and checks that this machine reproduces it bit for bit. It uses the scene of the first ball in the edited scene.</summary>
[Tool]
public partial class FootballReplayDock : VBoxContainer
{
    private readonly Button _open = new() { Text = "Open recording…" };
    private readonly Button _play = new() { Text = "Play" };
    private readonly Button _validate = new() { Text = "Validate" };
    private readonly HSlider _slider = new() { Step = 1 };
    private readonly Label _label = new() { Text = "Open a file that ball.Runner.Record().ToBytes() wrote." };
    private FootballDrawing? _drawing;
    private MeshInstance3D? _marker;
    private FootballBall? _ball;
    private bool _plays;
    private bool _moves;

    /// <summary>The recording that the dock shows; null if there is none.</summary>
    public RecordingPlayer? Player { get; private set; }

    /// <summary>The result of the last check.</summary>
    public string Said => _label.Text;

    /// <inheritdoc/>
    public override void _Ready()
    {
        foreach (Node part in new Node[] { _open, _slider, _play, _validate, _label })
        {
            AddChild(part);
        }

        _open.Pressed += Choose;
        _play.Pressed += Toggle;
        _validate.Pressed += Validate;
        _slider.ValueChanged += Seek;
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (_plays && Player is not null)
        {
            Player.Advance(delta);
            _plays = !Player.IsOver;
            Show(TimeText());
        }
    }

    /// <summary>Loads a recording for the scene of a ball: its preset and the goals, pitches, walls and keepers in the tree.</summary>
    /// <param name="bytes">The bytes that Recording.ToBytes returned.</param>
    /// <param name="ball">The ball.</param>
    public void Load(byte[] bytes, FootballBall ball)
    {
        Player = null;
        _plays = false;
        _ball = ball;
        try
        {
            Player = new RecordingPlayer(Recording.FromBytes(bytes), ball.CompileScene());
            _slider.MinValue = Player.Segment.StartTick;
            _slider.MaxValue = Player.Segment.EndTick;
            Show(string.Create(CultureInfo.InvariantCulture, $"{Player.Duration:0.00} s, {Player.Segment.EndTick - Player.Segment.StartTick} ticks"));
        }
        catch (Exception refusal) when (refusal is FormatException or ArgumentException or InvalidOperationException)
        {
            _label.Text = refusal.Message;
        }
    }

    /// <summary>Starts or stops the playback.</summary>
    public void Toggle()
    {
        _plays = !_plays && Player is not null;
        _play.Text = _plays ? "Pause" : "Play";
        if (_plays && Player!.IsOver)
        {
            Player.Seek(Player.Segment.StartTick);
        }
    }

    /// <summary>Replays the recording and checks every tick.</summary>
    public void Validate()
    {
        if (Player is not null)
        {
            long? divergence = Player.FindDivergence();
            _label.Text = divergence is null ? "Every tick matches the recording bit for bit." : $"Tick {divergence} is the first that differs from the recording.";
        }
    }

    /// <summary>Moves the playback to a tick.</summary>
    /// <param name="tick">The tick, as the value of the slider.</param>
    public void Seek(double tick)
    {
        if (Player is not null && !_moves)
        {
            Player.Seek((long)tick);
            Show(TimeText());
        }
    }

    private void Choose()
    {
        var dialog = new EditorFileDialog { FileMode = EditorFileDialog.FileModeEnum.OpenFile, Access = EditorFileDialog.AccessEnum.Filesystem };
        AddChild(dialog);
        dialog.FileSelected += path =>
        {
            if (FootballBall.First is { } ball)
            {
                Load(FileAccess.GetFileAsBytes(path), ball);
            }
            else
            {
                _label.Text = "The edited scene has no FootballBall. Open the scene that was recorded.";
            }
        };
        dialog.PopupCenteredRatio();
    }

    private string TimeText() =>
        string.Create(CultureInfo.InvariantCulture, $"{Player!.Time:0.00} s, {Player.State.Motion}, {Player.State.Velocity.Length:0.0} m/s");

    private void Show(string text)
    {
        _label.Text = text;
        _moves = true;
        _slider.Value = Player!.Tick;
        _moves = false;
        if (_ball is not null && IsInstanceValid(_ball))
        {
            if (_drawing is null || _marker is null || !IsInstanceValid(_marker))
            {
                _drawing = new FootballDrawing(_ball);
                _marker = _drawing.Add(ShapeMesh.OfBall(1.02 * _ball.Radius), new Color(1, 0.92f, 0.016f));
            }

            _marker.GlobalTransform = new Transform3D(Basis.Identity, GodotFrame.ToGodot(Player.Pose.Position));
        }
    }
}
#endif
