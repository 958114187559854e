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
    }

    public static class Undo
    {
        public static List<string> Recorded { get; } = new List<string>();

        public static void RecordObject(UnityEngine.Object changed, string name) => Recorded.Add(name);
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

        public static Vector3 PositionHandle(Vector3 position, Quaternion rotation)
        {
            Changed = Drag.HasValue;
            return Drag ?? position;
        }
    }
}
