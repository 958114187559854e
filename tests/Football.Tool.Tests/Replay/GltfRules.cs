using System.Text.Json;

namespace FootballPhysics.Tool.Tests.Replay;

/// <summary>The rules of the glTF 2.0 specification for what such a file can hold, and where a file breaks them.</summary>
/// <param name="text">The file.</param>
internal sealed class GltfRules(string text)
{
    private const int Float = 5126;
    private const int UnsignedInt = 5125;

    /// <summary>The properties that the specification defines, of those objects that are in such a file.</summary>
    private static readonly Dictionary<string, string[]> Known = new()
    {
        [""] = ["asset", "scene", "scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers", "animations"],
        ["asset"] = ["version", "generator", "copyright", "minVersion"],
        ["scenes"] = ["name", "nodes"],
        ["nodes"] = ["name", "mesh", "children", "matrix", "translation", "rotation", "scale", "extras"],
        ["meshes"] = ["name", "primitives"],
        ["primitives"] = ["attributes", "indices", "material", "mode"],
        ["materials"] = ["name", "pbrMetallicRoughness", "doubleSided", "alphaMode", "alphaCutoff"],
        ["pbrMetallicRoughness"] = ["baseColorFactor", "metallicFactor", "roughnessFactor"],
        ["accessors"] = ["bufferView", "byteOffset", "componentType", "normalized", "count", "type", "min", "max", "name"],
        ["bufferViews"] = ["buffer", "byteOffset", "byteLength", "byteStride", "target", "name"],
        ["buffers"] = ["uri", "byteLength", "name"],
        ["animations"] = ["name", "channels", "samplers"],
        ["channels"] = ["sampler", "target"],
        ["target"] = ["node", "path"],
        ["samplers"] = ["input", "interpolation", "output"],
    };

    private readonly JsonElement _root = JsonDocument.Parse(text).RootElement;
    private readonly List<string> _broken = [];
    private byte[] _bytes = [];

    /// <summary>What is broken.</summary>
    public IReadOnlyList<string> Broken()
    {
        _broken.Clear();
        Check(_root.GetProperty("asset").GetProperty("version").GetString() == "2.0", "asset.version is 2.0");
        Names("", _root);
        Names("asset", _root.GetProperty("asset"));
        Buffers();
        if (_broken.Count == 0)
        {
            Accessors();
        }

        if (_broken.Count == 0)
        {
            Materials();
            Meshes();
            Nodes();
            Animations();
        }

        return _broken;
    }

    /// <summary>The numbers of an accessor of floats.</summary>
    public double[] Numbers(int accessor)
    {
        JsonElement described = List("accessors")[accessor];
        JsonElement view = List("bufferViews")[described.GetProperty("bufferView").GetInt32()];
        int offset = Whole(view, "byteOffset") + Whole(described, "byteOffset");
        int count = described.GetProperty("count").GetInt32() * Width(described);
        bool floats = described.GetProperty("componentType").GetInt32() == Float;
        return [.. Enumerable.Range(0, count).Select(i => floats ? BitConverter.ToSingle(_bytes, offset + (4 * i)) : BitConverter.ToUInt32(_bytes, offset + (4 * i)))];
    }

    private static int Whole(JsonElement of, string name, int fallback = 0) => of.TryGetProperty(name, out JsonElement value) ? value.GetInt32() : fallback;

    private static int Width(JsonElement accessor) => accessor.GetProperty("type").GetString() switch { "SCALAR" => 1, "VEC2" => 2, "VEC3" => 3, "VEC4" => 4, _ => 0 };

    private JsonElement[] List(string name) => _root.TryGetProperty(name, out JsonElement list) ? [.. list.EnumerateArray()] : [];

    private void Check(bool holds, string rule)
    {
        if (!holds)
        {
            _broken.Add(rule);
        }
    }

    private void Names(string kind, JsonElement of)
    {
        foreach (JsonProperty property in of.EnumerateObject())
        {
            Check(Known[kind].Contains(property.Name), $"{kind}.{property.Name} is a property of the specification");
        }
    }

    private bool Index(JsonElement of, string name, string list, bool required = true)
    {
        bool there = of.TryGetProperty(name, out JsonElement index);
        bool holds = there ? index.GetInt32() >= 0 && index.GetInt32() < List(list).Length : !required;
        Check(holds, $"{name} is an index into {list}");
        return holds && there;
    }

