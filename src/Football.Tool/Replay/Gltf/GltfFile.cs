using System.Numerics;
using System.Runtime.InteropServices;
using System.Text.Json.Nodes;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios.Input;
using SharpGLTF.Memory;
using SharpGLTF.Schema2;
using SharpGLTF.Transforms;

namespace FootballPhysics.Tool.Replay.Gltf;

/// <summary>An animation as a glTF 2.0 file: right-handed, y up, metres and seconds, as in the library.</summary>
internal sealed class GltfFile
{
    private const string Base = "scene";

    private readonly ModelRoot _root = ModelRoot.CreateModel();
    private readonly SharpGLTF.Schema2.Scene _scene;
    private readonly Animation _play;
    private readonly Dictionary<string, Material> _materials = [];

    private GltfFile(string name)
    {
        _root.Asset.Generator = "Football.Physics";
        _scene = _root.UseScene(name);
        _play = _root.CreateAnimation("play");
    }

    public static string Text(ReplayPicture picture)
    {
        var file = new GltfFile(picture.Name);
        if (picture.Ground is { } ground)
        {
            SharpGLTF.Schema2.Mesh mesh = file._root.CreateMesh("ground");
            file.AddSurface(mesh, Mesh.Of(ground), "#5d8a52");
            file.AddNode("ground", mesh);
        }

        foreach (SceneShape shape in picture.Shapes)
        {
            file.Add(shape, picture.Shots.Max(shot => shot.Track.Keys[^1].Time));
        }

        SharpGLTF.Schema2.Mesh ball = file._root.CreateMesh("ball");
        file.AddSurface(ball, Mesh.Panels(pentagons: false), "#f4f6f8");
        file.AddSurface(ball, Mesh.Panels(pentagons: true), "#20262c");
        SharpGLTF.Schema2.Mesh marker = file._root.CreateMesh("event");
        file.AddSurface(marker, Mesh.Rod(Vector3d.Zero, Vector3d.Zero, 0.06), "#ffd23f");
        for (int i = 0; i < picture.Shots.Count; i++)
        {
            file.Add(picture.Shots[i], Palette.Series[i % Palette.Series.Count], ball, marker);
        }

        return file.InOneFile();
    }

    /// <summary>Returns the text with embedded binary data, without a second file.</summary>
    private string InOneFile()
    {
        _root.MergeBuffers();
        var files = new Dictionary<string, ArraySegment<byte>>();
        WriteContext.CreateFromDictionary(files).WithTextSettings().WriteTextSchema2(Base, _root);
        JsonNode text = JsonNode.Parse(files[Base + ".gltf"])!;
        text["scene"] = 0;
        JsonNode buffer = text["buffers"]![0]!;
        buffer["uri"] = "data:application/octet-stream;base64," + Convert.ToBase64String(files[buffer["uri"]!.GetValue<string>()]);
        return text.ToJsonString();
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
        if (shape.Lines.Count == 0 && shape.Faces.Count == 0)
        {
            return;
        }

        SharpGLTF.Schema2.Mesh mesh = _root.CreateMesh(shape.Name);
        if (shape.Radius > 0)
        {
            foreach (Vector3d[] line in shape.Lines)
            {
                AddSurface(mesh, Mesh.Rod(line[0], line[^1], shape.Radius), colour);
            }
        }
        else if (shape.Lines.Count > 0)
        {
            AddThin(mesh, shape.Lines.SelectMany(line => line.Zip(line.Skip(1), (a, b) => (Vector3d[])[a, b]).SelectMany(pair => pair)), PrimitiveType.LINES, colour);
        }

        if (shape.Faces.Count > 0)
        {
            AddSurface(mesh, Mesh.Of(shape.Faces), colour);
        }

        Node node = AddNode(shape.Name, mesh);
        if (shape.Velocity != Vector3d.Zero && end > 0)
        {
            _play.CreateTranslationChannel(node, new Dictionary<float, Vector3> { [0] = Vector3.Zero, [(float)end] = Single(end * shape.Velocity) });
        }
    }

