using System;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>A wall of players who stand side by side along x and stop a ball.</summary>
    [AddComponentMenu("Football/Football Wall"), DisallowMultipleComponent, ExecuteAlways]
    public sealed class FootballWall : FootballThing
    {
        [SerializeField, Range(1, 11), Tooltip("Number of players.")]
        private int players = 5;

        [SerializeField, Range(0.3f, 3f), Tooltip("Distance from player to player, m; each is half a metre wide.")]
        private float spacing = 0.52f;

        [SerializeField, Tooltip("Colour of the shirts.")]
        private Color shirts = new Color(0.78f, 0.16f, 0.2f, 1f);

        /// <summary>The number of players; 1 … 11.</summary>
        public int Players { get => players; set => players = value; }

        /// <summary>The distance between the centres of two players, m.</summary>
        public float Spacing { get => spacing; set => spacing = value; }

        internal override int Order => 2;

        internal override void AddTo(FootballScene scene)
        {
            for (int i = 0; i < players; i++)
            {
                scene.Stage.AddPlayer(name + " " + (i + 1), Feet(i));
            }
        }

        internal override int StampOfFields()
        {
            return HashCode.Combine(players, spacing, shirts);
        }

        internal override void Draw(FootballDrawing drawing)
        {
            var shape = (CapsuleShape)BodyKind.Player.Shape;
            for (int i = 0; i < players; i++)
            {
                Vector3d feet = Feet(i);
                drawing.Add("player", ShapeMesh.Of(new CapsuleShape(shape.From + feet, shape.To + feet, shape.Radius)), shirts);
            }
        }

        private Vector3d Feet(int player)
        {
            return Place(new Vector3((player - (0.5f * (players - 1))) * spacing, 0f, 0f));
        }
    }
}