    private void Buffers()
    {
        JsonElement buffer = Assert.Single(List("buffers"));
        Names("buffers", buffer);
        const string begin = "data:application/octet-stream;base64,";
        string uri = buffer.GetProperty("uri").GetString()!;
        Check(uri.StartsWith(begin, StringComparison.Ordinal), "the buffer is in the file");
        _bytes = Convert.FromBase64String(uri[begin.Length..]);
        Check(_bytes.Length == buffer.GetProperty("byteLength").GetInt32(), "byteLength of the buffer");
        foreach (JsonElement view in List("bufferViews"))
        {
            Names("bufferViews", view);
            Index(view, "buffer", "buffers");
            int length = view.GetProperty("byteLength").GetInt32();
            Check(length > 0 && Whole(view, "byteOffset") + length <= _bytes.Length, "a view lies in its buffer");
            Check(Whole(view, "byteOffset") % 4 == 0, "a view of numbers of four bytes begins at a multiple of four");
            Check(Whole(view, "target", 34962) is 34962 or 34963, "target of a view");
        }
    }

    private void Accessors()
    {
        for (int i = 0; i < List("accessors").Length; i++)
        {
            JsonElement accessor = List("accessors")[i];
            Names("accessors", accessor);
            int count = accessor.GetProperty("count").GetInt32();
            int width = Width(accessor);
            int component = accessor.GetProperty("componentType").GetInt32();
            Check(component is Float or UnsignedInt && width > 0 && count > 0, $"type of accessor {i}");
            bool fits = Index(accessor, "bufferView", "bufferViews") && component is Float or UnsignedInt
                && Whole(accessor, "byteOffset") + (4L * width * count) <= List("bufferViews")[Whole(accessor, "bufferView")].GetProperty("byteLength").GetInt32();
            Check(fits, $"accessor {i} lies in its view");
            if (!fits)
            {
                continue;
            }

            double[] numbers = Numbers(i);
            Check(numbers.All(double.IsFinite), $"accessor {i} is finite");
            foreach ((string name, Func<IEnumerable<double>, double> end) in ((string, Func<IEnumerable<double>, double>)[])[("min", Enumerable.Min), ("max", Enumerable.Max)])
            {
                if (accessor.TryGetProperty(name, out JsonElement said))
                {
                    double[] ends = [.. Enumerable.Range(0, width).Select(k => end(numbers.Where((_, j) => j % width == k)))];
                    Check(said.EnumerateArray().Select(value => (double)value.GetSingle()).SequenceEqual(ends), $"{name} of accessor {i}");
                }
            }
        }
    }

    private void Materials()
    {
        foreach (JsonElement material in List("materials"))
        {
            Names("materials", material);
            JsonElement metal = material.GetProperty("pbrMetallicRoughness");
            Names("pbrMetallicRoughness", metal);
            double[] factors = metal.TryGetProperty("baseColorFactor", out JsonElement colour) ? [.. colour.EnumerateArray().Select(value => value.GetDouble())] : [1, 1, 1, 1];
            Check(factors.Length == 4, "baseColorFactor has four numbers");
            Check(factors.Append(metal.GetProperty("metallicFactor").GetDouble()).Append(metal.GetProperty("roughnessFactor").GetDouble()).All(value => value is >= 0 and <= 1), "factors are 0 to 1");
        }
    }

    private void Meshes()
    {
        foreach (JsonElement mesh in List("meshes"))
        {
            Names("meshes", mesh);
            Check(mesh.GetProperty("primitives").GetArrayLength() > 0, "a mesh has primitives");
            foreach (JsonElement primitive in mesh.GetProperty("primitives").EnumerateArray())
            {
                Names("primitives", primitive);
                Index(primitive, "material", "materials", required: false);
                Primitive(primitive);
            }
        }
    }

