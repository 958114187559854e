using System;
using UnityEngine;

namespace Football.Physics.Unity
{
    /// <summary>A football on a game object: stepped in FixedUpdate in the time of the game, drawn in Update, all in Unity's frame.</summary>
    /// <remarks>The library moves it, so its Rigidbody is kinematic; it is there for triggers and for what else asks for bodies.</remarks>
    [AddComponentMenu("Football/Football Ball"), DisallowMultipleComponent, RequireComponent(typeof(Rigidbody))]
    public sealed class FootballBall : MonoBehaviour
    {
        /// <summary>A step is due when its time has come but for this part of it: Unity's clock adds single numbers.</summary>
        private const double AlmostDue = 1e-3;

        [SerializeField, Tooltip("Ball, air, ground, method and time step; empty: the measured profile, a football over dry turf in still air, as a new preset has it; in steps of 0.02 s.")]
        private FootballPreset preset;

        [SerializeField, Tooltip("The kick that the editor shows, and that KickAsPreviewed does.")]
        private FootballKick kick = new FootballKick();

        [SerializeField, Range(0.1f, 20f), Tooltip("How much of the path ahead the gizmo shows, s.")]
        private float gizmoSeconds = 3f;

        [SerializeField, Tooltip("Layers whose colliders the ball hits; none: only the ground of its preset.")]
        private LayerMask hits;

        [SerializeField, Tooltip("Not slower than the fastest collider that may hit the ball, m/s.")]
        private float greatestSpeed = 15f;

        [SerializeField]
        private FootballBallEvents events = new FootballBallEvents();

        private readonly StepLog _log = new StepLog();
        private FootballColliders _colliders;
        private FixedStepRunner _runner;
        private Simulator _preview;
        private Vector3[] _path = Array.Empty<Vector3>();
        private double _elapsed;
        private long _steps;

        /// <summary>Something happened to the ball; the events below are by kind.</summary>
        public event Action<FootballBall, FootballEvent> Happened;

        /// <summary>The ball hit something: the ground, a post, a wall.</summary>
        public event Action<FootballBall, FootballEvent> Impact;

        /// <summary>The ball stayed on what carries it, slipping.</summary>
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

        /// <summary>Layers whose colliders the ball hits; new ones count from the next Awake.</summary>
        public LayerMask Hits
        {
            get => hits;
            set => hits = value;
        }

        /// <summary>The kick that the editor shows.</summary>
        public FootballKick PreviewedKick => kick;

        /// <summary>The same events for the inspector.</summary>
        public FootballBallEvents Events => events;

        /// <summary>The fixed-step runner behind the component: state, tick, kicks by tick, rollback. In the library's frame.</summary>
        /// <exception cref="InvalidOperationException">Awake has not run yet.</exception>
        public FixedStepRunner Runner => _runner
            ?? throw new InvalidOperationException("The football \"" + name + "\" has no Awake behind it yet: use it from Start on, and only while its game object is active.");

        /// <summary>Velocity, m/s.</summary>
        public Vector3 Velocity => UnityFrame.ToUnity(Runner.State.Velocity);

        /// <summary>Spin, rad/s, as Rigidbody.angularVelocity has it.</summary>
        public Vector3 Spin => UnityFrame.SpinToUnity(Runner.State.Spin);

        /// <summary>What the ball is doing.</summary>
        public MotionState Motion => Runner.State.Motion;

        /// <summary>Kicks the ball at the next step.</summary>
        public void Kick(Vector3 velocity, Vector3 spin)
        {
            Runner.QueueKick(UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin));
        }

        /// <summary>Kicks the ball: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
        public void Kick(float speed, Vector3 direction, float topSpin = 0f, float sideSpin = 0f)
        {
            Runner.QueueKick(speed, UnityFrame.FromUnity(direction), topSpin, sideSpin);
        }

        /// <summary>Kicks the ball as the editor shows it; for a UnityEvent.</summary>
        public void KickAsPreviewed()
        {
            Kick(kick.speed, kick.Direction, kick.topSpin, kick.sideSpin);
        }

        /// <summary>Puts the ball somewhere, at rest.</summary>
        public void Place(Vector3 position)
        {
            Runner.Place(UnityFrame.FromUnity(position));
            Draw(1.0);
        }

        /// <summary>The path ahead, if nobody touches the ball: a point every step, the present one first. Allocates nothing.</summary>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in; fewer than there is room for when the ball comes to rest.</returns>
        public int PredictPath(Span<Vector3> points)
        {
            return Follow(Runner.Simulator, Runner.State, Runner.TimeStep, points);
        }

