using System;
using System.Globalization;
using System.IO;
using FootballPhysics.Engines;
using FootballPhysics.Netcode;
using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>The window Window → Football → Replay: plays a recording, seeks to any tick, and checks that this machine reproduces it bit for bit.</summary>
    public sealed class FootballReplayWindow : EditorWindow
    {
        private FootballBall _ball;
        private RecordingPlayer _player;
        private string _said = "";
        private bool _plays;
        private double _clock;

        /// <summary>The recording that the window shows; null if there is none.</summary>
        public RecordingPlayer Player => _player;

        /// <summary>The result of the last check.</summary>
        public string Said => _said;

        /// <summary>Opens the window.</summary>
        [MenuItem("Window/Football/Replay")]
        public static void Open()
        {
            GetWindow<FootballReplayWindow>("Football Replay");
        }

        /// <summary>Loads a recording for the scene of a ball: its preset and the goals, pitches, walls and keepers.</summary>
        /// <param name="bytes">The bytes that Recording.ToBytes returned.</param>
        /// <param name="ball">The ball.</param>
        public void Load(byte[] bytes, FootballBall ball)
        {
            _ball = ball;
            _player = null;
            _plays = false;
            try
            {
                _player = new RecordingPlayer(Recording.FromBytes(bytes), ball.CompileScene());
                _said = string.Format(CultureInfo.InvariantCulture, "{0:0.00} s, {1} ticks", _player.Duration, _player.Segment.EndTick - _player.Segment.StartTick);
            }
            catch (Exception refusal) when (refusal is FormatException || refusal is ArgumentException || refusal is InvalidOperationException)
            {
                _said = refusal.Message;
            }
        }

        /// <summary>Replays the recording and checks every tick.</summary>
        public void Validate()
        {
            long? divergence = _player.FindDivergence();
            _said = divergence == null
                ? "Every tick matches the recording bit for bit."
                : string.Format(CultureInfo.InvariantCulture, "Tick {0} is the first that differs from the recording.", divergence);
        }

        private void OnEnable()
        {
            SceneView.duringSceneGui += OnSceneGUI;
        }

        private void OnDisable()
        {
            SceneView.duringSceneGui -= OnSceneGUI;
        }

        private void OnGUI()
        {
            _ball = (FootballBall)EditorGUILayout.ObjectField("Ball of the scene", _ball, typeof(FootballBall), true);
            if (_ball != null && GUILayout.Button("Open recording…"))
            {
                string file = EditorUtility.OpenFilePanel("Match segment", "", "");
                if (file.Length > 0)
                {
                    Load(File.ReadAllBytes(file), _ball);
                }
            }

            if (_player != null)
            {
                int first = (int)_player.Segment.StartTick;
                int tick = EditorGUILayout.IntSlider("Tick", (int)_player.Tick, first, (int)_player.Segment.EndTick);
                if (tick != _player.Tick)
                {
                    _player.Seek(tick);
                }

                if (GUILayout.Button(_plays ? "Pause" : "Play"))
                {
                    _plays = !_plays;
                    _clock = EditorApplication.timeSinceStartup;
                    if (_player.IsOver)
                    {
                        _player.Seek(first);
                    }
                }

                if (GUILayout.Button("Validate"))
                {
                    Validate();
                }

                EditorGUILayout.LabelField("Time", _player.Time.ToString("0.00", CultureInfo.InvariantCulture) + " s");
                EditorGUILayout.LabelField("Ball", _player.State.Motion + ", " + _player.State.Velocity.Length.ToString("0.0", CultureInfo.InvariantCulture) + " m/s");
            }

            EditorGUILayout.HelpBox(_said.Length > 0 ? _said : "Open a file that ball.Runner.Record().ToBytes() wrote.", MessageType.Info);
        }

        private void Update()
        {
            if (_plays && _player != null)
            {
                double now = EditorApplication.timeSinceStartup;
                _player.Advance(Math.Max(0.0, now - _clock));
                _clock = now;
                _plays = !_player.IsOver;
                Repaint();
                SceneView.RepaintAll();
            }
        }

        private void OnSceneGUI(SceneView view)
        {
            if (_player != null && _ball != null)
            {
                Handles.color = Color.yellow;
                Handles.DrawWireDisc(UnityFrame.ToUnity(_player.Pose.Position), new Vector3(0f, 1f, 0f), _ball.Radius);
                Handles.DrawWireDisc(UnityFrame.ToUnity(_player.Pose.Position), new Vector3(0f, 0f, 1f), _ball.Radius);
            }
        }
    }
}
