namespace Godot;

public class VisualInstance3D : Node3D
{
}

public class GeometryInstance3D : VisualInstance3D
{
    public Material? MaterialOverride { get; set; }
}

public class MeshInstance3D : GeometryInstance3D
{
    public Mesh Mesh { get; set; } = new();
}

public class DirectionalLight3D : VisualInstance3D
{
}

public class Mesh : Resource
{
    public enum PrimitiveType
    {
        Points,
        Lines,
        LineStrip,
        Triangles,
        TriangleStrip,
    }

    public enum ArrayType
    {
        Vertex = 0,
        Normal = 1,
        Tangent = 2,
        Color = 3,
        TexUV = 4,
        TexUV2 = 5,
        Index = 12,
        Max = 13,
    }
}

public class ArrayMesh : Mesh
{
    /// <summary>What was added, and not cleared.</summary>
    public List<(PrimitiveType Primitive, Vector3[] Points, int[] Indices, Vector2[] Uv)> Surfaces { get; } = [];

    public void ClearSurfaces() => Surfaces.Clear();

    public void AddSurfaceFromArrays(PrimitiveType primitive, Collections.Array arrays)
    {
        if (arrays.Count != (int)ArrayType.Max)
        {
            throw new ArgumentException("Not as many arrays as there are kinds.", nameof(arrays));
        }

        var points = (Vector3[])arrays[(int)ArrayType.Vertex].Value;
        int[] indices = (int[])arrays[(int)ArrayType.Index].Value;
        if (points.Length == 0 || indices.Any(index => index < 0 || index >= points.Length))
        {
            throw new ArgumentException("An index is out of bounds.", nameof(arrays));
        }

        Surfaces.Add((primitive, points, indices, arrays[(int)ArrayType.TexUV].Value as Vector2[] ?? []));
    }
}

public class Material : Resource
{
}

public class BaseMaterial3D : Material
{
    public enum ShadingModeEnum
    {
        Unshaded,
        PerPixel,
        PerVertex,
    }

    public Color AlbedoColor { get; set; } = new(1, 1, 1);

    public Texture2D? AlbedoTexture { get; set; }

    public ShadingModeEnum ShadingMode { get; set; } = ShadingModeEnum.PerPixel;
}

public class StandardMaterial3D : BaseMaterial3D
{
}

public class Texture2D : Resource
{
}

public class ImageTexture : Texture2D
{
    public Image Image { get; private init; } = null!;

    public static ImageTexture CreateFromImage(Image image) => new() { Image = image };
}

public class Image : Resource
{
    public enum Format
    {
        L8,
        La8,
        R8,
        Rg8,
        Rgb8,
        Rgba8,
    }

    public byte[] Data { get; private init; } = [];

    public static Image CreateFromData(int width, int height, bool useMipmaps, Format format, byte[] data) =>
        format == Format.L8 && data.Length == width * height ? new Image { Data = data } : throw new ArgumentException("Not as many bytes as there are pixels.", nameof(data));
}
