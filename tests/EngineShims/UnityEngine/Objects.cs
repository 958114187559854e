using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    [Flags]
    public enum HideFlags
    {
        None = 0,
        HideInHierarchy = 1,
        DontSave = 52,
        HideAndDontSave = 61,
    }

    public enum FindObjectsSortMode
    {
        None,
        InstanceID,
    }

    public class Object
    {
        public string name { get; set; } = "";

        public HideFlags hideFlags { get; set; }

        /// <summary>True once it was destroyed: then it equals null, as in the engine.</summary>
        public bool IsDestroyed { get; internal set; }

        public static bool operator ==(Object? a, Object? b) => ReferenceEquals(a, b) || (a is null ? b!.IsDestroyed : b is null && a.IsDestroyed);

        public static bool operator !=(Object? a, Object? b) => !(a == b);

        public static implicit operator bool(Object? exists) => exists != null;

        public static void Destroy(Object obj) => DestroyImmediate(obj);

        public static void DestroyImmediate(Object obj)
        {
            switch (obj)
            {
                case GameObject thing:
                    thing.Die();
                    break;
                case Component component:
                    component.gameObject.Remove(component);
                    break;
            }

            obj.IsDestroyed = true;
        }

        public static T? FindObjectOfType<T>()
            where T : Component => FindObjectsOfType<T>().FirstOrDefault();

        public static T[] FindObjectsOfType<T>()
            where T : Component => GameObject.All.Where(item => item.activeInHierarchy).SelectMany(item => item.GetComponents<T>()).ToArray();

        public static T? FindAnyObjectByType<T>()
            where T : Component => FindObjectOfType<T>();

        /// <summary>Obsolete from Unity 6000.4 on, as is the sort mode.</summary>
        public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode)
            where T : Component => FindObjectsOfType<T>();

        /// <summary>From Unity 6000.4 on.</summary>
        public static T[] FindObjectsByType<T>()
            where T : Component => FindObjectsOfType<T>();
    }

    public class ScriptableObject : Object
    {
        public static T CreateInstance<T>()
            where T : ScriptableObject => Activator.CreateInstance<T>();
    }

    public class TextAsset : Object
    {
        public TextAsset(string text) => this.text = text;

        public string text { get; }
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; } = null!;

        public Transform transform => gameObject.transform;

        public T GetComponent<T>()
            where T : Component => gameObject.GetComponent<T>();

        public T? GetComponentInChildren<T>()
            where T : Component => gameObject.GetComponentInChildren<T>();

        public bool TryGetComponent<T>([NotNullWhen(true)] out T? component)
            where T : Component => gameObject.TryGetComponent(out component);
    }

    public class Behaviour : Component
    {
        private bool _enabled = true;

        public bool enabled
        {
            get => _enabled;
            set
            {
                if (_enabled != value)
                {
                    _enabled = value;
                    gameObject.Tell(this, value ? "OnEnable" : "OnDisable");
                }
            }
        }
    }

    public class MonoBehaviour : Behaviour
    {
    }

    public class Transform : Component
    {
        private readonly List<Transform> _children = new List<Transform>();

        public Transform? parent { get; private set; }

        public Vector3 position { get; set; }

        public Quaternion rotation { get; set; } = Quaternion.identity;

        public Vector3 localScale { get; set; } = new Vector3(1f, 1f, 1f);

        public Vector3 lossyScale => localScale;

        public Vector3 forward => rotation * Vector3.forward;

        public int childCount => _children.Count;

        public Transform GetChild(int index) => _children[index];

        /// <summary>In the shim the child stays where it is in the world.</summary>
        public void SetParent(Transform? parent)
        {
            this.parent?._children.Remove(this);
            this.parent = parent;
            parent?._children.Add(this);
        }

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public void LookAt(Vector3 worldPosition)
        {
        }
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
        private readonly HashSet<Component> _awake = new HashSet<Component>();
        private bool _active = true;

        public GameObject()
            : this("")
        {
        }

        public GameObject(string name)
        {
            this.name = name;
            transform = new Transform { gameObject = this };
            All.Add(this);
        }

        /// <summary>All that were made and not destroyed.</summary>
        public static List<GameObject> All { get; } = new List<GameObject>();

        public Transform transform { get; }

        public int layer { get; set; }

        public bool activeInHierarchy => _active;

        public SceneManagement.Scene scene { get; internal set; }

        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var made = new GameObject(type.ToString());
            made.Attach<Collider>();
            return made;
        }

        /// <summary>Destroys all there are: a test begins, or ends, with nothing.</summary>
        public static void DestroyAll()
        {
            foreach (GameObject item in All.ToArray())
            {
                if (!item.IsDestroyed)
                {
                    DestroyImmediate(item);
                }
            }
        }

        /// <summary>A fixed update, or a frame, of all there are.</summary>
        public static void SendAll(string message)
        {
            foreach (GameObject item in All.ToArray())
            {
                item.Send(message);
            }
        }

        /// <summary>Adds a component without Awake, so that a test can set its fields as the inspector would.</summary>
        public T Attach<T>()
            where T : Component, new() => (T)Attach(typeof(T));

        /// <summary>Adds a component without Awake.</summary>
        public Component Attach(Type type)
        {
            foreach (Type required in type.GetCustomAttributes<RequireComponent>(true).SelectMany(attribute => attribute.All))
            {
                if (!_components.Exists(item => required.IsInstanceOfType(item)))
                {
                    Attach(required);
                }
            }

            var component = (Component)Activator.CreateInstance(type)!;
            component.gameObject = this;
            component.name = name;
            _components.Add(component);
            return component;
        }

        public T AddComponent<T>()
            where T : Component, new()
        {
            T component = Attach<T>();
            WakeUp();
            return component;
        }

        /// <summary>Awake, OnEnable and Start of all that had none yet.</summary>
        public void WakeUp()
        {
            foreach (string message in new[] { "Awake", "OnEnable", "Start" })
            {
                foreach (Component component in _components.ToArray())
                {
                    if (!_awake.Contains(component))
                    {
                        Tell(component, message);
                    }
                }
            }

            _awake.UnionWith(_components);
        }

        public void SetActive(bool value)
        {
            if (value != _active)
            {
                _active = value;
                foreach (Component component in _components.ToArray())
                {
                    Tell(component, value ? "OnEnable" : "OnDisable");
                }
            }
        }

        public T GetComponent<T>()
            where T : Component => TryGetComponent(out T? found) ? found : throw new InvalidOperationException("There is no " + typeof(T).Name + ".");

        public T[] GetComponents<T>()
            where T : Component => _components.OfType<T>().ToArray();

        public T? GetComponentInChildren<T>()
            where T : Component
        {
            if (TryGetComponent(out T? found))
            {
                return found;
            }

            for (int i = 0; i < transform.childCount && found is null; i++)
            {
                found = transform.GetChild(i).gameObject.GetComponentInChildren<T>();
            }

            return found;
        }

        public bool TryGetComponent<T>([NotNullWhen(true)] out T? component)
            where T : Component
        {
            component = null;
            for (int i = 0; i < _components.Count && component is null; i++)
            {
                component = _components[i] as T;
            }

            return !ReferenceEquals(component, null);
        }

        /// <summary>Sends a message to all components, private methods included.</summary>
        public void Send(string message)
        {
            if (message == "Awake")
            {
                _awake.UnionWith(_components);
            }

            foreach (Component component in _components.ToArray())
            {
                Tell(component, message);
            }
        }

        internal void Tell(Component component, string message)
        {
            if (component is Behaviour { enabled: false } && message != "OnDisable" && message != "OnEnable")
            {
                return;
            }

            MethodInfo? method = component.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null, Type.EmptyTypes, null);
            ((Action?)method?.CreateDelegate(typeof(Action), component))?.Invoke();
        }

        internal void Remove(Component component)
        {
            Tell(component, "OnDisable");
            Tell(component, "OnDestroy");
            _components.Remove(component);
        }

        internal void Die()
        {
            All.Remove(this);
            foreach (Component component in _components.ToArray())
            {
                if (_active && _awake.Contains(component))
                {
                    Tell(component, "OnDisable");
                    Tell(component, "OnDestroy");
                }

                component.IsDestroyed = true;
            }

            for (int i = transform.childCount - 1; i >= 0; i--)
            {
                DestroyImmediate(transform.GetChild(i).gameObject);
            }

            transform.SetParent(null);
        }
    }
}

namespace UnityEngine.SceneManagement
{
    /// <summary>In the shim a number: 0 for the scene that is loaded first.</summary>
    public struct Scene
    {
        public int handle { get; set; }

        public bool IsValid() => true;
    }

    public static class SceneManager
    {
        public static void MoveGameObjectToScene(GameObject go, Scene scene) => go.scene = scene;
    }
}
