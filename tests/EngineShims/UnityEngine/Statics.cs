using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public static class Time
    {
        public static float fixedDeltaTime { get; set; } = 0.02f;

        public static double timeAsDouble { get; set; }

        public static double fixedTimeAsDouble { get; set; }
    }

    /// <summary>Remembers what was drawn.</summary>
    public static class Gizmos
    {
        public static Color color { get; set; }

        public static List<(Vector3 From, Vector3 To)> Lines { get; } = new List<(Vector3 From, Vector3 To)>();

        public static List<(Vector3 Center, float Radius)> Spheres { get; } = new List<(Vector3 Center, float Radius)>();

        public static void DrawLine(Vector3 from, Vector3 to) => Lines.Add((from, to));

        public static void DrawWireSphere(Vector3 center, float radius) => Spheres.Add((center, radius));
    }

    public static class Mathf
    {
        public const float Deg2Rad = (float)(Math.PI / 180.0);
        public const float Rad2Deg = (float)(180.0 / Math.PI);

        public static float Sin(float x) => (float)Math.Sin(x);

        public static float Cos(float x) => (float)Math.Cos(x);

        public static float Sqrt(float x) => (float)Math.Sqrt(x);

        public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);

        public static float Clamp(float x, float low, float high) => Math.Min(high, Math.Max(low, x));
    }

    public static class Application
    {
        public static bool isPlaying { get; set; }
    }

    public static class Debug
    {
        public static List<string> Said { get; } = new List<string>();

        public static void Log(string text) => Said.Add(text);
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

        public static bool GetKeyDown(KeyCode key) => key == Pressed;
    }

    public static class GUILayout
    {
        /// <summary>The label of the button that is clicked.</summary>
        public static string Clicked { get; set; } = "";

        public static bool Button(string text) => text == Clicked;
    }
}
