using System.Globalization;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Shows the numbers of the first ball as text: speed, spin, Reynolds number, motion and the last event.</summary>
    [AddComponentMenu("Football/Football Numbers"), DisallowMultipleComponent]
    public sealed class FootballNumbers : MonoBehaviour
    {
        [SerializeField, Tooltip("Position of the text from the top left corner, in pixels.")]
        private Vector2 corner = new Vector2(20f, 48f);

        private FootballBall _ball;
        private string _last = "";
        private string _text = "";

        /// <summary>The text.</summary>
        public string Text => _text;

        private void Start()
        {
            _ball = FootballFinder.Ball();
        }

        private void Update()
        {
            if (_ball == null)
            {
                return;
            }

            FixedStepRunner runner = _ball.Runner;
            if (runner.Events.Count > 0)
            {
                ref readonly BallEvent happened = ref runner.Events[runner.Events.Count - 1];
                _last = happened.Kind + " " + runner.NameOf(in happened);
            }

            Scene scene = runner.Simulator.Scene;
            double reynolds = 2.0 * scene.Ball.Radius * (runner.Velocity - scene.Air.Wind).Length / scene.Air.KinematicViscosity;
            _text = string.Format(
                CultureInfo.InvariantCulture, "{0:F1} m/s, {1:F0} rad/s, Re {2:F2}e5, {3}, {4}", runner.Velocity.Length, runner.Spin.Length, reynolds / 1e5, runner.Motion, _last);
        }

        private void OnGUI()
        {
            GUI.Label(new Rect(corner.x, corner.y, 600f, 30f), _text);
        }
    }
}
