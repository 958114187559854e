using System;
using System.Globalization;
using FootballPhysics.Engines;
using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>The inspector of a preset: its fields, their drag curve, and the sources of the numbers.</summary>
    [CustomEditor(typeof(FootballPreset))]
    public sealed class FootballPresetEditor : UnityEditor.Editor
    {
        private const float Fastest = 40f;
        private const float Highest = 0.6f;
        private const float Height = 120f;
        private const int Places = 80;

        private readonly Vector3[] _still = new Vector3[Places];
        private readonly Vector3[] _spinning = new Vector3[Places];

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var preset = (FootballPreset)target;
            Simulator simulator;
            try
            {
                simulator = preset.Compile();
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                EditorGUILayout.HelpBox(refusal.Message, MessageType.Error);
                return;
            }

            EditorGUILayout.LabelField("Drag coefficient", "0 … 40 m/s, up to 0.6; grey with 60 rad/s of spin");
            Rect area = GUILayoutUtility.GetRect(100f, Height);
            Trace(simulator, 60.0, area, _spinning, new Color(0.6f, 0.6f, 0.6f, 1f));
            Trace(simulator, 0.0, area, _still, Color.yellow);
            EditorGUILayout.LabelField("At 10, 20 and 30 m/s", string.Format(
                CultureInfo.InvariantCulture,
                "{0:0.000}, {1:0.000} and {2:0.000}",
                AirCurve.Drag(simulator, 10),
                AirCurve.Drag(simulator, 20),
                AirCurve.Drag(simulator, 30)));
            Note("BallProperties", preset.ball == FootballPreset.BallChoice.Generic ? nameof(BallProperties.Tunnel) : preset.ball.ToString(), preset.ball == FootballPreset.BallChoice.Custom);
            Note("SurfaceMaterial", preset.ground == FootballPreset.GroundChoice.OfProfile ? OfProfile(preset) : preset.ground.ToString(), preset.ground == FootballPreset.GroundChoice.Custom);
        }

        private static string OfProfile(FootballPreset preset)
        {
            return preset.profile == FootballPreset.ProfileChoice.Measured ? "MatchTurf" : "PublishedTurf";
        }

        private static void Note(string type, string name, bool isOwn)
        {
            string note = isOwn ? "The numbers above." : FootballNotes.Of(type, name);
            if (note.Length > 0)
            {
                EditorGUILayout.HelpBox(name + ": " + note, MessageType.None);
            }
        }

        private static void Trace(Simulator simulator, double spin, Rect area, Vector3[] points, Color color)
        {
            for (int i = 0; i < Places; i++)
            {
                float speed = Fastest * (i + 1) / Places;
                float drag = Mathf.Clamp((float)AirCurve.Drag(simulator, speed, spin), 0f, Highest);
                points[i] = new Vector3(area.xMin + (area.width * speed / Fastest), area.yMax - (area.height * drag / Highest), 0f);
            }

            Handles.color = color;
            Handles.DrawAAPolyLine(2f, points);
        }
    }
}
