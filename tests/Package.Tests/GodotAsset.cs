using System.Globalization;
using System.Reflection;
using System.Text.RegularExpressions;
using Godot;

namespace FootballPhysics.Package.Tests;

/// <summary>Reads the add-on's scenes and resources as Godot's text format has them, and makes what they say of the shims: an unknown script, property or reference is refused.</summary>
internal static partial class GodotAsset
{
    public const string Project = "samples/Godot";

    /// <summary>All files of the project that hold nodes or a resource.</summary>
    public static IEnumerable<string> Files => new[] { "*.tscn", "*.tres" }
        .SelectMany(pattern => Directory.EnumerateFiles(Path.Combine(Repository.Root, Project), pattern, SearchOption.AllDirectories))
        .Select(file => Path.GetRelativePath(Path.Combine(Repository.Root, Project), file).Replace('\\', '/'))
        .Order(StringComparer.Ordinal);

    /// <summary>Makes the nodes of a scene, in the tree and ready, and gives the one on top.</summary>
    public static Node Load(string file)
    {
        Node made = Make(file);
        Node.Root.AddChild(made);
        return made;
    }

    /// <summary>Makes a resource.</summary>
    public static Resource LoadResource(string file)
    {
        List<Section> sections = Sections(file);
        Section resource = sections.Single(section => section.Kind == "resource");
        var made = (Resource)Activator.CreateInstance(TypeOf(resource, sections))!;
        Fill(made, resource);
        return made;
    }

    private static Node Make(string file)
    {
        List<Section> sections = Sections(file);
        Node? top = null;
        var paths = new List<(Node Owner, PropertyInfo Property, string Path)>();
        foreach (Section section in sections.Where(section => section.Kind == "node"))
        {
            Node made = section.Head.TryGetValue("instance", out string? instance)
                ? Make(External(instance, sections)["res://".Length..])
                : (Node)Activator.CreateInstance(TypeOf(section, sections))!;
            made.Name = section.Head["name"];
            Node? parent = !section.Head.TryGetValue("parent", out string? path) ? null : path == "." ? top : top!.GetChildren().Single(child => child.Name.ToString() == path);
            Assert.Equal(top is null, parent is null);
            if (made is Node3D solid)
            {
                if (section.Body.Remove("transform", out string? transform))
                {
                    float[] n = Numbers(transform);
                    solid.GlobalTransform = new Transform3D(
                        new Basis(new Godot.Vector3(n[0], n[3], n[6]), new Godot.Vector3(n[1], n[4], n[7]), new Godot.Vector3(n[2], n[5], n[8])),
                        new Godot.Vector3(n[9], n[10], n[11]));
                }

                solid.GlobalTransform = parent is Node3D above ? above.GlobalTransform * solid.GlobalTransform : solid.GlobalTransform;
            }

            foreach ((string name, string value) in section.Body.Where(pair => pair.Value.StartsWith("NodePath", StringComparison.Ordinal)).ToList())
            {
                Assert.Contains($"\"{name}\"", section.Head["node_paths"], StringComparison.Ordinal);
                paths.Add((made, made.GetType().GetProperty(name)!, Quoted().Match(value).Groups[1].Value));
                section.Body.Remove(name);
            }

            Fill(made, section);
            parent?.AddChild(made);
            top ??= made;
        }

        foreach ((Node owner, PropertyInfo property, string path) in paths)
        {
            property.SetValue(owner, owner.GetChildren().Single(child => child.Name.ToString() == path));
        }

        return top!;
    }

    private static Type TypeOf(Section section, List<Section> sections)
    {
        if (section.Body.Remove("script", out string? script))
        {
            string name = Path.GetFileNameWithoutExtension(External(script, sections));
            Type scripted = typeof(GodotAddon.FootballBall).Assembly.GetType("FootballPhysics.GodotAddon." + name) ?? throw new InvalidOperationException($"There is no class {name}.");
            Type native = section.Head.TryGetValue("type", out string? given) ? typeof(Node).Assembly.GetType("Godot." + given)! : typeof(Resource);
            Assert.True(native.IsAssignableFrom(scripted), $"{name} is no {native.Name}");
            return scripted;
        }

        return typeof(Node).Assembly.GetType("Godot." + section.Head["type"]) ?? throw new InvalidOperationException($"The shim has no {section.Head["type"]}.");
    }

    private static string External(string reference, List<Section> sections)
    {
        string id = Quoted().Match(reference).Groups[1].Value;
        string path = sections.Single(section => section.Kind == "ext_resource" && section.Head["id"] == id).Head["path"];
        Assert.True(File.Exists(Path.Combine(Repository.Root, Project, path["res://".Length..])), path);
        return path;
    }

    private static void Fill(object made, Section section)
    {
        foreach ((string name, string value) in section.Body)
        {
            // What the engine's own types have the shim need not.
            if (made.GetType().Assembly == typeof(Node).Assembly)
            {
                continue;
            }

            PropertyInfo property = made.GetType().GetProperty(name) ?? throw new InvalidOperationException($"{made.GetType().Name} has no property {name}.");
            Assert.True(property.IsDefined(typeof(ExportAttribute)), $"{made.GetType().Name}.{name} is not exported.");
            object parsed = property.PropertyType.IsEnum ? Enum.ToObject(property.PropertyType, int.Parse(value, CultureInfo.InvariantCulture))
                : property.PropertyType == typeof(bool) ? value == "true"
                : Convert.ChangeType(value, property.PropertyType, CultureInfo.InvariantCulture);
            Assert.True(!property.PropertyType.IsEnum || Enum.IsDefined(property.PropertyType, parsed), $"{name} = {value}");
            property.SetValue(made, parsed);
        }
    }

    private static float[] Numbers(string value) => [.. value[(value.IndexOf('(', StringComparison.Ordinal) + 1)..^1].Split(',').Select(part => float.Parse(part, CultureInfo.InvariantCulture))];

    private static List<Section> Sections(string file)
    {
        var sections = new List<Section>();
        foreach (string line in File.ReadLines(Path.Combine(Repository.Root, Project, file)).Where(line => line.Length > 0))
        {
            if (line.StartsWith('['))
            {
                sections.Add(new Section(Kind().Match(line).Groups[1].Value, Head().Matches(line).ToDictionary(match => match.Groups[1].Value, match => match.Groups[2].Value.Trim('"'))));
            }
            else
            {
                string[] pair = line.Split(" = ", 2);
                sections[^1].Body.Add(pair[0], pair[1]);
            }
        }

        return sections;
    }

    [GeneratedRegex(@"^\[(\w+)")]
    private static partial Regex Kind();

    [GeneratedRegex("(\\w+)=(\"[^\"]*\"|\\w+\\([^)]*\\)|\\w+)")]
    private static partial Regex Head();

    [GeneratedRegex("\"([^\"]*)\"")]
    private static partial Regex Quoted();

    private sealed record Section(string Kind, Dictionary<string, string> Head)
    {
        public Dictionary<string, string> Body { get; } = [];
    }
}
