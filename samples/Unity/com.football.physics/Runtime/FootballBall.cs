using System;
using FootballPhysics.Netcode;
using Unity.Profiling;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>A football on a game object that steps in FixedUpdate, in the time of the game, and draws in Update. All values are in Unity's frame.</summary>
    /// <remarks>
    /// The library moves the ball, so its Rigidbody is kinematic; it serves triggers and other code that needs bodies. The ball hits every goal, pitch, wall and keeper of the scene, and
    /// the colliders in the layers of Hits. Changes of the ball, its preset or these objects take effect in the next step.
    /// </remarks>
    [AddComponentMenu("Football/Football Ball"), DisallowMultipleComponent, RequireComponent(typeof(Rigidbody))]
    public sealed partial class FootballBall : MonoBehaviour
    {
        /// <summary>The tolerance of the time of a step, as a fraction of the step, because Unity's clock adds single-precision numbers.</summary>
        private const double AlmostDue = 1e-3;

        /// <summary>If the object is farther than this from its drawn position, m, other code moved it.</summary>
        private const float Moved = 1e-3f;

        private static readonly ProfilerMarker s_step = new ProfilerMarker("Football.Step");
        private static readonly ProfilerMarker s_compile = new ProfilerMarker("Football.Compile");
        private static readonly ProfilerMarker s_path = new ProfilerMarker("Football.Path");
        private static readonly ProfilerMarker s_draw = new ProfilerMarker("Football.Draw");

        [SerializeField, Tooltip("Ball, air, ground, integrator and time step; empty: the measured profile (a match ball, still air), in steps of 0.02 s.")]
        private FootballPreset preset;

        [SerializeField, Tooltip("Kick that the editor previews and KickAsPreviewed performs.")]
        private FootballKick kick = new FootballKick();

        [SerializeField, Range(0.1f, 20f), Tooltip("Length of the path that the gizmo shows, s.")]
        private float gizmoSeconds = 3f;

        [SerializeField, Tooltip("Layers of the colliders that the ball hits; none: only football components and the ground.")]
        private LayerMask hits;

        [SerializeField, Tooltip("Maximum speed of colliders that can hit the ball, m/s.")]
        private float greatestSpeed = 15f;

        [SerializeField]
        private FootballBallEvents events = new FootballBallEvents();

        private FootballScene _scene;
        private FixedStepRunner _runner;
        private Action<double> _moveKeepers;
        private int _stamp;
        private double _elapsed;
        private long _steps;
        private Vector3 _drawnAt;
        private bool _warned;

        /// <summary>The preset. A change takes effect in the next step.</summary>
        public FootballPreset Preset
        {
            get => preset;
            set => preset = value;
        }

        /// <summary>The layers whose colliders the ball hits. A change takes effect in the next step.</summary>
        public LayerMask Hits
        {
            get => hits;
            set => hits = value;
        }

        /// <summary>Maximum speed of colliders that can hit the ball, m/s.</summary>
        public float GreatestSpeed
        {
            get => greatestSpeed;
            set => greatestSpeed = value;
        }

        /// <summary>The kick that the editor shows.</summary>
        public FootballKick PreviewedKick => kick;

        /// <summary>Radius of the ball, m.</summary>
        public float Radius => (float)(preset != null ? preset.BallOf() : BallProperties.Modern).Radius;

        /// <summary>The length of a step, s, from the preset.</summary>
        public double TimeStep => preset != null ? preset.timeStep : FootballPreset.DefaultTimeStep;

        /// <summary>The fixed-step runner behind the component: state, tick, kicks by tick, rollback. It uses the library's frame. A preset with another time step creates a new runner.</summary>
        /// <exception cref="InvalidOperationException">Awake has not run yet.</exception>
        public FixedStepRunner Runner => _runner
            ?? throw new InvalidOperationException("The football \"" + name + "\" has no Awake behind it yet: use it from Start on, and only while its game object is active.");

        /// <summary>Velocity, m/s.</summary>
        public Vector3 Velocity => UnityFrame.ToUnity(Runner.State.Velocity);

        /// <summary>The spin, rad/s, in the convention of Rigidbody.angularVelocity.</summary>
        public Vector3 Spin => UnityFrame.SpinToUnity(Runner.State.Spin);

        /// <summary>The motion state of the ball.</summary>
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

        /// <summary>Places the ball at rest. While a rollback is attached to the runner, this is a PlaceInput of the next step, and the clock continues.</summary>
        public void Place(Vector3 position)
        {
            if (Runner.Rollback != null)
            {
                Runner.QueuePlace(UnityFrame.FromUnity(position));
                return;
            }

            Runner.Place(UnityFrame.FromUnity(position));
            Draw(1.0);
        }

        /// <summary>Moves the keepers at the start of a step. Call it if you set MoveBodies of the runner yourself, for instance to move Unity's colliders in a rollback.</summary>
        public void MoveKeepers()
        {
            _scene.Stage.BeforeStep(Runner);
        }

        /// <summary>Applies changes to the ball, its preset or the scene at once. Otherwise they take effect before the next step.</summary>
        /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message contains its name. The ball keeps its previous settings.</exception>
        public void Apply()
        {
            using (s_compile.Auto())
            {
                _stamp = Stamp();
                TryGetComponent(out Rigidbody own);

                // Create all new objects before replacing the old ones, so that a rejected value changes nothing.
                var scene = new FootballScene(preset, hits.value, greatestSpeed, own);
                bool begins = _runner == null;
                if (begins)
                {
                    _runner = new FixedStepRunner(scene.Stage.Game, TimeStep, Math.Max(TimeStep, 0.25));
                }
                else
                {
                    StepBy(TimeStep);
                    _runner.Simulator = scene.Stage.Game;
                }

                _scene = scene;
                if (begins)
                {
                    Place(transform.position);
                }
            }
        }

        /// <summary>Compiles a new simulator for the ball's scene: its preset, and the enabled goals, pitches, walls and keepers, without colliders.</summary>
        /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message contains its name.</exception>
        public Simulator CompileScene()
        {
            return new FootballScene(preset, 0, 0f, null).Stage.Game;
        }

        private void Reset()
        {
            BeKinematic();
            if (!TryGetComponent(out MeshRenderer _))
            {
                gameObject.AddComponent<FootballSkin>();
            }
        }

        private void Awake()
        {
            FootballWarmUp.Begin();
            BeKinematic();
            _elapsed = 0.0;
            _steps = 0;
            if (GetComponentInChildren<Renderer>() == null)
            {
                gameObject.AddComponent<FootballSkin>();
            }

            Apply();
        }

        private void FixedUpdate()
        {
            using (s_step.Auto())
            {
                ApplyChanges();
                if (_runner == null)
                {
                    return;     // the first scene was invalid, which was reported; the next valid one starts the ball
                }

                _elapsed += Time.fixedDeltaTime;
                _scene.GreatestSpeed = greatestSpeed;

                // The positions of Unity's bodies hold at this time, on the clock of the ball.
                _scene.CollidersAreAt(_runner.State.Time);
                while ((_steps + 1) * _runner.TimeStep <= _elapsed + (AlmostDue * _runner.TimeStep))
                {
                    MoveKeepersInSteps();
                    if (_runner.MoveBodies == null)
                    {
                        MoveKeepers();
                    }

                    _runner.Step();
                    _steps++;
                    _scene.Stage.AfterStep(_runner.State);
                    for (int i = 0; i < _runner.Events.Count; i++)
                    {
                        FootballEvent happened = _scene.Convert(in _runner.Events[i]);
                        _scene.Push(in happened);
                        Raise(happened);
                    }
                }
            }
        }

        private void Update()
        {
            using (s_draw.Auto())
            {
                if (_runner == null)
                {
                    return;
                }

                if (!_warned && (transform.position - _drawnAt).magnitude > Moved)
                {
                    _warned = true;
                    Debug.LogWarning("The football \"" + name + "\" was moved by its transform, which has no effect because the simulation sets its position. Call Place(position) or Kick instead.", this);
                }

                double ahead = _elapsed + (Time.timeAsDouble - Time.fixedTimeAsDouble) - (_steps * _runner.TimeStep);
                Draw(Math.Min(1.0, Math.Max(0.0, ahead / _runner.TimeStep)));
                _scene.Draw();
            }
        }

        /// <summary>A hash that changes when any input of the scene changes.</summary>
        private int Stamp()
        {
            return HashCode.Combine(preset, preset != null ? preset.Stamp : 0, hits.value, FootballThing.StampOfAll);
        }

        /// <summary>Applies changes. A value out of range is reported once, and the ball keeps its previous settings.</summary>
        private void ApplyChanges()
        {
            if (Stamp() == _stamp)
            {
                return;
            }

            try
            {
                Apply();
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                Debug.LogError("The football \"" + name + "\" keeps its previous settings: " + refusal.Message, this);
            }
        }

        /// <summary>Continues from this tick with another step length, and keeps the pending kicks and places.</summary>
        private void StepBy(double timeStep)
        {
            if (_runner.TimeStep == timeStep)
            {
                return;
            }

            var runner = new FixedStepRunner(_runner.Simulator, timeStep, Math.Max(timeStep, 0.25));
            runner.Restore(0, _runner.State);
            for (int i = _runner.Kicks.FirstAt(_runner.Tick); i < _runner.Kicks.Count; i++)
            {
                KickInput waiting = _runner.Kicks[i];
                runner.Kicks.Add(new KickInput(waiting.Tick - _runner.Tick, waiting.Velocity, waiting.Spin, waiting.Player));
            }

            for (int i = _runner.Kicks.FirstPlaceAt(_runner.Tick); i < _runner.Kicks.PlaceCount; i++)
            {
                PlaceInput waiting = _runner.Kicks.PlaceAt(i);
                runner.Kicks.Add(new PlaceInput(waiting.Tick - _runner.Tick, waiting.Player, 0, waiting.Position, waiting.Velocity, waiting.Spin, waiting.Orientation));
            }

            // Keep the callback of the game.
            runner.MoveBodies = _runner.MoveBodies;

            _runner = runner;
            _elapsed = 0.0;
            _steps = 0;
        }

        /// <summary>Moves the keepers in MoveBodies, so that a rollback moves them again in each step that it repeats.</summary>
        /// <remarks>With moving colliders of Unity, the component does not do so: only the game can move those back in time, and a rollback throws until it does.</remarks>
        private void MoveKeepersInSteps()
        {
            if (_runner.MoveBodies == null || ReferenceEquals(_runner.MoveBodies, _moveKeepers))
            {
                _moveKeepers ??= _ => MoveKeepers();
                _runner.MoveBodies = hits.value == 0 || greatestSpeed <= 0f ? _moveKeepers : null;
            }
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
            _drawnAt = transform.position;
        }
    }
}
