namespace Football.Physics.Package.Tests;

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
        ("Which kick", ["Aiming", "Tracks", "Thesis"]),
        ("Many at once", ["Batch"]),
        ("Step by step, and the methods", ["Simulation", "Integration", "State"]),
        ("Vectors and limits", ["Numerics"]),
    ];

    /// <summary>Types that are things, or forces, though they stand among the scenes.</summary>
    private static readonly Dictionary<string, string> s_moved = new()
    {
        ["Obstacle"] = "Things that the ball meets",
        ["Goal"] = "Things that the ball meets",
        ["Net"] = "Things that the ball meets",
        ["Surface"] = "Things that the ball meets",
        ["Body"] = "Things that the ball meets",
        ["Bodies"] = "Things that the ball meets",
        ["Pitch"] = "Things that the ball meets",
        ["RigidMotion"] = "Things that the ball meets",
        ["IEngineColliders"] = "Things that the ball meets",
        ["EngineCollider"] = "Things that the ball meets",
        ["EngineHits"] = "Things that the ball meets",
        ["SphereCast"] = "Things that the ball meets",
    };

    private static readonly Dictionary<string, string> s_folders = Directory
        .EnumerateFiles(Path.Combine(Repository.Root, "src", "Football.Physics"), "*.cs", SearchOption.AllDirectories)
        .GroupBy(file => Path.GetFileNameWithoutExtension(file))
        .ToDictionary(files => files.Key, files => Path.GetRelativePath(Path.Combine(Repository.Root, "src", "Football.Physics"), Path.GetDirectoryName(files.First())!).Replace('\\', '/'));

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

    private static string? Titled(string folder) => s_groups.Where(group => group.Folders.Contains(folder)).Select(group => group.Title).FirstOrDefault();
}
