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
}
