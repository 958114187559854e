using System.Globalization;
using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>The inspector of a ball. While the game runs, it shows the ball's state; otherwise the kick, with a handle in the scene and the path.</summary>
    [CustomEditor(typeof(FootballBall))]
    public sealed class FootballBallEditor : UnityEditor.Editor
    {
        /// <summary>The length of the handle's arm per 1 m/s of speed, m.</summary>
        private const float ArmLength = 0.1f;

        private readonly Vector3[] _path = new Vector3[512];

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var ball = (FootballBall)target;
            if (!Application.isPlaying)
            {
                EditorGUILayout.HelpBox("Drag the handle at the end of the arm to aim the kick; the line shows the path of the ball.", MessageType.Info);
                return;
            }

            EditorGUILayout.LabelField("Motion", ball.Motion.ToString());
            EditorGUILayout.LabelField("Speed", ball.Velocity.magnitude.ToString("0.0", CultureInfo.InvariantCulture) + " m/s");
            EditorGUILayout.LabelField("Spin", ball.Spin.magnitude.ToString("0.0", CultureInfo.InvariantCulture) + " rad/s");
            if (GUILayout.Button("Kick as previewed"))
            {
                ball.KickAsPreviewed();
            }

            Repaint();
        }

        private void OnSceneGUI()
        {
            var ball = (FootballBall)target;
            if (Application.isPlaying)
            {
                return;
            }

            FootballKick kick = ball.PreviewedKick;
            Vector3 from = ball.transform.position;
            Vector3 arm = from + (kick.Direction * (ArmLength * kick.speed));
            Handles.color = Color.yellow;
            Handles.DrawLine(from, arm);
            EditorGUI.BeginChangeCheck();
            Vector3 dragged = Handles.PositionHandle(arm, Quaternion.identity);
            if (EditorGUI.EndChangeCheck())
            {
                Undo.RecordObject(ball, "Aim the kick");
                kick.Set((dragged - from) * (1f / ArmLength));
                EditorUtility.SetDirty(ball);
            }

            int count = ball.PreviewPath(_path);
            for (int i = 1; i < count; i++)
            {
                Handles.DrawLine(_path[i - 1], _path[i]);
            }
        }
    }
}
