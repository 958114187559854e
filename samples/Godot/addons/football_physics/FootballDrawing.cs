#nullable enable
using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>The drawing of an object: child meshes in world coordinates, which are not saved in the scene file.</summary>
internal sealed class FootballDrawing
{
    private static ImageTexture? s_texture;

    private readonly List<MeshInstance3D> _made = new();
    private readonly Node3D _owner;

    /// <summary>Creates the drawing of a node.</summary>
    public FootballDrawing(Node3D owner) => _owner = owner;

    /// <summary>The pattern of a ball as a texture, which all balls share.</summary>
    public static ImageTexture BallTexture => s_texture ??= ImageTexture.CreateFromImage(Image.CreateFromData(256, 128, false, Image.Format.L8, BallPattern.Picture()));

    /// <summary>Converts a surface to a mesh.</summary>
    public static ArrayMesh Fill(ShapeMesh shape)
    {
        var points = new Vector3[shape.Points.Length];
        var normals = new Vector3[points.Length];
        var picture = new Vector2[shape.TextureCoordinates.Length / 2];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = GodotFrame.ToGodot(shape.Points[i]);
            normals[i] = GodotFrame.ToGodot(shape.Normals[i]);
        }

        for (int i = 0; i < picture.Length; i++)
        {
            picture[i] = new Vector2((float)shape.TextureCoordinates[2 * i], (float)shape.TextureCoordinates[(2 * i) + 1]);
        }

        Godot.Collections.Array arrays = Arrays(points, shape.Triangles.ToArray());
        arrays[(int)Mesh.ArrayType.Normal] = normals;
        if (picture.Length > 0)
        {
            arrays[(int)Mesh.ArrayType.TexUV] = picture;
        }

        var mesh = new ArrayMesh();
        mesh.AddSurfaceFromArrays(Mesh.PrimitiveType.Triangles, arrays);
        return mesh;
    }

    /// <summary>Creates a material from a colour and, optionally, a texture.</summary>
    public static StandardMaterial3D Made(Color color, Texture2D? texture = null) => new() { AlbedoColor = color, AlbedoTexture = texture };

    /// <summary>Draws the threads of a net at their current positions.</summary>
    public static void Move(MeshInstance3D drawn, NetMesh net)
    {
        var points = new Vector3[net.Points.Length];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = GodotFrame.ToGodot(net.Points[i]);
        }

        var mesh = (ArrayMesh)drawn.Mesh;
        mesh.ClearSurfaces();
        mesh.AddSurfaceFromArrays(Mesh.PrimitiveType.Lines, Arrays(points, net.Threads.ToArray()));
    }

    /// <summary>Draws a line through points; nothing if there are fewer than two points.</summary>
    public static void Trace(MeshInstance3D drawn, ReadOnlySpan<Vector3> points)
    {
        var mesh = (ArrayMesh)drawn.Mesh;
        mesh.ClearSurfaces();
        if (points.Length > 1)
        {
            int[] pieces = new int[2 * (points.Length - 1)];
            for (int i = 0; i < pieces.Length; i++)
            {
                pieces[i] = (i + 1) / 2;
            }

            mesh.AddSurfaceFromArrays(Mesh.PrimitiveType.Lines, Arrays(points.ToArray(), pieces));
        }
    }

    /// <summary>Adds a surface at its position, and returns its instance, which can be moved.</summary>
    public MeshInstance3D Add(ShapeMesh shape, Color color) => Part(Fill(shape), Made(color));

    /// <summary>Adds a net.</summary>
    public MeshInstance3D Add(NetMesh net, Color color)
    {
        MeshInstance3D drawn = AddLine(color);
        Move(drawn, net);
        return drawn;
    }

    /// <summary>Adds a line without points.</summary>
    public MeshInstance3D AddLine(Color color)
    {
        StandardMaterial3D material = Made(color);
        material.ShadingMode = BaseMaterial3D.ShadingModeEnum.Unshaded;
        return Part(new ArrayMesh(), material);
    }

    /// <summary>Removes all parts of the drawing.</summary>
    public void Clear()
    {
        foreach (MeshInstance3D drawn in _made)
        {
            drawn.QueueFree();
        }

        _made.Clear();
    }

    private static Godot.Collections.Array Arrays(Vector3[] points, int[] indices)
    {
        var arrays = new Godot.Collections.Array();
        arrays.Resize((int)Mesh.ArrayType.Max);
        arrays[(int)Mesh.ArrayType.Vertex] = points;
        arrays[(int)Mesh.ArrayType.Index] = indices;
        return arrays;
    }

    private MeshInstance3D Part(Mesh mesh, Material material)
    {
        // Draw in world coordinates, whatever the owner's scale, so that the drawing matches the colliders.
        var drawn = new MeshInstance3D { Mesh = mesh, MaterialOverride = material, TopLevel = true };
        _owner.AddChild(drawn, false, Node.InternalMode.Back);
        drawn.GlobalTransform = Transform3D.Identity;
        _made.Add(drawn);
        return drawn;
    }
}
