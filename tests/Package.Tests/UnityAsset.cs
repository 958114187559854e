using System.Globalization;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;

namespace FootballPhysics.Package.Tests;

/// <summary>Reads the package's prefabs, scenes and assets as Unity's YAML has them, and makes what they say of the shims: an unknown script, field or reference is refused.</summary>
internal static partial class UnityAsset
{
    public const string Package = "samples/Unity/com.football.physics";

    private static readonly Dictionary<string, Type> s_scripts = Directory
        .EnumerateFiles(Path.Combine(Repository.Root, Package, "Runtime"), "*.cs.meta")
        .Select(meta => (Id: Guid().Match(File.ReadAllText(meta)).Groups[1].Value, Type: typeof(Unity.FootballBall).Assembly.GetType("FootballPhysics.Unity." + Path.GetFileName(meta)[..^".cs.meta".Length])))
        .Where(pair => pair.Type is not null)
        .ToDictionary(pair => pair.Id, pair => pair.Type!);

    /// <summary>All files of the package that hold objects.</summary>
    public static IEnumerable<string> Files => new[] { "*.prefab", "*.asset", "*.unity" }
        .SelectMany(pattern => Directory.EnumerateFiles(Path.Combine(Repository.Root, Package), pattern, SearchOption.AllDirectories))
        .Select(file => Path.GetRelativePath(Path.Combine(Repository.Root, Package), file).Replace('\\', '/'))
        .Order(StringComparer.Ordinal);

    /// <summary>Makes the game objects of a prefab or a scene, awake, and gives them by their names.</summary>
    public static Dictionary<string, GameObject> Load(string file)
    {
        List<Document> documents = Documents(file);
        var made = new Dictionary<string, GameObject>();
        var things = new Dictionary<string, GameObject>();
        var components = new Dictionary<string, Component>();
        foreach (Document document in documents.Where(document => document.Kind == "GameObject"))
        {
            things.Add(document.Id, new GameObject(document.Fields["m_Name"]) { layer = int.Parse(document.Fields["m_Layer"], CultureInfo.InvariantCulture) });
            made.Add(document.Fields["m_Name"], things[document.Id]);
        }

        foreach (Document document in documents.Where(document => document.Kind != "GameObject"))
        {
            GameObject owner = things[Reference(document.Fields["m_GameObject"])];
            Assert.Contains(document.Id, documents.Single(item => item.Kind == "GameObject" && item.Id == Reference(document.Fields["m_GameObject"])).Components);
            switch (document.Kind)
            {
                case "Transform":
                    break;
                case "MonoBehaviour":
                    components.Add(document.Id, owner.Attach(s_scripts[Guid().Match(document.Fields["m_Script"]).Groups[1].Value]));
                    break;
                default:
                    Type type = typeof(GameObject).Assembly.GetType("UnityEngine." + document.Kind)!;
                    components.Add(document.Id, owner.GetComponents<Component>().FirstOrDefault(type.IsInstanceOfType) ?? owner.Attach(type));
                    break;
            }
        }

        foreach (Document document in documents.Where(document => document.Kind == "Transform"))
        {
            // A child's place is in its parent's frame; parents stand before their children.
            Transform own = things[Reference(document.Fields["m_GameObject"])].transform;
            string father = Reference(document.Fields["m_Father"]);
            Transform? parent = father == "0" ? null : things[Reference(documents.Single(item => item.Id == father).Fields["m_GameObject"])].transform;
            var position = (UnityEngine.Vector3)Parse(document.Fields["m_LocalPosition"], typeof(UnityEngine.Vector3));
            var rotation = (UnityEngine.Quaternion)Parse(document.Fields["m_LocalRotation"], typeof(UnityEngine.Quaternion));
            own.SetPositionAndRotation(
                parent is null ? position : parent.position + (parent.rotation * position),
                parent is null ? rotation : parent.rotation * rotation);
            own.SetParent(parent);
        }

        foreach (Document document in documents.Where(document => document.Kind == "MonoBehaviour"))
        {
            Fill(components[document.Id], document, file);
        }

        foreach (GameObject item in made.Values)
        {
            item.WakeUp();
        }

        return made;
    }

