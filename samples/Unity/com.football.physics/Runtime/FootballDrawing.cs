using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.SceneManagement;

namespace FootballPhysics.Unity
{
    /// <summary>The drawing of an object. It consists of separate objects in the scene, which are never saved. They are created when the object is enabled, because children must not be created or destroyed while their parent is enabled or disabled.</summary>
    internal sealed class FootballDrawing
    {
        private static Vector3[] s_room = Array.Empty<Vector3>();
        private static Texture2D s_texture;

        private readonly List<UnityEngine.Object> _made = new List<UnityEngine.Object>();
        private readonly GameObject _owner;
        private readonly Material _material;

        /// <summary>Creates the drawing of an object with a material; null for the default of the render pipeline.</summary>
        public FootballDrawing(GameObject owner, Material material)
        {
            _owner = owner;
            _material = material;
        }

        /// <summary>Moves the points of a mesh, given in the library's frame.</summary>
        public static void Move(Mesh mesh, ReadOnlySpan<Vector3d> points)
        {
            Vector3[] vertices = s_room.Length == points.Length ? s_room : s_room = new Vector3[points.Length];
            for (int i = 0; i < vertices.Length; i++)
            {
                vertices[i] = UnityFrame.ToUnity(points[i]);
            }

            mesh.SetVertices(vertices);
            mesh.RecalculateBounds();
        }

        /// <summary>Adds a surface at its position, and returns its transform, by which it can be moved.</summary>
        public Transform Add(string name, ShapeMesh shape, Color color)
        {
            return Part(name, Fill(shape), Made(color, null)).transform;
        }

        /// <summary>Adds a net, and returns its mesh.</summary>
        public Mesh AddThreads(string name, NetMesh net, Color color)
        {
            var mesh = new Mesh { name = name, hideFlags = HideFlags.HideAndDontSave, indexFormat = IndexFormat.UInt32 };
            _made.Add(mesh);
            Move(mesh, net.Points);
            var up = new Vector3[net.Points.Length];
            Array.Fill(up, new Vector3(0f, 1f, 0f));
            mesh.SetNormals(up);
            mesh.SetIndices(net.Threads.ToArray(), MeshTopology.Lines, 0);
            Part(name, mesh, Made(color, null));
            return mesh;
        }

        /// <summary>Adds a line in world coordinates.</summary>
        public LineRenderer AddLine(string name, Material drawn, float width)
        {
            LineRenderer line = Part(name).AddComponent<LineRenderer>();
            line.sharedMaterial = drawn;
            line.useWorldSpace = true;
            line.positionCount = 0;
            line.startWidth = width;
            line.endWidth = width;
            return line;
        }

        /// <summary>Returns the pattern of a ball as a texture, which all balls share.</summary>
        public static Texture2D BallTexture()
        {
            if (s_texture != null)
            {
                return s_texture;
            }

            const int Width = 256;
            const int Height = 128;
            byte[] bright = BallPattern.Picture(Width, Height);
            var pixels = new Color32[bright.Length];
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    // Unity's textures begin at the bottom row.
                    byte at = bright[((Height - 1 - y) * Width) + x];
                    pixels[(y * Width) + x] = new Color32(at, at, at, 255);
                }
            }

            s_texture = new Texture2D(Width, Height) { name = "football", hideFlags = HideFlags.HideAndDontSave, wrapMode = TextureWrapMode.Repeat };
            s_texture.SetPixels32(pixels);
            s_texture.Apply();
            return s_texture;
        }

        /// <summary>Removes all parts of the drawing.</summary>
        public void Clear()
        {
            foreach (UnityEngine.Object made in _made)
            {
                if (Application.isPlaying)
                {
                    UnityEngine.Object.Destroy(made);
                }
                else
                {
                    UnityEngine.Object.DestroyImmediate(made);
                }
            }

            _made.Clear();
        }

        private GameObject Part(string name, Mesh mesh, Material drawn)
        {
            GameObject part = Part(name);
            part.AddComponent<MeshFilter>().sharedMesh = mesh;
            part.AddComponent<MeshRenderer>().sharedMaterial = drawn;
            return part;
        }

        private GameObject Part(string name)
        {
            var part = new GameObject(name) { hideFlags = HideFlags.HideAndDontSave, layer = _owner.layer };
            _made.Add(part);
            if (_owner.scene.IsValid())
            {
                SceneManager.MoveGameObjectToScene(part, _owner.scene);
            }

            return part;
        }

        /// <summary>Converts a surface to a mesh.</summary>
        public Mesh Fill(ShapeMesh shape)
        {
            int count = shape.Points.Length;
            var points = new Vector3[count];
            var normals = new Vector3[count];
            var picture = new Vector2[shape.TextureCoordinates.Length / 2];
            for (int i = 0; i < count; i++)
            {
                points[i] = UnityFrame.ToUnity(shape.Points[i]);
                normals[i] = UnityFrame.ToUnity(shape.Normals[i]);
            }

            for (int i = 0; i < picture.Length; i++)
            {
                picture[i] = new Vector2((float)shape.TextureCoordinates[2 * i], 1f - (float)shape.TextureCoordinates[(2 * i) + 1]);
            }

            var mesh = new Mesh { name = "football", hideFlags = HideFlags.HideAndDontSave, indexFormat = IndexFormat.UInt32 };
            _made.Add(mesh);
            mesh.SetVertices(points);
            mesh.SetNormals(normals);
            mesh.SetUVs(0, picture);
            mesh.SetIndices(shape.Triangles.ToArray(), MeshTopology.Triangles, 0);
            mesh.RecalculateBounds();
            return mesh;
        }

        /// <summary>Returns a copy of the given material, or of the default of the render pipeline, in a colour.</summary>
        public Material Made(Color color, Texture2D texture)
        {
            RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
            Material like = _material != null || pipeline == null ? _material : pipeline.defaultMaterial;
            Shader shader = like != null ? like.shader : pipeline != null ? pipeline.defaultShader : Shader.Find("Standard");
            Material made = like != null ? new Material(like) : new Material(shader);
            made.hideFlags = HideFlags.HideAndDontSave;
            made.color = color;
            if (texture != null)
            {
                made.mainTexture = texture;
            }

            _made.Add(made);
            return made;
        }
    }
}
