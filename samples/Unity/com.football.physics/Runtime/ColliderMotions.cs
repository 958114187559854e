using System;
using System.Collections.Generic;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The velocities of colliders without a Rigidbody that a script or an animation moves, from their poses in the last two fixed frames.</summary>
    /// <remarks>
    /// It follows the colliders near the ball. A collider that was not near in the last frame has no velocity yet, and neither has one that jumped faster than the maximum speed. Move the
    /// colliders in the fixed frames (an Animator with the update mode Fixed or Animate Physics): otherwise, the positions in two frames do not show their speed.
    /// </remarks>
    internal sealed class ColliderMotions
    {
        /// <summary>The time in which the ball and a collider may approach each other before they meet, in fixed frames.</summary>
        private const float FramesAhead = 3f;

        private readonly Dictionary<Collider, Motion> _motions = new Dictionary<Collider, Motion>();
        private readonly List<Collider> _gone = new List<Collider>();
        private Collider[] _near = new Collider[16];
        private long _frame;

        /// <summary>Reads the poses of the colliders near a ball at the start of a fixed frame.</summary>
        /// <param name="physics">The physics scene.</param>
        /// <param name="layers">The layers that the ball hits.</param>
        /// <param name="center">The ball's centre.</param>
        /// <param name="radius">Its radius, m.</param>
        /// <param name="ballSpeed">Its speed, m/s.</param>
        /// <param name="greatestSpeed">The maximum speed of colliders, m/s.</param>
        /// <param name="frame">The length of a fixed frame, s.</param>
        public void Follow(PhysicsScene physics, int layers, Vector3 center, float radius, float ballSpeed, float greatestSpeed, float frame)
        {
            _frame++;
            float reach = radius + (FramesAhead * frame * (ballSpeed + greatestSpeed));
            int count = physics.OverlapSphere(center, reach, _near, layers, QueryTriggerInteraction.Ignore);
            while (count == _near.Length)
            {
                Array.Resize(ref _near, 2 * count);
                count = physics.OverlapSphere(center, reach, _near, layers, QueryTriggerInteraction.Ignore);
            }

            for (int i = 0; i < count; i++)
            {
                if (_near[i].attachedRigidbody == null && !(_near[i] is CharacterController))
                {
                    Read(_near[i], greatestSpeed, frame);
                }
            }

            Forget();
        }

        /// <summary>Returns the velocity of the origin of a collider, m/s, and its angular velocity, rad/s; zero if they are not known.</summary>
        public void Of(Collider collider, out Vector3 velocity, out Vector3 spin)
        {
            Motion known = _motions.TryGetValue(collider, out Motion found) ? found : default;
            velocity = known.Velocity;
            spin = known.Spin;
        }

        private void Read(Collider collider, float greatestSpeed, float frame)
        {
            Pose pose = ColliderShapes.PoseOf(collider);
            var next = new Motion { Pose = pose, Frame = _frame };
            if (_motions.TryGetValue(collider, out Motion before) && before.Frame == _frame - 1)
            {
                Vector3 velocity = (pose.position - before.Pose.position) * (1f / frame);
                if (velocity.magnitude <= greatestSpeed)
                {
                    next.Velocity = velocity;
                    next.Spin = SpinTo(before.Pose.rotation, pose.rotation, frame);
                }
            }

            _motions[collider] = next;
        }

        /// <summary>Returns the angular velocity that turns one rotation into another in a time, rad/s.</summary>
        private static Vector3 SpinTo(Quaternion from, Quaternion to, float time)
        {
            Vector3d spin = UnityFrame.FromUnity(from).SpinTo(UnityFrame.FromUnity(to), time);
            return UnityFrame.SpinToUnity(spin);
        }

        /// <summary>Removes colliders that are no longer near, or were destroyed.</summary>
        private void Forget()
        {
            foreach (KeyValuePair<Collider, Motion> known in _motions)
            {
                if (known.Value.Frame < _frame)
                {
                    _gone.Add(known.Key);
                }
            }

            foreach (Collider gone in _gone)
            {
                _motions.Remove(gone);
            }

            _gone.Clear();
        }

        private struct Motion
        {
            public Pose Pose;
            public Vector3 Velocity;
            public Vector3 Spin;
            public long Frame;
        }
    }
}
