using System.Text.Json.Nodes;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Replay.Gltf;

/// <summary>A moving picture as a glTF 2.0 file: right-handed, y up, metres and seconds, as the library has them.</summary>
internal sealed class GltfFile
{
    private const int Lines = 1;
    private const int LineStrip = 3;
    private const int Triangles = 4;

    private readonly GltfData _data = new();
    private readonly JsonArray _nodes = [];
    private readonly JsonArray _meshes = [];
    private readonly JsonArray _materials = [];
    private readonly JsonArray _samplers = [];
    private readonly JsonArray _channels = [];
    private readonly Dictionary<string, int> _materialOf = [];

    private GltfFile()
    {
    }

    /// <summary>The file's text.</summary>
    public static string Text(ReplayPicture picture)
    {
        var file = new GltfFile();
        if (picture.Ground is { } ground)
        {
            file.AddNode("ground", file.AddMesh("ground", file.Surface(Mesh.Of(ground), "#5d8a52")));
        }

        foreach (SceneShape shape in picture.Shapes)
        {
            file.Add(shape, picture.Shots.Max(shot => shot.Track.Keys[^1].Time));
        }

        int ball = file.AddMesh("ball", file.Surface(Mesh.Panels(pentagons: false), "#f4f6f8"), file.Surface(Mesh.Panels(pentagons: true), "#20262c"));
        int marker = file.AddMesh("event", file.Surface(Mesh.Rod(Vector3d.Zero, Vector3d.Zero, 0.06), "#ffd23f"));
        for (int i = 0; i < picture.Shots.Count; i++)
        {
            file.Add(picture.Shots[i], Palette.Series[i % Palette.Series.Count], ball, marker);
        }

        return file.Root(picture.Name).ToJsonString();
    }

    private JsonObject Root(string name)
    {
        var root = new JsonObject
        {
            ["asset"] = new JsonObject { ["version"] = "2.0", ["generator"] = "Football.Physics" },
            ["scene"] = 0,
            ["scenes"] = new JsonArray(new JsonObject { ["name"] = name, ["nodes"] = new JsonArray([.. Enumerable.Range(0, _nodes.Count).Select(i => (JsonNode)i)]) }),
            ["nodes"] = _nodes,
            ["meshes"] = _meshes,
            ["materials"] = _materials,
            ["animations"] = new JsonArray(new JsonObject { ["name"] = "play", ["samplers"] = _samplers, ["channels"] = _channels }),
        };
        _data.AddTo(root);
        return root;
    }

    private void Add(SceneShape shape, double end)
    {
        string colour = shape.Kind switch
        {
            SceneShapeKind.Frame => "#ffffff",
            SceneShapeKind.Net => "#d8dfe5",
            SceneShapeKind.Obstacle => "#8793a1",
            SceneShapeKind.Marking => "#f2f5f0",
            SceneShapeKind.Guide => "#e07b00",
            _ => throw new ArgumentOutOfRangeException(nameof(shape), shape.Kind, null),
        };
        List<JsonObject> parts = [];
        if (shape.Radius > 0)
        {
            parts.AddRange(shape.Lines.Select(line => Surface(Mesh.Rod(line[0], line[^1], shape.Radius), colour)));
        }
        else if (shape.Lines.Count > 0)
        {
            parts.Add(Thin([.. shape.Lines.SelectMany(line => line.Zip(line.Skip(1), (a, b) => (Vector3d[])[a, b]).SelectMany(pair => pair))], Lines, colour));
        }

        if (shape.Faces.Count > 0)
        {
            parts.Add(Surface(Mesh.Of(shape.Faces), colour));
        }

        if (parts.Count == 0)
        {
            return;
        }

        int node = AddNode(shape.Name, AddMesh(shape.Name, [.. parts]));
        if (shape.Velocity != Vector3d.Zero && end > 0)
        {
            Animate(node, "translation", "LINEAR", [0, end], [.. GltfData.Parts(Vector3d.Zero), .. GltfData.Parts(end * shape.Velocity)], 3);
        }
    }

