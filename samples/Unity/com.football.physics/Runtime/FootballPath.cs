using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Shows the predicted path in the game view: a line for the ball, and a cone around it for the spread of the player's kicks.</summary>
    /// <remarks>It shows the kick of <see cref="Show"/> during aiming, and otherwise the path of the flying ball.</remarks>
    [AddComponentMenu("Football/Football Path"), DisallowMultipleComponent]
    public sealed class FootballPath : MonoBehaviour
    {
        /// <summary>The number of lines of the cone.</summary>
        public const int Sides = 8;

        [SerializeField, Tooltip("The ball; empty: the first in the scene.")]
        private FootballBall ball;

        [SerializeField, Range(0.1f, 10f), Tooltip("Length of the path shown, s.")]
        private float seconds = 1.6f;

        [SerializeField, Range(0f, 10f), Tooltip("Standard deviation of the direction, degrees; the band shows two of them.")]
        private float degrees = 1f;

        [SerializeField, Range(0f, 30f), Tooltip("Standard deviation of the speed, %.")]
        private float speedPercent = 3f;

        [SerializeField, Tooltip("Colour of the line.")]
        private Color color = new Color(1f, 0.92f, 0.016f, 1f);

        [SerializeField, Tooltip("Material of the lines; empty: the default of the render pipeline.")]
        private Material material;

        private Vector3[] _points = Array.Empty<Vector3>();
        private FootballDrawing _drawing;
        private LineRenderer[] _lines;
        private bool _aims;
        private Vector3 _velocity;
        private Vector3 _spin;

        /// <summary>The ball whose path is shown.</summary>
        public FootballBall Ball { get => ball; set => ball = value; }

        /// <summary>The material for drawing; null: the default of the render pipeline. A change takes effect when the component is enabled.</summary>
        public Material Material { get => material; set => material = value; }

        /// <summary>The line of the path, followed by the lines of the cone.</summary>
        public LineRenderer[] Lines => _lines;

        /// <summary>Shows an aimed kick, until <see cref="Hide"/>.</summary>
        /// <param name="velocity">Velocity, m/s.</param>
        /// <param name="spin">Spin, rad/s.</param>
        public void Show(Vector3 velocity, Vector3 spin)
        {
            _aims = true;
            _velocity = velocity;
            _spin = spin;
        }

        /// <summary>Shows the path of the ball itself again.</summary>
        public void Hide()
        {
            _aims = false;
        }

        private void OnEnable()
        {
            _drawing = new FootballDrawing(gameObject, material);
            _lines = new LineRenderer[1 + Sides];
            Material drawn = _drawing.Made(color, null);
            for (int i = 0; i < _lines.Length; i++)
            {
                _lines[i] = _drawing.AddLine(i == 0 ? "path" : "cone", drawn, i == 0 ? 0.04f : 0.012f);
            }
        }

        private void OnDisable()
        {
            _drawing.Clear();
        }

        private void LateUpdate()
        {
            ball = ball != null ? ball : FootballFinder.Ball();
            if (ball == null)
            {
                return;
            }

            int room = 1 + (int)(seconds / ball.TimeStep);
            if (_points.Length != room)
            {
                _points = new Vector3[room];
            }

            bool shows = _aims || ball.Motion != MotionState.Rest;
            Put(_lines[0], shows ? (_aims ? ball.PredictKick(_velocity, _spin, _points) : ball.PredictPath(_points)) : 0);
            for (int i = 0; i < Sides; i++)
            {
                Put(_lines[1 + i], _aims ? ball.PredictKick(Off(i), _spin, _points) : 0);
            }
        }

        private void Put(LineRenderer line, int count)
        {
            line.positionCount = count;
            if (count > 0)
            {
                line.SetPositions(_points);
            }
        }

        /// <summary>Returns the kick that is two standard deviations off, to one of the sides.</summary>
        private Vector3 Off(int side)
        {
            float turn = side * (2f * Mathf.PI / Sides);
            float speed = _velocity.magnitude;
            Vector3 ahead = _velocity * (1f / Math.Max(speed, 1e-6f));
            Vector3 right = Vector3.Cross(new Vector3(0f, 1f, 0f), ahead);
            right = right.magnitude > 1e-3f ? right * (1f / right.magnitude) : new Vector3(1f, 0f, 0f);
            Vector3 up = Vector3.Cross(ahead, right);
            float angle = 2f * degrees * Mathf.Deg2Rad;
            float faster = 1f + (0.02f * speedPercent * Mathf.Sin(turn));
            Vector3 direction = ahead + (right * (angle * Mathf.Cos(turn))) + (up * (angle * Mathf.Sin(turn)));
            return direction * (faster * speed / direction.magnitude);
        }
    }
}
