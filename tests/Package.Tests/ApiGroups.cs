using System.Text.RegularExpressions;

namespace FootballPhysics.Package.Tests;

/// <summary>The families of types in the API reference, by the folders of the sources.</summary>
internal static partial class ApiGroups
{
    /// <summary>Folders of the sources by what their types are for, in the order in which a reader meets them.</summary>
    private static readonly (string Title, string[] Folders)[] s_groups =
    [
        ("A ball in a game", ["Game", "Events"]),
        ("Scenes: ball, air, ground", ["Scenes", "Scenes/Winds", "Laws"]),
        ("Objects that the ball hits", ["Scenes/Shapes", "Contacts"]),
        ("Where the ball will be", ["Prediction"]),
        ("Which kick", ["Aiming"]),
        ("Step by step, and the methods", ["Simulation", "Integration", "State"]),
        ("Vectors and limits", ["Numerics"]),
        ("Many at once", ["Batch"]),
        ("From a track: Football.Physics.Tracks", ["Tracks"]),
        ("In an engine", ["Engines"]),
        ("The methods of the thesis: Football.Physics.Thesis", ["Thesis"]),
    ];

    /// <summary>Types whose sources are among the scenes, but which a reader expects elsewhere.</summary>
    private static readonly Dictionary<string, string> s_moved = new()
    {
        ["Obstacle"] = "Objects that the ball hits",
        ["Goal"] = "Objects that the ball hits",
        ["Net"] = "Objects that the ball hits",
        ["SurfaceMaterial"] = "Objects that the ball hits",
        ["KinematicBody"] = "Objects that the ball hits",
        ["KinematicBodies"] = "Objects that the ball hits",
        ["Pitch"] = "Objects that the ball hits",
        ["RigidMotion"] = "Objects that the ball hits",
        ["IEngineColliders"] = "Objects that the ball hits",
        ["EngineCollider"] = "Objects that the ball hits",
        ["EngineHits"] = "Objects that the ball hits",
        ["SphereCast"] = "Objects that the ball hits",
    };

    private static readonly (string Project, string Room)[] s_parts =
    [
        ("Football.Physics", ""), ("Football.Physics.Batch", "Batch/"), ("Football.Physics.Engines", "Engines/"), ("Football.Physics.Thesis", "Thesis/"), ("Football.Physics.Tracks", "Tracks/"),
    ];

    private static readonly Dictionary<string, string> s_folders = s_parts
            .SelectMany(part => FoldersOf(Path.Combine(Repository.Root, "src", part.Project), part.Room))
            .GroupBy(file => file.Name)
            .ToDictionary(files => files.Key, files => files.First().Folder);

    /// <summary>All titles, in order.</summary>
    public static IEnumerable<string> Titles => s_groups.Select(group => group.Title);

    /// <summary>The title for a type.</summary>
    public static string Of(Type type)
    {
        Type outer = type.DeclaringType ?? type;
        string name = outer.Name.Split('`')[0];
        string folder = s_folders[name];
        return s_moved.GetValueOrDefault(name) ?? Titled(folder) ?? Titled(folder.Split('/')[0]) ?? throw new InvalidOperationException($"ApiGroups has no family for {folder}, the folder of {name}.");
    }

    private static IEnumerable<(string Name, string Folder)> FoldersOf(string root, string room) =>
        from file in Directory.GetFiles(root, "*.cs", SearchOption.AllDirectories).Order(StringComparer.Ordinal)
        let folder = Path.GetRelativePath(root, Path.GetDirectoryName(file)!).Replace('\\', '/')
        where folder.Split('/')[0] is not ("bin" or "obj")
        from type in Declared().Matches(File.ReadAllText(file))
        select (type.Groups[1].Value, room + folder.TrimStart('.'));

    private static string? Titled(string folder) => s_groups.Where(group => group.Folders.Contains(folder)).Select(group => group.Title).FirstOrDefault();

    [GeneratedRegex(@"^\s*public [\w ]*\b(?:class|struct|interface|enum|record|delegate \S+) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declared();
}