    private void Add(ReplayShot shot, string colour, int ball, int marker)
    {
        IReadOnlyList<TrackKey> keys = Distinct(shot.Track.Keys);
        int node = AddNode(shot.Name, ball);
        JsonObject said = _nodes[node]!.AsObject();
        said["scale"] = new JsonArray(shot.Track.Radius, shot.Track.Radius, shot.Track.Radius);
        said["translation"] = Array(GltfData.Parts(keys[0].Position));
        said["rotation"] = Array(Parts(keys[0].Orientation));
        said["extras"] = new JsonObject { ["kick"] = shot.Kick };
        double[] times = [.. keys.Select(key => key.Time)];
        Animate(node, "translation", "CUBICSPLINE", times, [.. keys.SelectMany(key => (Vector3d[])[key.VelocityBefore, key.Position, key.Velocity]).SelectMany(GltfData.Parts)], 3);
        Animate(node, "rotation", "LINEAR", times, [.. keys.SelectMany(key => Parts(key.Orientation))], 4);

        AddNode(shot.Name + ", path", AddMesh(shot.Name + ", path", Thin([.. Path(keys)], LineStrip, colour)));
        foreach (BallEvent item in shot.Track.Events)
        {
            string kind = Words.Of(item.Kind);
            JsonObject mark = _nodes[AddNode(FormattableString.Invariant($"{shot.Name}, {kind} at {item.Time:0.000} s"), marker)]!.AsObject();
            mark["translation"] = Array(GltfData.Parts(item.Position));
            mark["extras"] = new JsonObject { ["kind"] = kind, ["time"] = item.Time, ["surface"] = shot.Track.SurfaceOf(item) };
        }
    }

    /// <summary>Times must increase as single numbers too, and a path needs two of them.</summary>
    private static List<TrackKey> Distinct(IReadOnlyList<TrackKey> keys)
    {
        List<TrackKey> kept = [keys[0]];
        foreach (TrackKey key in keys.Skip(1).Where(key => (float)key.Time > (float)kept[^1].Time))
        {
            kept.Add(key);
        }

        return kept.Count > 1 ? kept : [kept[0], kept[0] with { Time = kept[0].Time + 1 }];
    }

    private static IEnumerable<Vector3d> Path(IReadOnlyList<TrackKey> keys)
    {
        const int parts = 4;
        return keys.Zip(keys.Skip(1), (a, b) => Enumerable.Range(0, parts).Select(i => Track.Between(in a, in b, a.Time + (i * (b.Time - a.Time) / parts))))
            .SelectMany(places => places).Append(keys[^1].Position);
    }

    private static IEnumerable<double> Parts(Quaterniond q) => [q.X, q.Y, q.Z, q.W];

    private static JsonArray Array(IEnumerable<double> numbers) => [.. numbers.Select(number => (JsonNode)(double)(float)number)];

    private void Animate(int node, string path, string interpolation, IReadOnlyList<double> times, IReadOnlyList<double> values, int width)
    {
        _channels.Add(new JsonObject { ["sampler"] = _samplers.Count, ["target"] = new JsonObject { ["node"] = node, ["path"] = path } });
        _samplers.Add(new JsonObject { ["input"] = _data.Animated(times, 1), ["interpolation"] = interpolation, ["output"] = _data.Animated(values, width) });
    }

    private int AddNode(string name, int mesh)
    {
        _nodes.Add(new JsonObject { ["name"] = name, ["mesh"] = mesh });
        return _nodes.Count - 1;
    }

    private int AddMesh(string name, params JsonObject[] primitives)
    {
        _meshes.Add(new JsonObject { ["name"] = name, ["primitives"] = new JsonArray([.. primitives]) });
        return _meshes.Count - 1;
    }

    private JsonObject Surface(Mesh mesh, string colour) => new()
    {
        ["attributes"] = new JsonObject { ["POSITION"] = _data.Vertices(mesh.Positions), ["NORMAL"] = _data.Vertices(mesh.Normals) },
        ["indices"] = _data.Indices(mesh.Indices),
        ["material"] = Material(colour),
        ["mode"] = Triangles,
    };

    private JsonObject Thin(IReadOnlyCollection<Vector3d> places, int mode, string colour) => new()
    {
        ["attributes"] = new JsonObject { ["POSITION"] = _data.Vertices(places) },
        ["material"] = Material(colour),
        ["mode"] = mode,
    };

    private int Material(string colour)
    {
        if (!_materialOf.TryGetValue(colour, out int index))
        {
            _materialOf[colour] = index = _materials.Count;
            int rgb = Convert.ToInt32(colour[1..], 16);
            JsonNode Linear(int shift) => Math.Round(Math.Pow(((rgb >> shift) & 0xff) / 255.0, 2.2), 4);
            _materials.Add(new JsonObject
            {
                ["name"] = colour,
                ["pbrMetallicRoughness"] = new JsonObject
                {
                    ["baseColorFactor"] = new JsonArray(Linear(16), Linear(8), Linear(0), 1),
                    ["metallicFactor"] = 0,
                    ["roughnessFactor"] = 0.8,
                },
                ["doubleSided"] = true,
            });
        }

        return index;
    }
}
