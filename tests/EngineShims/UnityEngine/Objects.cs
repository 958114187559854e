using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Reflection;

namespace UnityEngine
{
    public class Object
    {
        public string name { get; set; } = "";

        public static bool operator ==(Object? a, Object? b) => ReferenceEquals(a, b);

        public static bool operator !=(Object? a, Object? b) => !ReferenceEquals(a, b);
    }

    public class ScriptableObject : Object
    {
        public static T CreateInstance<T>()
            where T : ScriptableObject => Activator.CreateInstance<T>();
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; } = null!;

        public Transform transform => gameObject.transform;

        public T GetComponent<T>()
            where T : Component => gameObject.GetComponent<T>();

        public bool TryGetComponent<T>([NotNullWhen(true)] out T? component)
            where T : Component => gameObject.TryGetComponent(out component);
    }

    public class Transform : Component
    {
        public Vector3 position { get; set; }

        public Quaternion rotation { get; set; } = Quaternion.identity;

        public Vector3 localScale { get; set; } = new Vector3(1f, 1f, 1f);

        public Vector3 lossyScale => localScale;

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }
    }

    public class MonoBehaviour : Component
    {
    }

    public class Collider : Component
    {
        public bool isTrigger { get; set; }

        public Rigidbody? attachedRigidbody => TryGetComponent(out Rigidbody? body) ? body : null;

        /// <summary>Distance of a point in the frame of the transform, without its scale.</summary>
        public virtual float Distance(Vector3 point) => float.PositiveInfinity;

        public bool Raycast(Ray ray, out RaycastHit hit, float maxDistance) => Physics.March(this, ray.origin, 0f, ray.direction, maxDistance, out hit);
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

    public class Rigidbody : Component
    {
        public bool isKinematic { get; set; }

        public bool useGravity { get; set; } = true;

        public Vector3 velocity { get; set; }

        public Vector3 angularVelocity { get; set; }

        public Vector3 GetPointVelocity(Vector3 point)
        {
            Vector3 r = point - transform.position;
            Vector3 w = angularVelocity;
            return velocity + new Vector3((w.y * r.z) - (w.z * r.y), (w.z * r.x) - (w.x * r.z), (w.x * r.y) - (w.y * r.x));
        }

        public RigidbodyInterpolation interpolation { get; set; }
    }

    public enum PrimitiveType
    {
        Sphere,
        Capsule,
        Cylinder,
        Cube,
        Plane,
        Quad,
    }

    /// <summary>Holds components, and calls their messages as the engine's player loop would.</summary>
    public sealed class GameObject : Object
    {
        private readonly List<Component> _components = new List<Component>();

        public Transform transform { get; } = new Transform();

        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var made = new GameObject { name = type.ToString() };
            made.Attach<Collider>();
            return made;
        }

        /// <summary>Adds a component without Awake, so that a test can set its fields as the inspector would.</summary>
        public T Attach<T>()
            where T : Component, new()
        {
            foreach (RequireComponent required in typeof(T).GetCustomAttributes<RequireComponent>())
            {
                var needed = (Component)Activator.CreateInstance(required.m_Type0)!;
                needed.gameObject = this;
                _components.Add(needed);
            }

            var component = new T { gameObject = this };
            _components.Add(component);
            return component;
        }

        public T AddComponent<T>()
            where T : Component, new()
        {
            T component = Attach<T>();
            Call(component, "Awake");
            Call(component, "Start");
            return component;
        }

        public T GetComponent<T>()
            where T : Component => TryGetComponent(out T? found) ? found : throw new InvalidOperationException("There is no " + typeof(T).Name + ".");

        public bool TryGetComponent<T>([NotNullWhen(true)] out T? component)
            where T : Component
        {
            component = _components.Find(item => item is T) as T;
            return !ReferenceEquals(component, null);
        }

        /// <summary>Sends a message to all components, private methods included.</summary>
        public void Send(string message)
        {
            foreach (Component component in _components.ToArray())
            {
                Call(component, message);
            }
        }

        private static void Call(Component component, string message)
        {
            MethodInfo? method = component.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
            ((Action?)method?.CreateDelegate(typeof(Action), component))?.Invoke();
        }
    }
}
