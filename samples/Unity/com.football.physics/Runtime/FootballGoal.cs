using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>A goal: posts and a crossbar that stop the ball, a net that bulges, and events for goals. It opens towards its own back (−z), so a player who looks along z shoots at it.</summary>
    /// <remarks>Its position is the centre of the goal line on the ground. Its scale is ignored.</remarks>
    [AddComponentMenu("Football/Football Goal"), DisallowMultipleComponent, ExecuteAlways]
    public sealed class FootballGoal : FootballThing
    {
        [SerializeField, Range(0.5f, 20f), Tooltip("Width of the opening, m; 7.32 by Law 1, 3 in futsal.")]
        private float width = 7.32f;

        [SerializeField, Range(0.5f, 10f), Tooltip("Height of the opening, m; 2.44 by Law 1, 2 in futsal.")]
        private float height = 2.44f;

        [SerializeField, Range(0.01f, 0.2f), Tooltip("Radius of posts and bar, m; at most 0.06 by Law 1.")]
        private float postRadius = 0.06f;

        [SerializeField, Range(0.1f, 5f), Tooltip("Depth of the net at the height of the crossbar, m.")]
        private float depthAtBar = 0.8f;

        [SerializeField, Range(0.1f, 5f), Tooltip("Depth of the net on the ground, m.")]
        private float depthOnGround = 2f;

        [SerializeField, Tooltip("Add nets; without them the ball flies through.")]
        private bool hasNet = true;

        [SerializeField, Tooltip("Goal: the whole ball has crossed the line.")]
        private FootballUnityEvent scored = new FootballUnityEvent();

        [SerializeField, Tooltip("A ball hit the net.")]
        private FootballUnityEvent netMet = new FootballUnityEvent();

        [SerializeField, Tooltip("A ball hit a post or the crossbar.")]
        private FootballUnityEvent frameHit = new FootballUnityEvent();

        private NetMesh[] _nets = Array.Empty<NetMesh>();
        private Mesh[] _meshes = Array.Empty<Mesh>();

        /// <summary>A goal: the whole ball has crossed the line.</summary>
        public event Action<FootballGoal, FootballEvent> Scored;

        /// <summary>A ball hit the net.</summary>
        public event Action<FootballGoal, FootballEvent> NetMet;

        /// <summary>A ball hit a post or the crossbar.</summary>
        public event Action<FootballGoal, FootballEvent> FrameHit;

        /// <summary>Width of the opening, m.</summary>
        public float Width { get => width; set => width = value; }

        /// <summary>Height of the opening, m.</summary>
        public float Height { get => height; set => height = value; }

        /// <summary>Radius of posts and bar, m.</summary>
        public float PostRadius { get => postRadius; set => postRadius = value; }

        /// <summary>True if the goal has nets. Without nets, the ball flies through.</summary>
        public bool HasNet { get => hasNet; set => hasNet = value; }

        /// <summary>The number of goals since the scene started.</summary>
        public int Goals { get; private set; }

        internal override int Order => 1;

        /// <summary>Converts the goal to the library's type, in its frame.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The goal is not upright: its opening faces up or down.</exception>
        public Goal ToGoal()
        {
            Vector3d opening = UnityFrame.FromUnity(transform.rotation * new Vector3(0f, 0f, -1f)).Horizontal;
            if (opening.Length < 0.1)
            {
                throw new ArgumentOutOfRangeException(name, "The opening of the goal faces up or down. Rotate the goal so that it stands upright.");
            }

            return new Goal
            {
                Center = UnityFrame.FromUnity(transform.position),
                Facing = opening,
                Width = FootballPreset.Typed(width),
                Height = FootballPreset.Typed(height),
                PostRadius = FootballPreset.Typed(postRadius),
                DepthAtBar = FootballPreset.Typed(depthAtBar),
                DepthOnGround = FootballPreset.Typed(depthOnGround),
                HasNet = hasNet,
            };
        }

        internal override void AddTo(FootballScene scene)
        {
            scene.Add(this, ToGoal());
        }

        internal override int StampOfFields()
        {
            return HashCode.Combine(width, height, postRadius, depthAtBar, depthOnGround, hasNet);
        }

        internal override void Draw(FootballDrawing drawing)
        {
            Goal goal = ToGoal();
            foreach (Obstacle part in goal.Frame(ForceSet.Measured))
            {
                drawing.Add(part.Name, ShapeMesh.Of((CapsuleShape)part.Shape), Color.white);
            }

            var nets = new List<NetMesh>();
            var meshes = new List<Mesh>();
            foreach (Net net in goal.Nets())
            {
                var threads = new NetMesh(net);
                nets.Add(threads);
                meshes.Add(drawing.AddThreads(net.Name, threads, new Color(0.92f, 0.93f, 0.95f, 1f)));
            }

            _nets = nets.ToArray();
            _meshes = meshes.ToArray();
        }

        /// <summary>Draws the bulges of the nets.</summary>
        /// <param name="bulges">The bulges of the scene.</param>
        /// <param name="first">The index of this goal's first bulge.</param>
        internal void Follow(NetBulges bulges, int first)
        {
            for (int i = 0; i < _nets.Length; i++)
            {
                if (_nets[i].Follow(bulges[first + i]))
                {
                    FootballDrawing.Move(_meshes[i], _nets[i].Points);
                }
            }
        }

        internal void Raise(FootballEvent happened)
        {
            switch (happened.Kind)
            {
                case BallEventKind.Goal:
                    Goals++;
                    Scored?.Invoke(this, happened);
                    scored.Invoke(happened);
                    break;
                case BallEventKind.Net:
                    NetMet?.Invoke(this, happened);
                    netMet.Invoke(happened);
                    break;
                case BallEventKind.Impact:
                    FrameHit?.Invoke(this, happened);
                    frameHit.Invoke(happened);
                    break;
            }
        }
    }
}