        /// <summary>The path of the kick that the editor shows, from where the ball is; without a game running. Allocates nothing once its scene is compiled.</summary>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in.</returns>
        public int PreviewPath(Span<Vector3> points)
        {
            _preview ??= Compile();
            BallState state = _preview.Launch(UnityFrame.FromUnity(transform.position), default, default);
            Vector3d direction = UnityFrame.FromUnity(kick.Direction);
            _preview.Kick(ref state, (kick.speed / direction.Length) * direction, KickVectors.Spin(direction, kick.topSpin, kick.sideSpin));
            return Follow(_preview, state, TimeStep, points);
        }

        private double TimeStep => preset != null ? preset.timeStep : FootballPreset.DefaultTimeStep;

        private Simulator Compile()
        {
            return preset != null ? preset.Compile() : new Simulator();
        }

        private Simulator AmongColliders(Simulator simulator)
        {
            if (hits.value == 0)
            {
                return simulator;
            }

            TryGetComponent(out Rigidbody own);
            _colliders = new FootballColliders(own, hits.value, greatestSpeed);
            return new Simulator(simulator.Scene with { EngineColliders = _colliders }, simulator.Settings);
        }

        private void Reset()
        {
            BeKinematic();
        }

        private void OnValidate()
        {
            _preview = null;
        }

        private void Awake()
        {
            BeKinematic();
            _runner = new FixedStepRunner(AmongColliders(Compile()), TimeStep, Math.Max(TimeStep, 0.25));
            _elapsed = 0.0;
            _steps = 0;
            Place(transform.position);
        }

        private void FixedUpdate()
        {
            _elapsed += Time.fixedDeltaTime;
            if (_colliders != null)
            {
                // Unity has moved its bodies to where they are at this time, on the clock of the ball.
                _colliders.Time = _runner.State.Time;
            }

            while ((_steps + 1) * _runner.TimeStep <= _elapsed + (AlmostDue * _runner.TimeStep))
            {
                _runner.Step();
                _steps++;
                for (int i = 0; i < _runner.Events.Count; i++)
                {
                    Raise(new FootballEvent(in _runner.Events[i], _runner.Simulator.NameOf(_runner.Events[i].Thing)));
                }
            }
        }

        private void Update()
        {
            double ahead = _elapsed + (Time.timeAsDouble - Time.fixedTimeAsDouble) - (_steps * _runner.TimeStep);
            Draw(Math.Min(1.0, Math.Max(0.0, ahead / _runner.TimeStep)));
        }

        private void OnDrawGizmosSelected()
        {
            int room = 1 + (int)(gizmoSeconds / TimeStep);
            if (_path.Length != room)
            {
                _path = new Vector3[room];
            }

            int count = _runner != null ? PredictPath(_path) : PreviewPath(_path);
            Gizmos.color = Color.yellow;
            for (int i = 1; i < count; i++)
            {
                Gizmos.DrawLine(_path[i - 1], _path[i]);
            }

            Simulator simulator = _runner != null ? _runner.Simulator : _preview;
            Gizmos.DrawWireSphere(_path[count - 1], (float)simulator.Scene.Ball.Radius);
        }

        private int Follow(Simulator simulator, BallState state, double timeStep, Span<Vector3> points)
        {
            int count = 0;
            while (count < points.Length)
            {
                points[count++] = UnityFrame.ToUnity(state.Position);
                if (state.Motion == MotionState.Stopped)
                {
                    break;
                }

                _log.Clear();
                simulator.Step(ref state, timeStep, _log);
            }

            return count;
        }

        private void BeKinematic()
        {
            if (TryGetComponent(out Rigidbody body))
            {
                body.isKinematic = true;
                body.useGravity = false;
                body.interpolation = RigidbodyInterpolation.None;
            }
        }

        private void Draw(double fraction)
        {
            BallPose pose = _runner.PoseAt(fraction);
            transform.SetPositionAndRotation(UnityFrame.ToUnity(pose.Position), UnityFrame.ToUnity(pose.Orientation));
        }

        private void Raise(FootballEvent happened)
        {
            Happened?.Invoke(this, happened);
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
                case BallEventKind.Rest:
                    Rest?.Invoke(this, happened);
                    break;
            }

            events.Invoke(happened);
        }
    }
}
