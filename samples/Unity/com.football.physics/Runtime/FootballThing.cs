using System;
using System.Collections.Generic;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>An object that every football in the scene can hit while it is enabled: a goal, pitch, wall or keeper. It is drawn as it collides.</summary>
    /// <remarks>A change of a field or of the transform takes effect in the next step, and recompiles the scene of every ball.</remarks>
    [ExecuteAlways]
    public abstract class FootballThing : MonoBehaviour
    {
        private static readonly List<FootballThing> s_all = new List<FootballThing>();

        [SerializeField, Tooltip("Material for drawing; empty: the default of the render pipeline.")]
        private Material material;

        private FootballDrawing _drawing;
        private int _drawn;

        /// <summary>The material for drawing; null: the default of the render pipeline. A change takes effect when the component is enabled.</summary>
        public Material Material { get => material; set => material = value; }

        /// <summary>A hash that changes when any enabled object changes.</summary>
        internal static int StampOfAll
        {
            get
            {
                var stamp = new HashCode();
                for (int i = 0; i < s_all.Count; i++)
                {
                    stamp.Add(s_all[i].Stamp);
                }

                return stamp.ToHashCode();
            }
        }

        /// <summary>The order in which the objects are added: pitches, goals, walls, keepers.</summary>
        internal abstract int Order { get; }

        /// <summary>A hash that changes when the object changes.</summary>
        internal int Stamp => HashCode.Combine(Order, transform.position, transform.rotation, StampOfFields());

        /// <summary>Returns all enabled objects, in the same order on every machine.</summary>
        internal static List<FootballThing> InOrder()
        {
            var things = new List<FootballThing>(s_all);
            things.Sort(Compare);
            return things;
        }

        /// <summary>Adds the object to the scene of a ball.</summary>
        internal abstract void AddTo(FootballScene scene);

        /// <summary>Draws the colliders of the object.</summary>
        internal abstract void Draw(FootballDrawing drawing);

        /// <summary>Returns a hash that changes when any field of the object changes.</summary>
        internal abstract int StampOfFields();

        /// <summary>Converts a position in the object's local frame, without scale, to the library's frame.</summary>
        internal Vector3d Place(Vector3 local)
        {
            return UnityFrame.FromUnity(transform.position + (transform.rotation * local));
        }

        /// <summary>Draws the object in the game, or in the editor.</summary>
        protected virtual void OnEnable()
        {
            s_all.Add(this);
            Redraw();
        }

        /// <summary>Removes the object from the scene.</summary>
        protected virtual void OnDisable()
        {
            s_all.Remove(this);
            _drawing?.Clear();
            _drawing = null;
        }

        /// <summary>Updates the drawing after a change.</summary>
        protected virtual void Update()
        {
            if (Stamp != _drawn)
            {
                Redraw();
            }
        }

        private static int Compare(FootballThing a, FootballThing b)
        {
            int order = a.Order.CompareTo(b.Order);
            Vector3 p = a.transform.position;
            Vector3 q = b.transform.position;
            order = order != 0 ? order : p.x.CompareTo(q.x);
            order = order != 0 ? order : p.z.CompareTo(q.z);
            return order != 0 ? order : p.y.CompareTo(q.y);
        }

        private void Redraw()
        {
            _drawn = Stamp;
            _drawing = _drawing ?? new FootballDrawing(gameObject, material);
            _drawing.Clear();
            try
            {
                Draw(_drawing);
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                Debug.LogError(name + ": " + refusal.Message, this);
            }
        }
    }
}
