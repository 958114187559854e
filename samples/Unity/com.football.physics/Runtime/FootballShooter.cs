using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Shoots by mouse: press at the target and hold; a longer press gives a faster shot. With the right button, the ball bends to the left. R resets the ball.</summary>
    [AddComponentMenu("Football/Football Shooter"), DisallowMultipleComponent]
    public sealed class FootballShooter : MonoBehaviour
    {
        [SerializeField, Tooltip("The ball; empty: the first in the scene.")]
        private FootballBall ball;

        [SerializeField, Tooltip("Camera for the mouse; empty: the main camera.")]
        private Camera view;

        [SerializeField, Tooltip("Football Path that shows the aimed kick; empty: the one on this object, if any.")]
        private FootballPath path;

        [SerializeField, Range(1f, 60f), Tooltip("Ball speed after a short press, m/s.")]
        private float slowest = 14f;

        [SerializeField, Range(1f, 60f), Tooltip("Ball speed after the longest press, m/s.")]
        private float fastest = 34f;

        [SerializeField, Range(0.1f, 5f), Tooltip("Duration of the longest press, s.")]
        private float longest = 1f;

        [SerializeField, Range(0f, 200f), Tooltip("Sidespin with the right button, rad/s.")]
        private float bend = 60f;

        [SerializeField, Range(-45f, 45f), Tooltip("Extra elevation above the mouse pointer, degrees, because the ball drops on its path.")]
        private float lift = 4f;

        private Vector3 _spot;
        private bool _hasSpot;
        private bool _bends;
        private float _held;

        /// <summary>The ball.</summary>
        public FootballBall Ball { get => ball; set => ball = value; }

        /// <summary>The camera through which the mouse points.</summary>
        public Camera View { get => view; set => view = value; }

        /// <summary>The component that shows the aimed kick.</summary>
        public FootballPath Path { get => path; set => path = value; }

        private void Update()
        {
            ball = ball != null ? ball : FootballFinder.Ball();
            view = view != null ? view : Camera.main;
            if (path == null)
            {
                TryGetComponent(out path);
            }

            if (ball == null || view == null)
            {
                return;
            }

            if (!_hasSpot)
            {
                _hasSpot = true;
                _spot = ball.transform.position;
            }

            if (FootballPointer.Again)
            {
                ball.Place(_spot);
            }

            if (FootballPointer.Left || FootballPointer.Right)
            {
                _bends = FootballPointer.Right;
                _held += Time.deltaTime;
                if (path != null)
                {
                    Vector3d direction = UnityFrame.FromUnity(Aimed());
                    path.Show(Aimed() * Speed(), UnityFrame.SpinToUnity(KickVectors.Spin(direction, 0, _bends ? bend : 0f)));
                }
            }
            else if (_held > 0f)
            {
                ball.Kick(Speed(), Aimed(), 0f, _bends ? bend : 0f);
                _held = 0f;
                if (path != null)
                {
                    path.Hide();
                }
            }
        }

        private float Speed()
        {
            return slowest + ((fastest - slowest) * Mathf.Clamp(_held / longest, 0f, 1f));
        }

        /// <summary>Returns the direction from the ball to the mouse pointer, at the distance of the nearest goal, with the extra elevation.</summary>
        private Vector3 Aimed()
        {
            Vector2 at = FootballPointer.Position;
            Ray ray = view.ScreenPointToRay(new Vector3(at.x, at.y, 0f));
            Vector3 place = ball.transform.position;
            float far = 20f;
            foreach (FootballGoal goal in FootballFinder.Goals())
            {
                Vector3 towards = goal.transform.position - ray.origin;
                float along = Vector3.Dot(towards, ray.direction);
                far = along > 1f ? along : far;
            }

            Vector3 direction = ray.origin + (ray.direction * far) - place;
            float level = Mathf.Sqrt((direction.x * direction.x) + (direction.z * direction.z));
            direction.y = Mathf.Max(direction.y, 0f) + (level * lift * Mathf.Deg2Rad);
            return direction * (1f / Mathf.Max(direction.magnitude, 1e-3f));
        }
    }
}
