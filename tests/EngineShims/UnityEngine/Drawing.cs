using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public enum MeshTopology
    {
        Triangles = 0,
        Quads = 2,
        Lines = 3,
        LineStrip = 4,
        Points = 5,
    }

    public enum TextureWrapMode
    {
        Repeat,
        Clamp,
        Mirror,
        MirrorOnce,
    }

    public sealed class Mesh : Object
    {
        public Rendering.IndexFormat indexFormat { get; set; }

        public Vector3[] vertices { get; private set; } = Array.Empty<Vector3>();

        public Vector3[] normals { get; private set; } = Array.Empty<Vector3>();

        public Vector2[] uv { get; private set; } = Array.Empty<Vector2>();

        /// <summary>What was set last.</summary>
        public int[] Indices { get; private set; } = Array.Empty<int>();

        public MeshTopology Topology { get; private set; }

        public void SetVertices(Vector3[] inVertices) => vertices = (Vector3[])inVertices.Clone();

        public void SetNormals(Vector3[] inNormals) => normals = (Vector3[])inNormals.Clone();

        public void SetUVs(int channel, Vector2[] uvs) => uv = (Vector2[])uvs.Clone();

        public void SetIndices(int[] indices, MeshTopology topology, int submesh)
        {
            foreach (int index in indices)
            {
                if (index < 0 || index >= vertices.Length)
                {
                    throw new ArgumentException("An index is out of bounds.", nameof(indices));
                }
            }

            Indices = (int[])indices.Clone();
            Topology = topology;
        }

        public void RecalculateBounds()
        {
        }
    }

    public sealed class MeshFilter : Component
    {
        public Mesh? sharedMesh { get; set; }
    }

    public class Renderer : Component
    {
        public Material? sharedMaterial { get; set; }
    }

    public sealed class MeshRenderer : Renderer
    {
    }

    public sealed class LineRenderer : Renderer
    {
        private Vector3[] _points = Array.Empty<Vector3>();

        public bool useWorldSpace { get; set; } = true;

        public float startWidth { get; set; } = 1f;

        public float endWidth { get; set; } = 1f;

        public int positionCount
        {
            get => _points.Length;
            set => Array.Resize(ref _points, value);
        }

        public Vector3 GetPosition(int index) => _points[index];

        public void SetPosition(int index, Vector3 position) => _points[index] = position;

        /// <summary>As the engine does: no more than <see cref="positionCount"/> of them count.</summary>
        public void SetPositions(Vector3[] positions) => Array.Copy(positions, _points, Math.Min(positions.Length, _points.Length));
    }

    public sealed class Shader : Object
    {
        public static Shader? Find(string name) => name == "Standard" ? new Shader { name = name } : null;
    }

    public class Material : Object
    {
        public Material(Shader shader) => this.shader = shader;

        public Material(Material source)
        {
            shader = source.shader;
            color = source.color;
        }

        public Shader shader { get; set; }

        public Color color { get; set; }

        public Texture? mainTexture { get; set; }
    }

    public class Texture : Object
    {
        public TextureWrapMode wrapMode { get; set; }
    }

    public sealed class Texture2D : Texture
    {
        public Texture2D(int width, int height)
        {
            this.width = width;
            this.height = height;
        }

        public int width { get; }

        public int height { get; }

        /// <summary>What was applied.</summary>
        public Color32[] Pixels { get; private set; } = Array.Empty<Color32>();

        public void SetPixels32(Color32[] colors)
        {
            if (colors.Length != width * height)
            {
                throw new ArgumentException("Not as many as there are pixels.", nameof(colors));
            }

            Pixels = colors;
        }

        public void SetPixel(int x, int y, Color color)
        {
        }

        public void Apply()
        {
        }
    }

    public sealed class Camera : Behaviour
    {
        public static Camera? main { get; set; }

        /// <summary>In the shim the mouse always points where a test says.</summary>
        public Ray Pointing { get; set; }

        public Ray ScreenPointToRay(Vector3 pos) => Pointing;
    }

    public sealed class Light : Behaviour
    {
    }

    /// <summary>Remembers what was drawn.</summary>
    public static class Gizmos
    {
        public static Color color { get; set; }

        public static List<(Vector3 From, Vector3 To)> Lines { get; } = new List<(Vector3 From, Vector3 To)>();

        public static List<(Vector3 Center, float Radius)> Spheres { get; } = new List<(Vector3 Center, float Radius)>();

        public static void DrawLine(Vector3 from, Vector3 to) => Lines.Add((from, to));

        public static void DrawWireSphere(Vector3 center, float radius) => Spheres.Add((center, radius));
    }
}

namespace UnityEngine.Rendering
{
    public enum IndexFormat
    {
        UInt16,
        UInt32,
    }

    public abstract class RenderPipelineAsset : ScriptableObject
    {
        public virtual Material? defaultMaterial => null;

        public virtual Shader? defaultShader => null;
    }

    public static class GraphicsSettings
    {
        public static RenderPipelineAsset? currentRenderPipeline { get; set; }
    }
}

namespace Unity.Profiling
{
    /// <summary>Counts how often each was entered.</summary>
    public struct ProfilerMarker
    {
        private readonly string _name;

        public ProfilerMarker(string name) => _name = name;

        /// <summary>The name of the last one that was entered.</summary>
        public static string Last { get; private set; } = "";

        public AutoScope Auto()
        {
            Last = _name;
            return default;
        }

        public struct AutoScope : IDisposable
        {
            public void Dispose()
            {
            }
        }
    }
}
