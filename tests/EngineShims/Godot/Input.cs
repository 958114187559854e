namespace Godot;

public enum MouseButton
{
    None,
    Left,
    Right,
}

public enum Key
{
    None,
    R,
}

public static class Input
{
    /// <summary>What is pressed.</summary>
    public static Key PressedKey { get; set; }

    /// <summary>What is pressed of the mouse.</summary>
    public static MouseButton PressedButton { get; set; }

    public static bool IsKeyPressed(Key key) => key == PressedKey;

    public static bool IsMouseButtonPressed(MouseButton button) => button == PressedButton;
}

public class InputEvent : Resource
{
}

public class InputEventMouseButton : InputEvent
{
    public MouseButton ButtonIndex { get; set; }

    public bool Pressed { get; set; }

    public Vector2 Position { get; set; }
}

public class Camera3D : Node3D
{
    /// <summary>Where the mouse points, in a test.</summary>
    public Vector3 Pointing { get; set; } = Vector3.Forward;

    public Vector3 ProjectRayNormal(Vector2 screenPoint) => Pointing;

    public Vector3 ProjectRayOrigin(Vector2 screenPoint) => GlobalPosition;
}

public static class Mathf
{
    public static float Min(float a, float b) => Math.Min(a, b);

    public static float DegToRad(float deg) => deg * (MathF.PI / 180);
}
