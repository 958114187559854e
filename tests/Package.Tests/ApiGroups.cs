namespace FootballPhysics.Package.Tests;

/// <summary>What one does with a type: by the folder of its source, of which there is one for each.</summary>
internal static class ApiGroups
{
    private const string Others = "More";

    /// <summary>Folders of the sources by what their types are for, in the order in which a reader meets them.</summary>
    private static readonly (string Title, string[] Folders)[] s_groups =
    [
        ("A ball in a game", ["Game", "Events"]),
        ("Scenes: ball, air, ground", ["Scenes", "Scenes/Winds"]),
        ("Things that the ball meets", ["Scenes/Shapes", "Contact"]),
        ("Where the ball will be", ["Prediction"]),
        ("Which kick", ["Aiming"]),
        ("Step by step, and the methods", ["Simulation", "Integration", "State"]),
        ("Vectors and limits", ["Numerics"]),
        ("Many at once: Football.Physics.Batch", ["Batch"]),
        ("From a track: Football.Physics.Tracks", ["Tracks"]),
        ("In an engine: Football.Physics.Engines", ["Engines"]),
        ("The methods of the thesis: Football.Physics.Thesis", ["Thesis"]),
    ];

    /// <summary>Types that are things, or forces, though they stand among the scenes.</summary>
    private static readonly Dictionary<string, string> s_moved = new()
    {
        ["Obstacle"] = "Things that the ball meets",
        ["Goal"] = "Things that the ball meets",
        ["Net"] = "Things that the ball meets",
        ["SurfaceMaterial"] = "Things that the ball meets",
        ["KinematicBody"] = "Things that the ball meets",
        ["KinematicBodies"] = "Things that the ball meets",
        ["Pitch"] = "Things that the ball meets",
        ["RigidMotion"] = "Things that the ball meets",
        ["IEngineColliders"] = "Things that the ball meets",
        ["EngineCollider"] = "Things that the ball meets",
        ["EngineHits"] = "Things that the ball meets",
        ["SphereCast"] = "Things that the ball meets",
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
    public static IEnumerable<string> Titles => s_groups.Select(group => group.Title).Append(Others);

    /// <summary>The title for a type.</summary>
    public static string Of(Type type)
    {
        Type outer = type.DeclaringType ?? type;
        string name = outer.Name.Split('`')[0];
        string folder = s_folders.GetValueOrDefault(name, "");
        return s_moved.GetValueOrDefault(name) ?? Titled(folder) ?? Titled(folder.Split('/')[0]) ?? Others;
    }

    private static IEnumerable<(string Name, string Folder)> FoldersOf(string root, string room) =>
        from file in Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories)
        select (Path.GetFileNameWithoutExtension(file), room + Path.GetRelativePath(root, Path.GetDirectoryName(file)!).Replace('\\', '/').TrimStart('.'));

    private static string? Titled(string folder) => s_groups.Where(group => group.Folders.Contains(folder)).Select(group => group.Title).FirstOrDefault();
}
