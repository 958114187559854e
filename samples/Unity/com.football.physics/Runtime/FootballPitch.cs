using System;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>A pitch: the ground of every football, at the height of this object, with lines, and with boards if their height is not 0. Goals are separate objects.</summary>
    /// <remarks>Its position is the centre of the pitch, whose length is along z. It may be rotated about y. Its scale is ignored.</remarks>
    [AddComponentMenu("Football/Football Pitch"), DisallowMultipleComponent, ExecuteAlways]
    public sealed class FootballPitch : FootballThing
    {
        [SerializeField, Range(10f, 200f), Tooltip("Length between the goal lines, m; 105 in football, 40 in futsal.")]
        private float length = 105f;

        [SerializeField, Range(5f, 150f), Tooltip("Width between the touchlines, m; 68 in football, 20 in futsal.")]
        private float width = 68f;

        [SerializeField, Tooltip("Use the goals and areas of futsal.")]
        private bool futsal;

        [SerializeField, Tooltip("Material of the ground; Of Profile: the ground of the ball's preset.")]
        private FootballPreset.GroundChoice surface = FootballPreset.GroundChoice.OfProfile;

        [SerializeField, Range(0f, 10f), Tooltip("Height of the boards around the pitch, m; 0 for none.")]
        private float boardHeight;

        [SerializeField, Range(0f, 50f), Tooltip("Distance of the boards from the lines, m; at 0 they have a gap for each goal.")]
        private float boardDistance = 4f;

        [SerializeField, Tooltip("Colour of the ground.")]
        private Color grass = new Color(0.27f, 0.48f, 0.24f, 1f);

        /// <summary>Length between the goal lines, m.</summary>
        public float Length { get => length; set => length = value; }

        /// <summary>Width between the touchlines, m.</summary>
        public float Width { get => width; set => width = value; }

        /// <summary>True for the goals and areas of futsal.</summary>
        public bool Futsal { get => futsal; set => futsal = value; }

        /// <summary>Height of the boards, m; 0 for none.</summary>
        public float BoardHeight { get => boardHeight; set => boardHeight = value; }

        /// <summary>Distance of the boards from the lines, m.</summary>
        public float BoardDistance { get => boardDistance; set => boardDistance = value; }

        /// <summary>The material of the ground.</summary>
        public FootballPreset.GroundChoice Surface { get => surface; set => surface = value; }

        internal override int Order => 0;

        /// <summary>Converts the pitch to the library's type, centred at the origin.</summary>
        public Pitch ToPitch()
        {
            return (futsal ? Pitch.Futsal : Pitch.Standard) with
            {
                Length = FootballPreset.Typed(length),
                Width = FootballPreset.Typed(width),
                BoardHeight = FootballPreset.Typed(boardHeight),
                BoardDistance = FootballPreset.Typed(boardDistance),
            };
        }

        internal override void AddTo(FootballScene scene)
        {
            Scene own = scene.Stage.Scene;
            Ground ground = surface == FootballPreset.GroundChoice.OfProfile ? own.Ground : FootballPreset.GroundOf(surface, own.Ground);
            scene.Stage.Scene = own with { Ground = FootballPreset.AtHeight(ground, FootballPreset.Typed(transform.position.y)) };
            foreach (Obstacle board in ToPitch().Boards)
            {
                scene.Stage.Add(board with { Shape = Placed((BoxShape)board.Shape) });
            }
        }

        internal override int StampOfFields()
        {
            return HashCode.Combine(HashCode.Combine(length, width, futsal, (int)surface), boardHeight, boardDistance, grass);
        }

        internal override void Draw(FootballDrawing drawing)
        {
            // At the same height, the lines would flicker in the grass, so draw the grass a little lower.
            Pitch pitch = ToPitch();
            Lay(drawing.Add("ground", ShapeMesh.GroundOf(pitch), grass), -0.012f);
            Lay(drawing.Add("lines", ShapeMesh.LinesOf(pitch), Color.white), -0.004f);
            foreach (Obstacle board in pitch.Boards)
            {
                drawing.Add(board.Name, ShapeMesh.Of(Placed((BoxShape)board.Shape)), new Color(0.16f, 0.24f, 0.45f, 1f));
            }
        }

        private void Lay(Transform drawn, float raised)
        {
            drawn.SetPositionAndRotation(transform.position + new Vector3(0f, raised, 0f), transform.rotation);
        }

        /// <summary>Moves a board of the pitch to the position of the pitch, which can be rotated about y.</summary>
        private BoxShape Placed(BoxShape board)
        {
            Quaterniond turn = UnityFrame.FromUnity(transform.rotation);
            return new BoxShape(UnityFrame.FromUnity(transform.position) + turn.Rotate(board.Center), board.HalfSize, turn);
        }
    }
}
