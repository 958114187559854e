#nullable enable
using System;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Shows the predicted path in the game: a line for the ball, and a cone around it for the spread of the player's kicks.</summary>
/// <remarks>It shows the kick of <see cref="ShowKick"/> during aiming, and otherwise the path of the flying ball.</remarks>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballPath : Node3D
{
    /// <summary>The number of lines of the cone.</summary>
    public const int Sides = 8;

    private readonly MeshInstance3D[] _lines = new MeshInstance3D[1 + Sides];
    private Vector3[] _points = Array.Empty<Vector3>();
    private Vector3 _velocity;
    private Vector3 _spin;
    private bool _aims;

    /// <summary>The ball; empty: the first in the tree.</summary>
    [Export]
    public FootballBall? Ball { get; set; }

    /// <summary>The duration of the path shown, s.</summary>
    [Export(PropertyHint.Range, "0.1,10,0.1,suffix:s")]
    public float Seconds { get; set; } = 1.6f;

    /// <summary>The standard deviation of the direction, degrees; the cone shows two of them.</summary>
    [Export(PropertyHint.Range, "0,10,0.1,suffix:°")]
    public float Degrees { get; set; } = 1;

    /// <summary>The standard deviation of the speed, %.</summary>
    [Export(PropertyHint.Range, "0,30,0.1,suffix:%")]
    public float SpeedPercent { get; set; } = 3;

    /// <summary>Colour of the line.</summary>
    [Export]
    public Color LineColor { get; set; } = new(1, 0.92f, 0.016f);

    /// <summary>The line of the path, followed by the lines of the cone.</summary>
    public MeshInstance3D[] Lines => _lines;

    /// <summary>Shows an aimed kick, until <see cref="HideKick"/>.</summary>
    /// <param name="velocity">Velocity, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    public void ShowKick(Vector3 velocity, Vector3 spin)
    {
        _aims = true;
        _velocity = velocity;
        _spin = spin;
    }

    /// <summary>Shows the path of the ball itself again.</summary>
    public void HideKick() => _aims = false;

    /// <inheritdoc/>
    public override void _Ready()
    {
        var drawing = new FootballDrawing(this);
        for (int i = 0; i < _lines.Length; i++)
        {
            _lines[i] = drawing.AddLine(i == 0 ? LineColor : LineColor * 0.6f);
        }
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        Ball ??= FootballBall.First;
        if (Ball is null)
        {
            return;
        }

        int room = 1 + (int)(Seconds / Ball.Runner.TimeStep);
        if (_points.Length != room)
        {
            _points = new Vector3[room];
        }

        bool shows = _aims || Ball.Motion != MotionState.Rest;
        int count = !shows ? 0 : _aims ? Ball.PredictKick(_velocity, _spin, _points) : Ball.PredictPath(_points);
        FootballDrawing.Trace(_lines[0], _points.AsSpan(0, count));
        for (int i = 0; i < Sides; i++)
        {
            FootballDrawing.Trace(_lines[1 + i], _points.AsSpan(0, _aims ? Ball.PredictKick(Off(i), _spin, _points) : 0));
        }
    }

    /// <summary>Returns the kick that is two standard deviations off, to one of the sides.</summary>
    private Vector3 Off(int side)
    {
        (float sin, float cos) = MathF.SinCos(side * (2 * MathF.PI / Sides));
        float speed = _velocity.Length();
        Vector3 ahead = _velocity * (1 / MathF.Max(speed, 1e-6f));
        Vector3 right = ahead.Cross(new Vector3(0, 1, 0));
        right = right.Length() > 1e-3f ? right * (1 / right.Length()) : new Vector3(1, 0, 0);
        Vector3 up = right.Cross(ahead);
        float angle = Mathf.DegToRad(2 * Degrees);
        Vector3 direction = ahead + (right * (angle * cos)) + (up * (angle * sin));
        return direction * ((1 + (0.02f * SpeedPercent * sin)) * speed / direction.Length());
    }
}
