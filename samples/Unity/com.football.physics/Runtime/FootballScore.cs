using System.Globalization;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Counts and shows the goals of the scene, and resets the ball after a goal, or when a shot comes to rest.</summary>
    [AddComponentMenu("Football/Football Score"), DisallowMultipleComponent]
    public sealed class FootballScore : MonoBehaviour
    {
        [SerializeField, Range(0f, 10f), Tooltip("Delay before the ball is put back after a goal or a shot at rest, s; 0: never.")]
        private float again = 2f;

        private readonly System.Collections.Generic.List<FootballGoal> _goals = new System.Collections.Generic.List<FootballGoal>();
        private FootballBall _ball;
        private Vector3 _spot;
        private float _left;
        private string _text = "Goals 0   Shots 0";

        /// <summary>The number of goals so far.</summary>
        public int Goals { get; private set; }

        /// <summary>The number of shots so far: how often a ball left its spot.</summary>
        public int Shots { get; private set; }

        private void Start()
        {
            _ball = FootballFinder.Ball();
            if (_ball != null)
            {
                _spot = _ball.transform.position;
            }

            foreach (FootballGoal goal in FootballFinder.Goals())
            {
                _goals.Add(goal);
                goal.Scored += OnScored;
            }
        }

        private void OnDestroy()
        {
            foreach (FootballGoal goal in _goals)
            {
                goal.Scored -= OnScored;
            }
        }

        private void Update()
        {
            if (_ball == null)
            {
                return;
            }

            bool away = (_ball.transform.position - _spot).magnitude > 1f;
            if (_left > 0f)
            {
                _left -= Time.deltaTime;
                if (_left <= 0f && again > 0f)
                {
                    _ball.Place(_spot);
                    Shots++;
                    ShowCounts();
                }
            }
            else if (away && _ball.Motion == MotionState.Rest)
            {
                _left = again;
            }
        }

        private void OnGUI()
        {
            GUI.Label(new Rect(20f, 16f, 400f, 30f), _text);
        }

        private void OnScored(FootballGoal goal, FootballEvent happened)
        {
            Goals++;
            _left = again;
            ShowCounts();
        }

        private void ShowCounts()
        {
            _text = string.Format(CultureInfo.InvariantCulture, "Goals {0}   Shots {1}", Goals, Shots);
        }
    }
}
