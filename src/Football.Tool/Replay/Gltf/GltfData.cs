using System.Buffers.Binary;
using System.Text.Json.Nodes;

namespace FootballPhysics.Tool.Replay.Gltf;

/// <summary>The binary part of a glTF file: numbers in one buffer, and what says where they are.</summary>
internal sealed class GltfData
{
    private const int Float = 5126;
    private const int UnsignedInt = 5125;
    private const int ArrayBuffer = 34962;
    private const int ElementArrayBuffer = 34963;

    private readonly List<byte> _bytes = [];
    private readonly JsonArray _views = [];
    private readonly JsonArray _accessors = [];

    /// <summary>What an attribute of vertices is read from; its index.</summary>
    public int Vertices(IReadOnlyCollection<Vector3d> vectors) => Floats([.. vectors.SelectMany(Parts)], 3, ArrayBuffer);

    /// <summary>Indices of vertices.</summary>
    public int Indices(IReadOnlyCollection<int> indices)
    {
        int view = View(ElementArrayBuffer, 4 * indices.Count);
        byte[] four = new byte[4];
        foreach (int index in indices)
        {
            BinaryPrimitives.WriteUInt32LittleEndian(four, (uint)index);
            _bytes.AddRange(four);
        }

        return Accessor(view, UnsignedInt, indices.Count, "SCALAR");
    }

    /// <summary>Numbers of an animation.</summary>
    /// <param name="numbers">All of them.</param>
    /// <param name="width">How many make one element: 1, 3 or 4.</param>
    public int Animated(IReadOnlyList<double> numbers, int width) => Floats(numbers, width, null);

    /// <summary>Adds buffer, views and accessors to a file.</summary>
    public void AddTo(JsonObject file)
    {
        file["accessors"] = _accessors;
        file["bufferViews"] = _views;
        file["buffers"] = new JsonArray(new JsonObject
        {
            ["byteLength"] = _bytes.Count,
            ["uri"] = "data:application/octet-stream;base64," + Convert.ToBase64String([.. _bytes]),
        });
    }

    public static IEnumerable<double> Parts(Vector3d v) => [v.X, v.Y, v.Z];

    private int Floats(IReadOnlyList<double> numbers, int width, int? target)
    {
        float[] values = [.. numbers.Select(number => (float)number)];
        int view = View(target, 4 * values.Length);
        byte[] four = new byte[4];
        foreach (float value in values)
        {
            BinaryPrimitives.WriteSingleLittleEndian(four, value);
            _bytes.AddRange(four);
        }

        int accessor = Accessor(view, Float, values.Length / width, width switch { 1 => "SCALAR", 3 => "VEC3", _ => "VEC4" });
        _accessors[accessor]!["min"] = Ends(values, width, Math.Min);
        _accessors[accessor]!["max"] = Ends(values, width, Math.Max);
        return accessor;
    }

    private static JsonArray Ends(float[] values, int width, Func<float, float, float> best) =>
        [.. Enumerable.Range(0, width).Select(i => (JsonNode)values.Where((_, k) => k % width == i).Aggregate(best))];

    private int View(int? target, int length)
    {
        var view = new JsonObject { ["buffer"] = 0, ["byteOffset"] = _bytes.Count, ["byteLength"] = length };
        if (target is not null)
        {
            view["target"] = target;
        }

        _views.Add(view);
        return _views.Count - 1;
    }

    private int Accessor(int view, int component, int count, string type)
    {
        _accessors.Add(new JsonObject { ["bufferView"] = view, ["componentType"] = component, ["count"] = count, ["type"] = type });
        return _accessors.Count - 1;
    }
}
