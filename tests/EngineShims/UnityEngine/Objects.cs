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
