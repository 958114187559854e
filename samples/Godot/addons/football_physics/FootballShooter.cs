#nullable enable
using System;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Shoots by mouse: press at the target and hold; a longer press gives a faster shot. With the right button, the ball bends to the left. R resets the ball.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballShooter : Node
{
    private Vector3? _spot;
    private double _held;
    private bool _bends;

    /// <summary>The ball; empty: the first in the tree.</summary>
    [Export]
    public FootballBall? Ball { get; set; }

    /// <summary>The node that shows the aimed kick; empty: the kick is not shown.</summary>
    [Export]
    public FootballPath? Path { get; set; }

    /// <summary>Ball speed after a short press, m/s.</summary>
    [Export(PropertyHint.Range, "1,60,0.1,suffix:m/s")]
    public float Slowest { get; set; } = 14;

    /// <summary>Ball speed after the longest press, m/s.</summary>
    [Export(PropertyHint.Range, "1,60,0.1,suffix:m/s")]
    public float Fastest { get; set; } = 34;

    /// <summary>Duration of the longest press, s.</summary>
    [Export(PropertyHint.Range, "0.1,5,0.1,suffix:s")]
    public float Longest { get; set; } = 1;

    /// <summary>Sidespin with the right button, rad/s.</summary>
    [Export(PropertyHint.Range, "0,200,1,suffix:rad/s")]
    public float Bend { get; set; } = 60;

    /// <summary>Extra elevation above the mouse pointer, degrees, because the ball drops on its path.</summary>
    [Export(PropertyHint.Range, "-45,45,0.1,suffix:°")]
    public float Lift { get; set; } = 4;

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        Ball ??= FootballBall.First;
        Camera3D? view = GetViewport().GetCamera3D();
        if (Ball is null || view is null)
        {
            return;
        }

        _spot ??= Ball.GlobalPosition;
        if (Input.IsKeyPressed(Key.R))
        {
            Ball.Place(_spot.Value);
        }

        bool right = Input.IsMouseButtonPressed(MouseButton.Right);
        if (right || Input.IsMouseButtonPressed(MouseButton.Left))
        {
            _bends = right;
            _held += delta;
            Vector3 direction = Aimed(view, Ball.GlobalPosition);
            Vector3d spin = KickVectors.Spin(GodotFrame.FromGodot(direction), 0, _bends ? Bend : 0);
            Path?.ShowKick(direction * Speed(), GodotFrame.SpinToGodot(spin));
        }
        else if (_held > 0)
        {
            Ball.Kick(Speed(), Aimed(view, Ball.GlobalPosition), 0, _bends ? Bend : 0);
            _held = 0;
            Path?.HideKick();
        }
    }

    private float Speed() => Slowest + ((Fastest - Slowest) * MathF.Min(1, (float)_held / Longest));

    /// <summary>Returns the direction from the ball to the mouse pointer, at the distance of the goal, with the extra elevation.</summary>
    private Vector3 Aimed(Camera3D view, Vector3 place)
    {
        Vector2 at = GetViewport().GetMousePosition();
        Vector3 origin = view.ProjectRayOrigin(at);
        Vector3 ray = view.ProjectRayNormal(at);
        float far = 20;
        foreach (FootballGoal goal in FootballThing.Goals)
        {
            float along = (goal.GlobalPosition - origin).Dot(ray);
            far = along > 1 ? along : far;
        }

        Vector3 direction = origin + (ray * far) - place;
        float level = MathF.Sqrt((direction.X * direction.X) + (direction.Z * direction.Z));
        direction.Y = MathF.Max(direction.Y, 0) + (level * Mathf.DegToRad(Lift));
        return direction * (1 / MathF.Max(direction.Length(), 1e-3f));
    }
}
