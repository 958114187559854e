using System;
using UnityEngine;

namespace Football.Physics.Unity
{
    /// <summary>A football on a game object: stepped in FixedUpdate, drawn in Update, all in Unity's frame.</summary>
    [AddComponentMenu("Football/Football Ball"), DisallowMultipleComponent]
    public sealed class FootballBall : MonoBehaviour
    {
        [SerializeField, Tooltip("Ball, air, ground and method; empty: a football over turf in still air.")]
        private FootballPreset preset;

        [SerializeField, Min(0f), Tooltip("How much of the path ahead the gizmo shows, s.")]
        private float gizmoSeconds = 3f;

        private FixedStepRunner _runner;

        /// <summary>The ball hit the ground.</summary>
        public event Action<FootballBall, FootballEvent> Impact;

        /// <summary>After an impact the ball stayed down, slipping.</summary>
        public event Action<FootballBall, FootballEvent> Slide;

        /// <summary>The ball began to roll without slip.</summary>
        public event Action<FootballBall, FootballEvent> Roll;

        /// <summary>The ball came to rest.</summary>
        public event Action<FootballBall, FootballEvent> Rest;

        /// <summary>The preset; a new one counts from the next Awake.</summary>
        public FootballPreset Preset
        {
            get => preset;
            set => preset = value;
        }

        /// <summary>The fixed-step runner behind the component: state, tick, kicks by tick, rollback. In the library's frame.</summary>
        public FixedStepRunner Runner => _runner;

        /// <summary>Velocity, m/s.</summary>
        public Vector3 Velocity => UnityFrame.ToUnity(_runner.State.Velocity);

        /// <summary>Spin, rad/s, as Rigidbody.angularVelocity has it.</summary>
        public Vector3 Spin => UnityFrame.SpinToUnity(_runner.State.Spin);

        /// <summary>What the ball is doing.</summary>
        public MotionState Motion => _runner.State.Motion;

        /// <summary>Kicks the ball at the next fixed step.</summary>
        public void Kick(Vector3 velocity, Vector3 spin)
        {
            _runner.QueueKick(UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin));
        }

        /// <summary>Kicks the ball: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
        public void Kick(float speed, Vector3 direction, float topSpin = 0f, float sideSpin = 0f)
        {
            _runner.QueueKick(speed, UnityFrame.FromUnity(direction), topSpin, sideSpin);
        }

        /// <summary>Puts the ball somewhere, at rest.</summary>
        public void Place(Vector3 position)
        {
            _runner.Place(UnityFrame.FromUnity(position));
            Draw(1.0);
        }

        /// <summary>The path ahead, if nobody touches the ball: a point every fixed step, the present one first.</summary>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in; fewer than there is room for when the ball comes to rest.</returns>
        public int PredictPath(Span<Vector3> points)
        {
            BallState state = _runner.State;
            var log = new StepLog();
            int count = 0;
            while (count < points.Length)
            {
                points[count++] = UnityFrame.ToUnity(state.Position);
                if (state.Motion == MotionState.Stopped)
                {
                    break;
                }

                log.Clear();
                _runner.Simulator.Step(ref state, _runner.TimeStep, log);
            }

            return count;
        }

        private void Awake()
        {
            Simulator simulator = preset != null ? preset.Compile() : new Simulator();
            _runner = new FixedStepRunner(simulator, Time.fixedDeltaTime, Math.Max(Time.fixedDeltaTime, 0.25));
            Place(transform.position);
        }

        private void FixedUpdate()
        {
            _runner.Step();
            for (int i = 0; i < _runner.Events.Count; i++)
            {
                Raise(new FootballEvent(in _runner.Events[i]));
            }
        }

        private void Update()
        {
            Draw((Time.timeAsDouble - Time.fixedTimeAsDouble) / Time.fixedDeltaTime);
        }

        private void OnDrawGizmosSelected()
        {
            if (_runner == null)
            {
                return;
            }

            int room = 1 + (int)(gizmoSeconds / _runner.TimeStep);
            var points = new Vector3[room];
            int count = PredictPath(points);
            Gizmos.color = Color.yellow;
            for (int i = 1; i < count; i++)
            {
                Gizmos.DrawLine(points[i - 1], points[i]);
            }

            Gizmos.DrawWireSphere(points[count - 1], (float)_runner.Simulator.Scene.Ball.Radius);
        }

        private void Draw(double fraction)
        {
            BallPose pose = _runner.PoseAt(fraction);
            transform.SetPositionAndRotation(UnityFrame.ToUnity(pose.Position), UnityFrame.ToUnity(pose.Orientation));
        }

        private void Raise(FootballEvent happened)
        {
            switch (happened.Kind)
            {
                case BallEventKind.Impact:
                    Impact?.Invoke(this, happened);
                    break;
                case BallEventKind.Slide:
                    Slide?.Invoke(this, happened);
                    break;
                case BallEventKind.Roll:
                    Roll?.Invoke(this, happened);
                    break;
                default:
                    Rest?.Invoke(this, happened);
                    break;
            }
        }
    }
}