    private void Primitive(JsonElement primitive)
    {
        JsonElement attributes = primitive.GetProperty("attributes");
        int vertices = 0;
        foreach (JsonProperty attribute in attributes.EnumerateObject())
        {
            Check(attribute.Name is "POSITION" or "NORMAL", "a known attribute");
            JsonElement accessor = List("accessors")[attribute.Value.GetInt32()];
            Check(accessor.GetProperty("type").GetString() == "VEC3" && accessor.GetProperty("componentType").GetInt32() == Float, $"type of {attribute.Name}");
            int count = accessor.GetProperty("count").GetInt32();
            Check(vertices == 0 || vertices == count, "attributes have the same count");
            vertices = count;
            bool ends = accessor.TryGetProperty("min", out _) && accessor.TryGetProperty("max", out _);
            Check(attribute.Name != "POSITION" || ends, "positions have min and max");
            double[] numbers = Numbers(attribute.Value.GetInt32());
            Check(attribute.Name != "NORMAL" || numbers.Chunk(3).All(n => Math.Abs(Math.Sqrt(n.Sum(x => x * x)) - 1) < 1e-5), "normals have length 1");
        }

        int mode = Whole(primitive, "mode", 4);
        int drawn = vertices;
        if (Index(primitive, "indices", "accessors", required: false))
        {
            JsonElement accessor = List("accessors")[Whole(primitive, "indices")];
            Check(accessor.GetProperty("type").GetString() == "SCALAR" && accessor.GetProperty("componentType").GetInt32() == UnsignedInt, "type of indices");
            Check(Whole(List("bufferViews")[Whole(accessor, "bufferView")], "target") == 34963, "indices are in a view for them");
            Check(Numbers(Whole(primitive, "indices")).All(index => index < vertices), "indices name vertices");
            drawn = accessor.GetProperty("count").GetInt32();
        }

        Check(mode switch { 1 => drawn % 2 == 0, 3 => drawn >= 2, 4 => drawn % 3 == 0, _ => false }, $"count of mode {mode}");
    }

    private void Nodes()
    {
        JsonElement[] nodes = List("nodes");
        Check(Index(_root, "scene", "scenes"), "the scene is there");
        foreach (JsonElement scene in List("scenes"))
        {
            Names("scenes", scene);
            int[] roots = [.. scene.GetProperty("nodes").EnumerateArray().Select(node => node.GetInt32())];
            Check(roots.Distinct().Count() == roots.Length && roots.All(node => node >= 0 && node < nodes.Length), "nodes of a scene");
        }

        foreach (JsonElement node in nodes)
        {
            Names("nodes", node);
            Index(node, "mesh", "meshes", required: false);
            if (node.TryGetProperty("rotation", out JsonElement rotation))
            {
                Check(Math.Abs(rotation.EnumerateArray().Sum(part => part.GetDouble() * part.GetDouble()) - 1) < 1e-5, "a rotation has length 1");
            }
        }
    }

    private void Animations()
    {
        foreach (JsonElement animation in List("animations"))
        {
            Names("animations", animation);
            JsonElement[] samplers = [.. animation.GetProperty("samplers").EnumerateArray()];
            var targets = new HashSet<(int, string)>();
            foreach (JsonElement channel in animation.GetProperty("channels").EnumerateArray())
            {
                Names("channels", channel);
                JsonElement target = channel.GetProperty("target");
                Names("target", target);
                Index(target, "node", "nodes");
                string path = target.GetProperty("path").GetString()!;
                Check(path is "translation" or "rotation", "a path of a node without weights");
                Check(targets.Add((Whole(target, "node"), path)), "a target has one channel");
                int sampler = channel.GetProperty("sampler").GetInt32();
                Check(sampler >= 0 && sampler < samplers.Length, "a channel has its sampler");
                Sampler(samplers[sampler], path);
            }
        }
    }

    private void Sampler(JsonElement sampler, string path)
    {
        Names("samplers", sampler);
        string interpolation = sampler.TryGetProperty("interpolation", out JsonElement said) ? said.GetString()! : "LINEAR";
        Check(interpolation is "LINEAR" or "STEP" or "CUBICSPLINE", "an interpolation of the specification");
        JsonElement input = List("accessors")[Whole(sampler, "input")];
        JsonElement output = List("accessors")[Whole(sampler, "output")];
        Check(input.GetProperty("type").GetString() == "SCALAR" && input.TryGetProperty("min", out _) && input.TryGetProperty("max", out _), "times are numbers with their ends");
        double[] times = Numbers(Whole(sampler, "input"));
        Check(times[0] >= 0 && times.Zip(times.Skip(1)).All(pair => pair.First < pair.Second), "times increase from 0");
        Check(output.GetProperty("type").GetString() == (path == "rotation" ? "VEC4" : "VEC3"), $"type of {path}");
        Check(output.GetProperty("count").GetInt32() == times.Length * (interpolation == "CUBICSPLINE" ? 3 : 1), $"count of {interpolation}");
        Check(interpolation != "CUBICSPLINE" || times.Length >= 2, "a cubic has two ends");
        double[] values = Numbers(Whole(sampler, "output"));
        Check(path != "rotation" || values.Chunk(4).All(q => Math.Abs(q.Sum(x => x * x) - 1) < 1e-5), "rotations have length 1");
    }
}
