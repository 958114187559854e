using System;
using FootballPhysics.Engines;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Draws a football: a sphere of its radius with the classic pattern, which makes the spin visible. It needs no texture or model.</summary>
    [AddComponentMenu("Football/Football Skin"), DisallowMultipleComponent, ExecuteAlways, RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    public sealed class FootballSkin : MonoBehaviour
    {
        [SerializeField, Tooltip("Material for drawing; empty: the default of the render pipeline.")]
        private Material material;

        [SerializeField, Tooltip("Tint of the pattern.")]
        private Color color = Color.white;

        [SerializeField, Tooltip("The drawn ball flattens at an impact. Body and colliders stay as they are.")]
        private bool squash = true;

        private FootballDrawing _drawing;
        private Vector3d[] _round;
        private Vector3d[] _flat;
        private Mesh _mesh;
        private bool _isFlat;
        private int _drawn;

        /// <summary>Tint of the pattern.</summary>
        public Color Color { get => color; set => color = value; }

        /// <summary>The material for drawing; null: the default of the render pipeline. A change takes effect when the component is enabled.</summary>
        public Material Material { get => material; set => material = value; }

        /// <summary>True if the drawn ball flattens at an impact; default true. Body and colliders stay as they are.</summary>
        public bool Squash { get => squash; set => squash = value; }

        private float Radius => TryGetComponent(out FootballBall ball) ? ball.Radius : (float)BallProperties.Modern.Radius;

        private int Stamp => HashCode.Combine(Radius, transform.lossyScale, color, material);

        private void OnEnable()
        {
            Draw();
        }

        private void OnDisable()
        {
            _drawing.Clear();
            _drawing = null;
            GetComponent<MeshFilter>().sharedMesh = null;
            GetComponent<MeshRenderer>().sharedMaterial = null;
        }

        private void Update()
        {
            if (Stamp != _drawn)
            {
                _drawing.Clear();
                Draw();
            }
        }

        private void LateUpdate()
        {
            // All balls have drawn themselves now.
            if (squash && TryGetComponent(out FootballBall ball))
            {
                Flatten(ball.Squash, UnityFrame.FromUnity(transform.rotation));
            }
        }

        /// <summary>Moves the points of the mesh. The object keeps its scale, which its colliders have too.</summary>
        private void Flatten(BallStretch stretch, Quaterniond orientation)
        {
            if (stretch.IsRound && !_isFlat)
            {
                return;
            }

            // Stretch in the frame of the world, and back.
            var back = new Quaterniond(-orientation.X, -orientation.Y, -orientation.Z, orientation.W);
            for (int i = 0; i < _flat.Length; i++)
            {
                _flat[i] = stretch.IsRound ? _round[i] : back.Rotate(stretch.Apply(orientation.Rotate(_round[i])));
            }

            FootballDrawing.Move(_mesh, _flat);
            _isFlat = !stretch.IsRound;
        }

        private void Draw()
        {
            _drawn = Stamp;
            _drawing = _drawing ?? new FootballDrawing(gameObject, material);

            // Draw the simulated size, whatever the object's scale.
            Vector3 scale = transform.lossyScale;
            float largest = Math.Max(1e-6f, Math.Max(Math.Abs(scale.x), Math.Max(Math.Abs(scale.y), Math.Abs(scale.z))));
            ShapeMesh ball = ShapeMesh.OfBall(Radius / largest);
            _round = ball.Points.ToArray();
            _flat = ball.Points.ToArray();
            _isFlat = false;
            _mesh = _drawing.Fill(ball);
            GetComponent<MeshFilter>().sharedMesh = _mesh;
            GetComponent<MeshRenderer>().sharedMaterial = _drawing.Made(color, FootballDrawing.BallTexture());
        }
    }
}