    private void Add(ReplayShot shot, string colour, SharpGLTF.Schema2.Mesh ball, SharpGLTF.Schema2.Mesh marker)
    {
        IReadOnlyList<TrackKey> keys = Distinct(shot.Track.Keys);
        Node node = AddNode(shot.Name, ball);
        node.LocalTransform = new AffineTransform(new Vector3((float)shot.Track.Radius), Single(keys[0].Orientation), Single(keys[0].Position));
        node.Extras = new JsonObject { ["kick"] = shot.Kick };
        _play.CreateTranslationChannel(node, keys.ToDictionary(key => (float)key.Time, key => (Single(key.VelocityBefore), Single(key.Position), Single(key.Velocity))));
        _play.CreateRotationChannel(node, keys.ToDictionary(key => (float)key.Time, key => Single(key.Orientation)));

        SharpGLTF.Schema2.Mesh path = _root.CreateMesh(shot.Name + ", path");
        AddThin(path, Path(keys), PrimitiveType.LINE_STRIP, colour);
        AddNode(shot.Name + ", path", path);
        foreach (BallEvent item in shot.Track.Events)
        {
            string kind = Words.Of(item.Kind);
            Node mark = AddNode(FormattableString.Invariant($"{shot.Name}, {kind} at {item.Time:0.000} s"), marker);
            mark.LocalTransform = new AffineTransform(null, null, Single(item.Position));
            mark.Extras = new JsonObject { ["kind"] = kind, ["time"] = item.Time, ["surface"] = shot.Track.SurfaceOf(item) };
        }
    }

    /// <summary>Removes keys whose times are equal in single precision, and returns at least two keys.</summary>
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

    private static Vector3 Single(Vector3d v) => new((float)v.X, (float)v.Y, (float)v.Z);

    private static Quaternion Single(Quaterniond q) => Quaternion.Normalize(new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W));

    private Node AddNode(string name, SharpGLTF.Schema2.Mesh mesh)
    {
        Node node = _scene.CreateNode(name);
        node.Mesh = mesh;
        return node;
    }

    private void AddSurface(SharpGLTF.Schema2.Mesh to, Mesh mesh, string colour)
    {
        MeshPrimitive part = AddPart(to, PrimitiveType.TRIANGLES, colour);
        part.SetVertexAccessor("POSITION", Vertices(mesh.Positions));
        part.SetVertexAccessor("NORMAL", Vertices(mesh.Normals));
        Accessor indices = _root.CreateAccessor();
        indices.SetIndexData(View(mesh.Indices.Select(index => (uint)index), BufferMode.ELEMENT_ARRAY_BUFFER), 0, mesh.Indices.Count, IndexEncodingType.UNSIGNED_INT);
        part.SetIndexAccessor(indices);
    }

    private void AddThin(SharpGLTF.Schema2.Mesh to, IEnumerable<Vector3d> places, PrimitiveType kind, string colour) =>
        AddPart(to, kind, colour).SetVertexAccessor("POSITION", Vertices([.. places]));

    private MeshPrimitive AddPart(SharpGLTF.Schema2.Mesh to, PrimitiveType kind, string colour)
    {
        MeshPrimitive part = to.CreatePrimitive();
        part.DrawPrimitiveType = kind;
        part.Material = MaterialOf(colour);
        return part;
    }

    private Accessor Vertices(IReadOnlyList<Vector3d> vectors)
    {
        Accessor accessor = _root.CreateAccessor();
        accessor.SetVertexData(View(vectors.Select(Single), BufferMode.ARRAY_BUFFER), 0, vectors.Count, new AttributeFormat(DimensionType.VEC3, EncodingType.FLOAT, false));
        return accessor;
    }

    private BufferView View<T>(IEnumerable<T> values, BufferMode use)
        where T : unmanaged => _root.UseBufferView(MemoryMarshal.AsBytes<T>(values.ToArray()).ToArray(), 0, null, 0, use);

    private Material MaterialOf(string colour)
    {
        if (!_materials.TryGetValue(colour, out Material? material))
        {
            int rgb = Convert.ToInt32(colour[1..], 16);
            float Linear(int shift) => (float)Math.Round(Math.Pow(((rgb >> shift) & 0xff) / 255.0, 2.2), 4);
            _materials[colour] = material = _root.CreateMaterial(colour);
            material.InitializePBRMetallicRoughness();
            MaterialChannel baseColour = material.FindChannel("BaseColor")!.Value;
            baseColour.Color = new Vector4(Linear(16), Linear(8), Linear(0), 1);
            MaterialChannel metal = material.FindChannel("MetallicRoughness")!.Value;
            metal.SetFactor("MetallicFactor", 0);
            metal.SetFactor("RoughnessFactor", 0.8f);
            material.DoubleSided = true;
        }

        return material;
    }
}
