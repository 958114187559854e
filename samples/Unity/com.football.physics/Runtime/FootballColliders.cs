using FootballPhysics.Engines;
using System;
using System.Collections.Generic;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>
    /// Unity's colliders as colliders of the ball, found by the sphere casts of a physics scene. Spheres, capsules, boxes and character controllers have their exact shapes. Any other
    /// shape (meshes, terrain) acts as its tangent plane at the point that the ball would touch. Triggers are ignored.
    /// </summary>
    /// <remarks>
    /// The scale of a collider, and the surface of its game object, are read when the ball first hits it. The velocity is that of the Rigidbody of the collider or of its parents, or of the
    /// CharacterController. A collider without either does not move, unless the ball takes velocities from motion.
    /// </remarks>
    public sealed class FootballColliders : IEngineColliders
    {
        /// <summary>The reduction of the ball's radius for casts against meshes, so that the surface below the ball does not block the cast.</summary>
        private const float Skin = 0.99f;

        private readonly Dictionary<Collider, EngineCollider> _known = new Dictionary<Collider, EngineCollider>();
        private readonly Dictionary<EngineCollider, Collider> _engines = new Dictionary<EngineCollider, Collider>();
        private readonly List<EngineCollider> _released = new List<EngineCollider>();
        private readonly PhysicsScene _physics;
        private readonly Rigidbody _own;
        private readonly bool _pushes;
        private readonly int _layers;
        private RaycastHit[] _hits = new RaycastHit[16];
        private RaycastHit[] _exact = new RaycastHit[16];
        private Collider[] _near = new Collider[16];

        /// <summary>Creates the colliders for a ball.</summary>
        /// <param name="physics">The physics scene: gameObject.scene.GetPhysicsScene(), or Physics.defaultPhysicsScene.</param>
        /// <param name="own">The ball's own body, which the ball does not hit.</param>
        /// <param name="layers">The layers that the ball hits, as a LayerMask.</param>
        /// <param name="greatestSpeed">An upper bound of the speed of any point of the colliders, m/s, including rotation.</param>
        /// <param name="pushes">True if dynamic bodies react with their mass. The event contains the impulse, which the game applies.</param>
        public FootballColliders(PhysicsScene physics, Rigidbody own, int layers, float greatestSpeed, bool pushes = false)
        {
            _physics = physics;
            _pushes = pushes;
            _own = own;
            _layers = layers;
            MaximumSpeed = greatestSpeed;
        }

        /// <summary>The time at which the positions of Unity's colliders hold, on the ball's clock, s. Set it before every step.</summary>
        public double Time { get; set; }

        /// <summary>An upper bound of the speed of any point of the colliders, m/s, including rotation.</summary>
        public double MaximumSpeed { get; set; }

        /// <summary>The velocities of colliders without a Rigidbody; null if these do not move.</summary>
        internal ColliderMotions Motions { get; set; }

        /// <summary>Returns Unity's collider of a library collider; null if there is none.</summary>
        public Collider Of(EngineCollider collider)
        {
            return collider != null && _engines.TryGetValue(collider, out Collider met) ? met : null;
        }

        /// <summary>Adds the colliders that a sphere touches on its path. It allocates only for new colliders.</summary>
        public void Cast(in SphereCast cast, EngineHits hits)
        {
            Vector3 from = UnityFrame.ToUnity(cast.From);
            Vector3 direction = UnityFrame.ToUnity(cast.Direction);
            var radius = (float)cast.Radius;
            var distance = (float)cast.Distance;

            // First add the colliders that overlap the sphere at the start, then those on its path.
            int near = _physics.OverlapSphere(from, radius, _near, _layers, QueryTriggerInteraction.Ignore);
            while (near == _near.Length)
            {
                Array.Resize(ref _near, 2 * near);
                near = _physics.OverlapSphere(from, radius, _near, _layers, QueryTriggerInteraction.Ignore);
            }

            for (int i = 0; i < near; i++)
            {
                Add(_near[i], in cast, hits);
            }

            if (distance > 0f)
            {
                int count = CastSphere(from, radius, direction, distance, ref _hits);
                for (int i = 0; i < count; i++)
                {
                    Add(_hits[i].collider, in cast, hits);
                }
            }
        }

        private void Add(Collider collider, in SphereCast cast, EngineHits hits)
        {
            if (collider.attachedRigidbody == _own && _own != null)
            {
                return;
            }

            // A body that became kinematic or dynamic, or changed its mass, needs a new collider.
            Rigidbody body = collider.attachedRigidbody;
            double mass = _pushes && body != null && !body.isKinematic ? body.mass : double.PositiveInfinity;
            if (!_known.TryGetValue(collider, out EngineCollider known) || known.Mass != mass)
            {
                Release(collider);
                known = ColliderShapes.Make(collider, mass);
                _known.Add(collider, known);
                _engines.Add(known, collider);
            }

            Pose pose = ColliderShapes.PoseOf(collider);
            if (ColliderShapes.HasShape(collider))
            {
                Vector3 velocity = VelocityAt(pose.position, collider, body, in pose, out Vector3 spin);
                known.MoveTo(UnityFrame.FromUnity(pose.position), UnityFrame.FromUnity(pose.rotation), UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin));
                hits.Add(known);
            }
            else if (TryTouch(collider, in cast, out Vector3 point, out Vector3 normal))
            {
                Vector3 velocity = VelocityAt(point, collider, body, in pose, out _);
                known.TouchAt(UnityFrame.FromUnity(point), UnityFrame.FromUnity(normal), UnityFrame.FromUnity(velocity));
                hits.Add(known);
            }
        }

        /// <summary>Returns the velocity of a point of a collider, m/s, and its angular velocity, rad/s.</summary>
        private Vector3 VelocityAt(Vector3 point, Collider collider, Rigidbody body, in Pose pose, out Vector3 spin)
        {
            spin = Vector3.zero;
            if (body != null)
            {
                spin = body.angularVelocity;
                return body.GetPointVelocity(point);
            }

            if (collider is CharacterController controller)
            {
                return controller.velocity;
            }

            Vector3 velocity = Vector3.zero;
            Motions?.Of(collider, out velocity, out spin);
            return velocity + Vector3.Cross(spin, point - pose.position);
        }

        /// <summary>Forgets a collider, and those that were destroyed.</summary>
        private void Release(Collider replaced)
        {
            foreach (KeyValuePair<EngineCollider, Collider> met in _engines)
            {
                if (met.Value == null || met.Value == replaced)
                {
                    _released.Add(met.Key);
                }
            }

            foreach (EngineCollider released in _released)
            {
                _known.Remove(_engines[released]);
                _engines.Remove(released);
            }

            _released.Clear();
        }

        /// <summary>Finds the contact of the ball with a mesh: the current one, or the first one on its path.</summary>
        private bool TryTouch(Collider collider, in SphereCast cast, out Vector3 point, out Vector3 normal)
        {
            Vector3 from = UnityFrame.ToUnity(cast.From);
            Vector3 direction = UnityFrame.ToUnity(cast.Direction);
            var reach = (float)cast.Radius;
            bool found = Nearest(collider, from, reach, direction, out point, out normal);
            var ball = (float)cast.BallRadius;
            if (found && Vector3.Dot(from - point, normal) <= ball * 1.01f)
            {
                return true;
            }

            float nearest = float.PositiveInfinity;
            int count = cast.Distance > 0 ? CastSphere(from, ball * Skin, direction, (float)cast.Distance + reach, ref _exact) : 0;
            for (int i = 0; i < count; i++)
            {
                if (_exact[i].collider == collider && _exact[i].distance > 0f && _exact[i].distance < nearest)
                {
                    nearest = _exact[i].distance;
                    point = _exact[i].point;
                    normal = _exact[i].normal;
                    found = true;
                }
            }

            return found;
        }

        /// <summary>Finds the plane closest to the ball's centre, among those hit by rays ahead and down.</summary>
        private static bool Nearest(Collider collider, Vector3 from, float reach, Vector3 direction, out Vector3 point, out Vector3 normal)
        {
            point = Vector3.zero;
            normal = Vector3.zero;
            float least = float.PositiveInfinity;
            for (int i = 0; i < 2; i++)
            {
                if (collider.Raycast(new Ray(from, i == 0 ? new Vector3(0f, -1f, 0f) : direction), out RaycastHit hit, 2f * reach))
                {
                    float above = Vector3.Dot(from - hit.point, hit.normal);
                    if (above < least)
                    {
                        least = above;
                        point = hit.point;
                        normal = hit.normal;
                    }
                }
            }

            return least < float.PositiveInfinity;
        }

        private int CastSphere(Vector3 from, float radius, Vector3 direction, float distance, ref RaycastHit[] hits)
        {
            int count = _physics.SphereCast(from, radius, direction, hits, distance, _layers, QueryTriggerInteraction.Ignore);
            while (count == hits.Length)
            {
                Array.Resize(ref hits, 2 * count);
                count = _physics.SphereCast(from, radius, direction, hits, distance, _layers, QueryTriggerInteraction.Ignore);
            }

            return count;
        }
    }
}
