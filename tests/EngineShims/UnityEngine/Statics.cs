using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public static class Time
    {
        public static float fixedDeltaTime { get; set; } = 0.02f;

        public static float deltaTime { get; set; } = 1f / 60f;

        public static double timeAsDouble { get; set; }

        public static double fixedTimeAsDouble { get; set; }
    }

    public struct Mathf
    {
        public const float PI = (float)Math.PI;
        public const float Deg2Rad = (float)(Math.PI / 180.0);
        public const float Rad2Deg = (float)(180.0 / Math.PI);

        public static float Sin(float x) => (float)Math.Sin(x);

        public static float Cos(float x) => (float)Math.Cos(x);

        public static float Sqrt(float x) => (float)Math.Sqrt(x);

        public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);

        public static float Max(float a, float b) => Math.Max(a, b);

        public static float Min(float a, float b) => Math.Min(a, b);

        public static float Clamp(float x, float low, float high) => Math.Min(high, Math.Max(low, x));
    }

    public static class Application
    {
        public static bool isPlaying { get; set; }
    }

    public static class Debug
    {
        public static List<string> Said { get; } = new List<string>();

        /// <summary>Warnings and errors.</summary>
        public static List<string> Warned { get; } = new List<string>();

        public static void Log(object message) => Said.Add(message.ToString()!);

        public static void LogWarning(object message) => Warned.Add(message.ToString()!);

        public static void LogWarning(object message, Object context) => Warned.Add(message.ToString()!);

        public static void LogError(object message, Object context) => Warned.Add(message.ToString()!);
    }

    public enum KeyCode
    {
        Space = 32,
        R = 114,
    }

    public static class Input
    {
        /// <summary>What is pressed in this frame.</summary>
        public static KeyCode Pressed { get; set; }

        /// <summary>The mouse button that is held; −1 for none.</summary>
        public static int Held { get; set; } = -1;

        public static Vector3 mousePosition { get; set; }

        public static bool GetKeyDown(KeyCode key) => key == Pressed;

        public static bool GetMouseButton(int button) => button == Held;
    }

    public static class GUI
    {
        /// <summary>What was written.</summary>
        public static List<string> Written { get; } = new List<string>();

        public static void Label(Rect position, string text) => Written.Add(text);
    }

    public class GUILayoutOption
    {
    }

    public static class GUILayout
    {
        /// <summary>The label of the button that is clicked.</summary>
        public static string Clicked { get; set; } = "";

        public static bool Button(string text, params GUILayoutOption[] options) => text == Clicked;

        public static void Label(string text, params GUILayoutOption[] options) => GUI.Written.Add(text);

        public static GUILayoutOption Height(float height) => new GUILayoutOption();
    }

    public static class GUILayoutUtility
    {
        public static Rect GetRect(float width, float height) => new Rect(0f, 0f, width, height);
    }
}

namespace UnityEngine.InputSystem
{
    public sealed class ButtonControl
    {
        public bool isPressed { get; set; }

        public bool wasPressedThisFrame { get; set; }
    }

    public sealed class Vector2Control
    {
        /// <summary>What it reads.</summary>
        public Vector2 Value { get; set; }

        public Vector2 ReadValue() => Value;
    }

    public sealed class Mouse
    {
        public static Mouse? current { get; set; }

        public Vector2Control position { get; } = new Vector2Control();

        public ButtonControl leftButton { get; } = new ButtonControl();

        public ButtonControl rightButton { get; } = new ButtonControl();
    }

    public sealed class Keyboard
    {
        public static Keyboard? current { get; set; }

        public ButtonControl rKey { get; } = new ButtonControl();
    }
}
