using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine
{
    public class Object
    {
        public static bool operator ==(Object? a, Object? b) => ReferenceEquals(a, b);

        public static bool operator !=(Object? a, Object? b) => !ReferenceEquals(a, b);
    }

    public class ScriptableObject : Object
    {
        public static T CreateInstance<T>()
            where T : ScriptableObject => Activator.CreateInstance<T>();
    }

    public class Transform : Object
    {
        public Vector3 position { get; set; }

        public Quaternion rotation { get; set; } = Quaternion.identity;

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; } = null!;

        public Transform transform => gameObject.transform;

        public T GetComponent<T>()
            where T : Component => gameObject.GetComponent<T>();
    }

    public class MonoBehaviour : Component
    {
    }

    /// <summary>Holds components, and calls their messages as the engine's player loop would.</summary>
    public sealed class GameObject : Object
    {
        private readonly List<Component> _components = new List<Component>();

        public Transform transform { get; } = new Transform();

        /// <summary>Adds a component without Awake, so that a test can set its fields as the inspector would.</summary>
        public T Attach<T>()
            where T : Component, new()
        {
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
            where T : Component
        {
            foreach (Component component in _components)
            {
                if (component is T found)
                {
                    return found;
                }
            }

            throw new InvalidOperationException("There is no " + typeof(T).Name + ".");
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
