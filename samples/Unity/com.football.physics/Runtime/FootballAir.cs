using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Adds the air of a football to a Rigidbody that Unity moves: drag, Magnus force, spin decay, wind and buoyancy.</summary>
    /// <remarks>
    /// Unity keeps moving the body, with its own bounces and its own gravity. The forces are accelerations of the preset's ball, whatever the mass of the body.
    /// The component sets the damping of the body to 0 and raises its maximum angular velocity, which is 7 rad/s in a new body.
    /// </remarks>
    [AddComponentMenu("Football/Football Air"), DisallowMultipleComponent, RequireComponent(typeof(Rigidbody))]
    public sealed class FootballAir : MonoBehaviour
    {
        /// <summary>The maximum angular velocity that the component sets, rad/s; higher than the spin of any kick.</summary>
        private const float FastestSpin = 200f;

        [SerializeField, Tooltip("Ball and air; empty: a match ball in still air at sea level. Its ground and time step do not count here.")]
        private FootballPreset preset;

        [SerializeField, Tooltip("True adds the buoyancy of the ball, 0.066 N upwards.")]
        private bool buoyancy = true;

        private Aerodynamics _air;
        private Rigidbody _body;
        private int _stamp;

        /// <summary>The preset. A change takes effect in the next physics step.</summary>
        public FootballPreset Preset
        {
            get => preset;
            set => preset = value;
        }

        /// <summary>True to add the buoyancy of the ball.</summary>
        public bool Buoyancy
        {
            get => buoyancy;
            set => buoyancy = value;
        }

        /// <summary>The velocity of the body in Unity, m/s.</summary>
        private Vector3 Velocity
        {
#if UNITY_6000_0_OR_NEWER
            get => _body.linearVelocity;
            set => _body.linearVelocity = value;
#else
            get => _body.velocity;
            set => _body.velocity = value;
#endif
        }

        /// <summary>The acceleration by gravity and buoyancy, m/s², in the library's frame.</summary>
        private Vector3d Pull => (_body.useGravity ? UnityFrame.FromUnity(Physics.gravity) : Vector3d.Zero) + Lift;

        private Vector3d Lift => buoyancy ? _air.Buoyancy / _air.Scene.Ball.Mass : Vector3d.Zero;

        /// <summary>Kicks the body: sets its velocity, m/s, and its spin, rad/s. It corrects the velocity for Unity's steps, so that the path matches the library's.</summary>
        public void Kick(Vector3 velocity, Vector3 spin)
        {
            Prepare();
            Vector3d kick = UnityFrame.FromUnity(velocity);
            Vector3d turn = UnityFrame.SpinFromUnity(spin);
            Velocity = UnityFrame.ToUnity(_air.KickVelocity(Place(), kick, turn, Time.fixedDeltaTime, Pull, Time.fixedTimeAsDouble));
            _body.angularVelocity = spin;
        }

        /// <summary>Kicks the body: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
        public void Kick(float speed, Vector3 direction, float topSpin = 0f, float sideSpin = 0f)
        {
            Vector3d forward = UnityFrame.FromUnity(direction);
            Kick(direction * (speed / direction.magnitude), UnityFrame.SpinToUnity(KickVectors.Spin(forward, topSpin, sideSpin)));
        }

        private void Awake()
        {
            Prepare();
        }

        private void FixedUpdate()
        {
            Prepare();
            if (_body.isKinematic || _body.IsSleeping())
            {
                return;
            }

            ForceAndTorque load = _air.EvaluateForStep(
                Place(), UnityFrame.FromUnity(Velocity), UnityFrame.SpinFromUnity(_body.angularVelocity), Time.fixedDeltaTime, Pull, Time.fixedTimeAsDouble);
            BallProperties ball = _air.Scene.Ball;
            _body.AddForce(UnityFrame.ToUnity((load.Force / ball.Mass) + Lift), ForceMode.Acceleration);
            _body.AddTorque(UnityFrame.SpinToUnity(load.Torque / ball.MomentOfInertia), ForceMode.Acceleration);
        }

        private Vector3d Place()
        {
            return UnityFrame.FromUnity(transform.position);
        }

        /// <summary>Applies a changed preset. If the preset is out of range, reports that once and keeps the previous one.</summary>
        private void Prepare()
        {
            if (_body == null)
            {
                TryGetComponent(out _body);
#if UNITY_6000_0_OR_NEWER
                _body.linearDamping = 0f;
                _body.angularDamping = 0f;
#else
                _body.drag = 0f;
                _body.angularDrag = 0f;
#endif
                _body.maxAngularVelocity = Mathf.Max(FastestSpin, _body.maxAngularVelocity);
            }

            int stamp = HashCode.Combine(preset, preset != null ? preset.Stamp : 0);
            if (_air != null && stamp == _stamp)
            {
                return;
            }

            _stamp = stamp;
            try
            {
                _air = new Aerodynamics(preset != null ? preset.MakeScene() : null);
            }
            catch (ArgumentOutOfRangeException rejected)
            {
                _air = _air ?? new Aerodynamics();
                Debug.LogError("The air of \"" + name + "\" stays as it was: " + rejected.Message, this);
            }
        }
    }
}
