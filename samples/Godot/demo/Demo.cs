#nullable enable
using Football.Physics.GodotAddon;
using Godot;

namespace FootballDemo;

/// <summary>Press where the ball is to go and hold: the longer, the faster. The right button bends it, R puts it back.</summary>
public partial class Demo : Node3D
{
    private const float SlowestKick = 12;
    private const float FasterBySecond = 20;
    private const float FastestKick = 34;

    private static readonly Vector3 s_spot = new(0, 0.11f, 0);

    private double _held;

    /// <summary>The ball below this node.</summary>
    public FootballBall Ball => GetNode<FootballBall>("Ball");

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (Input.IsMouseButtonPressed(MouseButton.Left) || Input.IsMouseButtonPressed(MouseButton.Right))
        {
            _held += delta;
        }

        if (Input.IsKeyPressed(Key.R))
        {
            Ball.Place(s_spot);
        }
    }

    /// <inheritdoc/>
    public override void _UnhandledInput(InputEvent @event)
    {
        if (@event is InputEventMouseButton { Pressed: false, ButtonIndex: MouseButton.Left or MouseButton.Right } button)
        {
            Camera3D camera = GetNode<Camera3D>("Camera");
            Vector3 direction = camera.ProjectRayNormal(button.Position);
            float speed = Mathf.Min(FastestKick, SlowestKick + (FasterBySecond * (float)_held));
            Ball.Kick(speed, direction with { Y = direction.Y + 0.25f }, -5, button.ButtonIndex == MouseButton.Right ? 60 : 0);
            _held = 0;
        }
    }
}
