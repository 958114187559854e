using System;
using FootballPhysics.Engines;
using FootballPhysics.Prediction;
using FootballPhysics.Shapes;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>A goalkeeper at the position of this object, who dives for shots at the nearest goal. The dive comes from the library's Interception.FindSave.</summary>
    [AddComponentMenu("Football/Football Keeper"), DisallowMultipleComponent, ExecuteAlways]
    public sealed class FootballKeeper : FootballThing
    {
        [SerializeField, Tooltip("Goal to guard; empty: the nearest one.")]
        private FootballGoal goal;

        [SerializeField, Range(0f, 2f), Tooltip("Reaction time, s.")]
        private float reaction = 0.2f;

        [SerializeField, Range(0.5f, 30f), Tooltip("Acceleration, m/s².")]
        private float acceleration = 8f;

        [SerializeField, Range(0.5f, 15f), Tooltip("Top speed, m/s.")]
        private float speed = 5f;

        [SerializeField, Range(0f, 4f), Tooltip("Reach of a dive, m.")]
        private float reach = 1.9f;

        [SerializeField, Range(0.5f, 4f), Tooltip("Reach upwards, m.")]
        private float highest = 2.6f;

        [SerializeField, Tooltip("Colour of his shirt.")]
        private Color shirt = new Color(0.95f, 0.76f, 0.19f, 1f);

        private Transform _figure;

        /// <summary>The goal to guard; null: the nearest one.</summary>
        public FootballGoal Goal { get => goal; set => goal = value; }

        /// <summary>Reaction time, s.</summary>
        public float Reaction { get => reaction; set => reaction = value; }

        /// <summary>Top speed, m/s.</summary>
        public float Speed { get => speed; set => speed = value; }

        /// <summary>Reach of a dive, m.</summary>
        public float Reach { get => reach; set => reach = value; }

        /// <summary>The number of shots that he dived for, for the ball that was stepped last.</summary>
        public int Dives { get; private set; }

        internal override int Order => 3;

        internal override void AddTo(FootballScene scene)
        {
            scene.Add(this, goal, Place(Vector3.zero), new Player
            {
                Reaction = FootballPreset.Typed(reaction),
                Acceleration = FootballPreset.Typed(acceleration),
                Speed = FootballPreset.Typed(speed),
                Reach = FootballPreset.Typed(reach),
                MaximumHeight = FootballPreset.Typed(highest),
            });
        }

        internal override int StampOfFields()
        {
            return HashCode.Combine(HashCode.Combine(goal, shirt), reaction, acceleration, speed, reach, highest);
        }

        internal override void Draw(FootballDrawing drawing)
        {
            var shape = (CapsuleShape)KeeperDive.Kind.Shape;
            var upright = new Vector3d(0, shape.Radius - shape.From.Y, 0) + Place(Vector3.zero);
            _figure = drawing.Add("keeper", ShapeMesh.Of(shape), shirt);
            _figure.SetPositionAndRotation(UnityFrame.ToUnity(upright), Quaternion.identity);
        }

        /// <summary>Draws him in the pose of his dive.</summary>
        internal void Follow(KeeperDive dive)
        {
            Dives = dive.Count;
            if (_figure != null)
            {
                BallPose pose = dive.BodyPose;
                _figure.SetPositionAndRotation(UnityFrame.ToUnity(pose.Position), UnityFrame.ToUnity(pose.Orientation));
            }
        }
    }
}
