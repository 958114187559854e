#nullable enable
using System;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Shows the forces on the ball as lines, and its numbers as text: speed, spin, Reynolds number, motion and the last event.</summary>
/// <remarks>The forces are those with which the next step begins. Lines are missing while the ball is in an impact.</remarks>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballForces : Node3D
{
    /// <summary>The number of lines: weight, drag, Magnus force, knuckle force, custom forces, nets, load, friction.</summary>
    public const int Kinds = 8;

    private static readonly Color[] s_colors =
    {
        new(1, 1, 1), new(1, 0.2f, 0.2f), new(0.2f, 0.9f, 0.2f), new(1, 0.2f, 1), new(0.2f, 1, 1), new(0.5f, 0.5f, 0.5f), new(0.2f, 0.4f, 1), new(1, 0.8f, 0.1f),
    };

    private readonly MeshInstance3D[] _lines = new MeshInstance3D[Kinds];
    private readonly Vector3[] _ends = new Vector3[2];
    private Label? _label;
    private string _last = "";

    /// <summary>The ball; empty: the first in the tree.</summary>
    [Export]
    public FootballBall? Ball { get; set; }

    /// <summary>The length of a line, m per N.</summary>
    [Export(PropertyHint.Range, "0,2,0.05")]
    public float MetresPerNewton { get; set; } = 0.2f;

    /// <summary>True to show the numbers. Default true.</summary>
    [Export]
    public bool ShowsNumbers { get; set; } = true;

    /// <summary>The lines, in the order of <see cref="Kinds"/>.</summary>
    public MeshInstance3D[] Lines => _lines;

    /// <summary>The text.</summary>
    public string Numbers => _label?.Text ?? "";

    /// <inheritdoc/>
    public override void _Ready()
    {
        var drawing = new FootballDrawing(this);
        for (int i = 0; i < Kinds; i++)
        {
            _lines[i] = drawing.AddLine(s_colors[i]);
        }

        var layer = new CanvasLayer();
        AddChild(layer, false, InternalMode.Back);
        _label = new Label { Position = new Vector2(20, 48) };
        layer.AddChild(_label, false, InternalMode.Back);
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        Ball ??= FootballBall.First;
        if (Ball is null || _label is null)
        {
            return;
        }

        FixedStepRunner runner = Ball.Runner;
        BallState state = runner.State;
        BallForces? forces = runner.Simulator.ForcesAt(in state, runner.TimeStep);
        Vector3d[] vectors = forces is null
            ? new Vector3d[Kinds]
            : new[] { forces.Weight + forces.Buoyancy, forces.Drag, forces.Magnus, forces.Knuckle, forces.Custom, forces.Nets, forces.Load, forces.Friction };
        for (int i = 0; i < Kinds; i++)
        {
            _ends[0] = GodotFrame.ToGodot(state.Position);
            _ends[1] = GodotFrame.ToGodot(state.Position + (MetresPerNewton * vectors[i]));
            FootballDrawing.Trace(_lines[i], vectors[i].Length * MetresPerNewton > 1e-3 ? _ends : ReadOnlySpan<Vector3>.Empty);
        }

        if (runner.Events.Count > 0)
        {
            ref readonly BallEvent happened = ref runner.Events[runner.Events.Count - 1];
            _last = $"{happened.Kind} {runner.NameOf(in happened)}";
        }

        Scene scene = runner.Simulator.Scene;
        double reynolds = 2 * scene.Ball.Radius * (state.Velocity - scene.Air.Wind).Length / scene.Air.KinematicViscosity;
        _label.Text = ShowsNumbers
            ? FormattableString.Invariant($"{state.Velocity.Length:F1} m/s, {state.Spin.Length:F0} rad/s, Re {reynolds / 1e5:F2}e5, {state.Motion}, {_last}")
            : "";
    }
}
