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

        private FootballDrawing _drawing;
        private int _drawn;

        /// <summary>Tint of the pattern.</summary>
        public Color Color { get => color; set => color = value; }

        /// <summary>The material for drawing; null: the default of the render pipeline. A change takes effect when the component is enabled.</summary>
        public Material Material { get => material; set => material = value; }

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

        private void Draw()
        {
            _drawn = Stamp;
            _drawing = _drawing ?? new FootballDrawing(gameObject, material);

            // Draw the simulated size, whatever the object's scale.
            Vector3 scale = transform.lossyScale;
            float largest = Math.Max(1e-6f, Math.Max(Math.Abs(scale.x), Math.Max(Math.Abs(scale.y), Math.Abs(scale.z))));
            GetComponent<MeshFilter>().sharedMesh = _drawing.Fill(ShapeMesh.OfBall(Radius / largest));
            GetComponent<MeshRenderer>().sharedMaterial = _drawing.Made(color, FootballDrawing.BallTexture());
        }
    }
}
