using System.Numerics;

namespace Raylib_cs;

public enum KeyboardKey
{
    Space = 32,
}

public enum CameraProjection
{
    Perspective,
    Orthographic,
}

public struct Camera3D
{
    public Vector3 Position;
    public Vector3 Target;
    public Vector3 Up;
    public float FovY;
    public CameraProjection Projection;

    public Camera3D(Vector3 position, Vector3 target, Vector3 up, float fovY, CameraProjection projection)
    {
        Position = position;
        Target = target;
        Up = up;
        FovY = fovY;
        Projection = projection;
    }
}

public readonly record struct Color(byte R, byte G, byte B, byte A)
{
    public static Color White => new(255, 255, 255, 255);

    public static Color Black => new(0, 0, 0, 255);

    public static Color RayWhite => new(245, 245, 245, 255);

    public static Color SkyBlue => new(102, 191, 255, 255);

    public static Color DarkGreen => new(0, 117, 44, 255);

    public static Color DarkBlue => new(0, 82, 172, 255);
}

/// <summary>A window without a screen: it stays open for 2.5 seconds, space is pressed in frame 10, and each frame is recorded.</summary>
public static class Raylib
{
    private const int Frames = 150;
    private static bool s_drawing;
    private static bool s_in3D;
    private static Frame? s_frame;

    /// <summary>The frames drawn so far.</summary>
    public static List<Frame> Drawn { get; } = [];

    /// <summary>True between InitWindow and CloseWindow.</summary>
    public static bool IsOpen { get; private set; }

    public static void InitWindow(int width, int height, string title)
    {
        IsOpen = true;
        Drawn.Clear();
    }

    public static void CloseWindow() => IsOpen = !Require(IsOpen, "The window is not open.");

    public static bool WindowShouldClose() => Require(IsOpen, "The window is not open.") && Drawn.Count == Frames;

    public static void SetTargetFPS(int fps) => Require(IsOpen, "The window is not open.");

    public static float GetFrameTime() => 1f / 60;

    public static bool IsKeyPressed(KeyboardKey key) => key == KeyboardKey.Space && Drawn.Count == 10;

    public static void BeginDrawing()
    {
        s_drawing = Require(IsOpen && !s_drawing, "BeginDrawing before EndDrawing.");
        s_frame = new Frame();
    }

    public static void EndDrawing()
    {
        s_drawing = !Require(s_drawing && !s_in3D, "EndDrawing without BeginDrawing, or before EndMode3D.");
        Drawn.Add(s_frame!);
    }

    public static void ClearBackground(Color color) => Require(s_drawing, "ClearBackground outside a frame.");

    public static void BeginMode3D(Camera3D camera)
    {
        s_in3D = Require(s_drawing && !s_in3D, "BeginMode3D outside a frame.");
        s_frame!.Camera = camera;
    }

    public static void EndMode3D() => s_in3D = !Require(s_in3D, "EndMode3D without BeginMode3D.");

    public static void DrawPlane(Vector3 centerPos, Vector2 size, Color color) => In3D().Planes++;

    public static void DrawCylinder(Vector3 position, float radiusTop, float radiusBottom, float height, int slices, Color color) => In3D().Cylinders.Add(position);

    public static void DrawCapsule(Vector3 startPos, Vector3 endPos, float radius, int slices, int rings, Color color) => In3D().Capsules.Add((startPos, endPos));

    public static void DrawSphere(Vector3 centerPos, float radius, Color color) => In3D().Spheres.Add((centerPos, radius));

    public static void DrawText(string text, int posX, int posY, int fontSize, Color color)
    {
        Require(s_drawing && !s_in3D, "DrawText outside a frame, or in 3D.");
        s_frame!.Text = text;
    }

    private static Frame In3D()
    {
        Require(s_in3D, "A shape outside BeginMode3D.");
        return s_frame!;
    }

    private static bool Require(bool holds, string otherwise) => holds ? true : throw new InvalidOperationException(otherwise);

    /// <summary>The shapes of a frame.</summary>
    public sealed class Frame
    {
        public Camera3D Camera { get; set; }

        public int Planes { get; set; }

        public List<Vector3> Cylinders { get; } = [];

        public List<(Vector3 Start, Vector3 End)> Capsules { get; } = [];

        public List<(Vector3 Center, float Radius)> Spheres { get; } = [];

        public string Text { get; set; } = "";
    }
}
