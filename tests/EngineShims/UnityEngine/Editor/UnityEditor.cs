using System;
using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CustomEditor : Attribute
    {
        public CustomEditor(Type inspectedType) => this.inspectedType = inspectedType;

        public Type inspectedType { get; }
    }

    public class Editor : ScriptableObject
    {
        public UnityEngine.Object target { get; set; } = null!;

        public virtual void OnInspectorGUI()
        {
        }

        public bool DrawDefaultInspector() => false;

        public void Repaint()
        {
        }
    }

    public enum MessageType
    {
        None,
        Info,
        Warning,
        Error,
    }

    public static class EditorGUILayout
    {
        public static List<string> Said { get; } = new List<string>();

        public static void HelpBox(string message, MessageType type) => Said.Add(message);

        public static void LabelField(string label, string text) => Said.Add(label + ": " + text);

        /// <summary>Where the next slider is dragged to; null leaves it.</summary>
        public static int? Slide { get; set; }

        public static int IntSlider(string label, int value, int leftValue, int rightValue) => Math.Clamp(Slide ?? value, leftValue, rightValue);

        public static UnityEngine.Object? ObjectField(string label, UnityEngine.Object? obj, Type objType, bool allowSceneObjects) => obj;
    }

    public static class EditorGUI
    {
        public static void BeginChangeCheck() => Handles.Changed = false;

        public static bool EndChangeCheck() => Handles.Changed;
    }

    public static class EditorUtility
    {
        public static List<UnityEngine.Object> Dirty { get; } = new List<UnityEngine.Object>();

        public static void SetDirty(UnityEngine.Object changed) => Dirty.Add(changed);

        /// <summary>The file that is chosen.</summary>
        public static string Chosen { get; set; } = "";

        public static string OpenFilePanel(string title, string directory, string extension) => Chosen;
    }

    public static class Undo
    {
        public static List<string> Recorded { get; } = new List<string>();

        public static void RecordObject(UnityEngine.Object changed, string name) => Recorded.Add(name);

        public static void RegisterCreatedObjectUndo(UnityEngine.Object objectToUndo, string name) => Recorded.Add(name);
    }

    /// <summary>Remembers what was drawn, and drags a handle where a test wants it.</summary>
    public static class Handles
    {
        public static bool Changed { get; set; }

        /// <summary>Where the next handle is dragged to; null leaves it.</summary>
        public static Vector3? Drag { get; set; }

        public static Color color { get; set; }

        public static List<(Vector3 From, Vector3 To)> Lines { get; } = new List<(Vector3 From, Vector3 To)>();

        public static void DrawLine(Vector3 from, Vector3 to) => Lines.Add((from, to));

        /// <summary>Curves that were drawn.</summary>
        public static List<Vector3[]> Curves { get; } = new List<Vector3[]>();

        /// <summary>Circles that were drawn.</summary>
        public static List<(Vector3 Center, float Radius)> Discs { get; } = new List<(Vector3 Center, float Radius)>();

        public static void DrawAAPolyLine(float width, params Vector3[] points) => Curves.Add((Vector3[])points.Clone());

        public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius) => Discs.Add((center, radius));

        public static Vector3 PositionHandle(Vector3 position, Quaternion rotation)
        {
            Changed = Drag.HasValue;
            return Drag ?? position;
        }
    }
}