    /// <summary>Makes an asset.</summary>
    public static ScriptableObject LoadAsset(string file)
    {
        Document document = Assert.Single(Documents(file));
        Type type = s_scripts[Guid().Match(document.Fields["m_Script"]).Groups[1].Value];
        var made = (ScriptableObject)Activator.CreateInstance(type)!;
        Fill(made, document, file);
        return made;
    }

    private static void Fill(object made, Document document, string file)
    {
        foreach ((string name, string value) in document.Fields.Where(pair => !pair.Key.StartsWith("m_", StringComparison.Ordinal)))
        {
            FieldInfo field = FieldOf(made.GetType(), name) ?? throw new InvalidOperationException($"{file}: {made.GetType().Name} has no serialised field {name}.");
            if (!value.StartsWith("{fileID", StringComparison.Ordinal))
            {
                field.SetValue(made, Parse(value, field.FieldType));
            }
            else
            {
                Assert.Equal("0", Reference(value)); // No prefab refers to anything but scripts.
            }
        }
    }

    /// <summary>A field that Unity serialises.</summary>
    private static FieldInfo? FieldOf(Type? type, string name)
    {
        for (; type is not null; type = type.BaseType)
        {
            FieldInfo? field = type.GetField(name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly);
            if (field is not null && (field.IsPublic || field.IsDefined(typeof(SerializeField))))
            {
                return field;
            }
        }

        return null;
    }

    private static object Parse(string value, Type type)
    {
        if (type.IsEnum)
        {
            object parsed = Enum.ToObject(type, int.Parse(value, CultureInfo.InvariantCulture));
            Assert.True(Enum.IsDefined(type, parsed), $"{type.Name} {value}");
            return parsed;
        }

        if (type == typeof(bool))
        {
            return value == "1";
        }

        if (!value.StartsWith('{'))
        {
            return Convert.ChangeType(value, type, CultureInfo.InvariantCulture);
        }

        object made = Activator.CreateInstance(type)!;
        foreach (string part in value.Trim('{', '}').Split(','))
        {
            string[] pair = [.. part.Split(':').Select(text => text.Trim())];
            if (type == typeof(LayerMask))
            {
                return (LayerMask)int.Parse(pair[1], CultureInfo.InvariantCulture);
            }

            FieldInfo field = type.GetField(pair[0]) ?? throw new InvalidOperationException($"{type.Name} has no field {pair[0]}.");
            field.SetValue(made, Parse(pair[1], field.FieldType));
        }

        return made;
    }

    private static string Reference(string value) => FileId().Match(value).Groups[1].Value;

    private static List<Document> Documents(string file)
    {
        var documents = new List<Document>();
        foreach (string line in File.ReadLines(Path.Combine(Repository.Root, Package, file)))
        {
            if (line.StartsWith("--- ", StringComparison.Ordinal))
            {
                documents.Add(new Document(line[(line.IndexOf('&', StringComparison.Ordinal) + 1)..]));
            }
            else if (line.StartsWith("  - component: ", StringComparison.Ordinal))
            {
                documents[^1].Components.Add(Reference(line));
            }
            else if (line.StartsWith("  - ", StringComparison.Ordinal) || line.StartsWith('%'))
            {
                continue;
            }
            else if (!line.StartsWith(' '))
            {
                documents[^1].Kind = line.TrimEnd(':');
            }
            else
            {
                int colon = line.IndexOf(':', StringComparison.Ordinal);
                documents[^1].Fields.Add(line[..colon].Trim(), line[(colon + 1)..].Trim());
            }
        }

        Assert.Equal(documents.Count, documents.Select(document => document.Id).Distinct().Count());
        return documents;
    }

    [GeneratedRegex("guid: ([0-9a-f]{32})")]
    private static partial Regex Guid();

    [GeneratedRegex(@"fileID: (\d+)")]
    private static partial Regex FileId();

    private sealed class Document(string id)
    {
        public string Id { get; } = id;

        public string Kind { get; set; } = "";

        public Dictionary<string, string> Fields { get; } = [];

        public List<string> Components { get; } = [];
    }
}
