using System;
using FootballPhysics.Engines;
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

        [SerializeField, Range(0f, 2f), Tooltip("Length of the arrows of the forces on the ball in a running game, m per N; 0: no arrows. Weight white, drag red, Magnus green, knuckle magenta, custom cyan, nets grey, loads blue, friction yellow.")]
        private float gizmoForces = 0.2f;

        [SerializeField, Tooltip("Layers of the colliders that the ball hits; none: only football components and the ground.")]
        private LayerMask hits;

        [SerializeField, Tooltip("Maximum speed of colliders that can hit the ball, m/s.")]
        private float greatestSpeed = 15f;

        [SerializeField, Tooltip("Colliders without a Rigidbody take their velocity from their last two positions in FixedUpdate, for animated colliders. Their Animator needs the update mode Fixed (Animate Physics).")]
        private bool velocityFromMotion;

        [SerializeField]
        private FootballBallEvents events = new FootballBallEvents();

        private FootballScene _scene;
        private FixedStepRunner _runner;
        private Action<double> _moveKeepers;
        private int _stamp;
        private readonly EngineClock _clock = new EngineClock();
        private readonly ColliderMotions _motions = new ColliderMotions();
        private Vector3 _drawnAt;
        private double _drawnTime;
        private BallSquash _squash;
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

        /// <summary>True if colliders without a Rigidbody take their velocity from their last two positions in FixedUpdate; default false: they do not move.</summary>
        /// <remarks>Use it for colliders that an Animator moves, with its update mode Fixed (Animate Physics). A collider that moves faster than <see cref="GreatestSpeed"/> has jumped, and has no velocity.</remarks>
        public bool VelocityFromMotion
        {
            get => velocityFromMotion;
            set => velocityFromMotion = value;
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

        /// <summary>The squash of the drawn ball after an impact, in the library's frame. The simulation does not depend on it, and a game that never reads it pays nothing.</summary>
        public BallStretch Squash => _runner == null ? default : (_squash ??= new BallSquash(_runner.Simulator)).At(_drawnTime);

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
            _squash?.Clear();
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

                // Create all new objects before replacing the old ones, so that a rejected value changes nothing.
                FootballScene scene = NewScene();
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
                _squash = null;
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
            return new FootballScene(preset, 0, 0f, default, null).Stage.Game;
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

                _scene.GreatestSpeed = greatestSpeed;
                if (velocityFromMotion && hits.value != 0)
                {
                    _motions.Follow(gameObject.scene.GetPhysicsScene(), hits.value, transform.position, Radius, Velocity.magnitude, greatestSpeed, Time.fixedDeltaTime);
                }

                PlaceColliders();
                for (int due = _clock.StepsIn(Time.fixedDeltaTime, _runner.TimeStep); due > 0; due--)
                {
                    MoveKeepersInSteps();
                    if (_runner.MoveBodies == null)
                    {
                        MoveKeepers();
                    }

                    _runner.Step();
                    _scene.Stage.AfterStep(_runner.State);
                    for (int i = 0; i < _runner.Events.Count; i++)
                    {
                        FootballEvent happened = _scene.Convert(in _runner.Events[i]);
                        _scene.Push(in happened);
                        _squash?.Follow(in _runner.Events[i]);
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

                Draw(_clock.FractionAt(Time.timeAsDouble - Time.fixedTimeAsDouble, _runner.TimeStep));
                _scene.Draw();
            }
        }

        private FootballScene NewScene()
        {
            TryGetComponent(out Rigidbody own);
            return new FootballScene(preset, hits.value, greatestSpeed, gameObject.scene.GetPhysicsScene(), own);
        }

        /// <summary>Sets the time at which the positions of Unity's colliders hold, on the clock of the ball: that of the game.</summary>
        private void PlaceColliders()
        {
            _scene.CollidersAreAt(_runner.State.Time + _clock.Left, velocityFromMotion ? _motions : null);
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
            _clock.Restart();
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
            _drawnTime = _runner.State.Time - ((1.0 - fraction) * _runner.TimeStep);
        }
    }
}
