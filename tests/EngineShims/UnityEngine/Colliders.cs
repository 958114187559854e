using System;

namespace UnityEngine
{
    public class Collider : Component
    {
        public bool isTrigger { get; set; }

        /// <summary>The body of its own object, or of the nearest parent that has one.</summary>
        public Rigidbody? attachedRigidbody
        {
            get
            {
                for (Transform? at = transform; at != null; at = at.parent)
                {
                    if (at.gameObject.TryGetComponent(out Rigidbody? body))
                    {
                        return body;
                    }
                }

                return null;
            }
        }

        /// <summary>Distance of a point in the frame of the transform, without its scale.</summary>
        public virtual float Distance(Vector3 point) => float.PositiveInfinity;

        /// <summary>Finds nothing from inside, as in the engine.</summary>
        public bool Raycast(Ray ray, out RaycastHit hit, float maxDistance)
        {
            hit = default;
            return Physics.Distance(this, ray.origin) > 0f && Physics.March(this, ray.origin, 0f, ray.direction, maxDistance, out hit);
        }
    }

    public class SphereCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        public override float Distance(Vector3 point) => (point - center).magnitude - radius;
    }

    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; }

        public Vector3 size { get; set; } = new Vector3(1f, 1f, 1f);

        public override float Distance(Vector3 point)
        {
            Vector3 p = point - center;
            var q = new Vector3(Math.Abs(p.x) - (0.5f * size.x), Math.Abs(p.y) - (0.5f * size.y), Math.Abs(p.z) - (0.5f * size.z));
            var outside = new Vector3(Math.Max(q.x, 0f), Math.Max(q.y, 0f), Math.Max(q.z, 0f));
            return outside.magnitude + Math.Min(0f, Math.Max(q.x, Math.Max(q.y, q.z)));
        }
    }

    public class CapsuleCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        public float height { get; set; } = 2f;

        public int direction { get; set; } = 1;

        public override float Distance(Vector3 point)
        {
            Vector3 p = point - center;
            float half = Math.Max(0f, (0.5f * height) - radius);
            float along = direction == 0 ? p.x : direction == 1 ? p.y : p.z;
            float on = Math.Min(half, Math.Max(-half, along));
            var nearest = new Vector3(direction == 0 ? on : 0f, direction == 1 ? on : 0f, direction == 2 ? on : 0f);
            return (p - nearest).magnitude - radius;
        }
    }

    /// <summary>A capsule that stands upright however its transform is turned, with a velocity of its own.</summary>
    public class CharacterController : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        public float height { get; set; } = 2f;

        /// <summary>The velocity of its last move.</summary>
        public Vector3 velocity { get; set; }

        public override float Distance(Vector3 point)
        {
            Vector3 p = (transform.rotation * point) - (transform.rotation * center);
            float half = Math.Max(0f, (0.5f * height) - radius);
            return (p - new Vector3(0f, Math.Min(half, Math.Max(-half, p.y)), 0f)).magnitude - radius;
        }
    }

    /// <summary>In the shim a mesh is a half-space, bounded by the xz plane of its transform.</summary>
    public class MeshCollider : Collider
    {
        public override float Distance(Vector3 point) => point.y;
    }

    public enum RigidbodyInterpolation
    {
        None,
        Interpolate,
        Extrapolate,
    }

    public enum ForceMode
    {
        Force = 0,
        Impulse = 1,
        VelocityChange = 2,
        Acceleration = 5,
    }

    public class Rigidbody : Component
    {
        public bool isKinematic { get; set; }

        public bool useGravity { get; set; } = true;

        public float mass { get; set; } = 1f;

        private Vector3 _push;
        private Vector3 _turn;

        public Vector3 velocity { get; set; }

        /// <summary>The name of the velocity from Unity 6 on.</summary>
        public Vector3 linearVelocity { get => velocity; set => velocity = value; }

        public Vector3 angularVelocity { get; set; }

        public float drag { get; set; }

        public float angularDrag { get; set; } = 0.05f;

        public float linearDamping { get => drag; set => drag = value; }

        public float angularDamping { get => angularDrag; set => angularDrag = value; }

        public float maxAngularVelocity { get; set; } = 7f;

        /// <summary>What <see cref="IsSleeping"/> returns.</summary>
        public bool Sleeps { get; set; }

        public bool IsSleeping() => Sleeps;

        /// <summary>In the shim accelerations alone.</summary>
        public void AddForce(Vector3 force, ForceMode mode) => _push += Accelerating(force, mode);

        /// <summary>In the shim accelerations alone.</summary>
        public void AddTorque(Vector3 torque, ForceMode mode) => _turn += Accelerating(torque, mode);

        /// <summary>A step of the engine without contacts: semi-implicit Euler, as PhysX does it.</summary>
        public void Simulate(float step)
        {
            velocity = (velocity + ((_push + (useGravity ? Physics.gravity : Vector3.zero)) * step)) * Math.Max(0f, 1f - (step * drag));
            angularVelocity = (angularVelocity + (_turn * step)) * Math.Max(0f, 1f - (step * angularDrag));
            float rate = angularVelocity.magnitude;
            angularVelocity *= rate > maxAngularVelocity ? maxAngularVelocity / rate : 1f;
            transform.position += velocity * step;
            _push = Vector3.zero;
            _turn = Vector3.zero;
        }

        private static Vector3 Accelerating(Vector3 value, ForceMode mode) =>
            mode == ForceMode.Acceleration ? value : throw new NotSupportedException("The shim adds accelerations alone.");

        public RigidbodyInterpolation interpolation { get; set; }

        /// <summary>In the frame of the transform.</summary>
        public Vector3 centerOfMass { get; set; }

        public Vector3 worldCenterOfMass => transform.position + (transform.rotation * centerOfMass);

        /// <summary>The velocity of a point: that of the centre of mass, and the rotation about it.</summary>
        public Vector3 GetPointVelocity(Vector3 point)
        {
            Vector3 r = point - worldCenterOfMass;
            Vector3 w = angularVelocity;
            return velocity + new Vector3((w.y * r.z) - (w.z * r.y), (w.z * r.x) - (w.x * r.z), (w.x * r.y) - (w.y * r.x));
        }

        /// <summary>In the shim an impulse changes the velocity at once, and turns nothing.</summary>
        public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode)
        {
            if (mode != ForceMode.Impulse)
            {
                throw new NotSupportedException("The shim knows impulses alone.");
            }

            velocity += force * (1f / mass);
        }
    }
}
