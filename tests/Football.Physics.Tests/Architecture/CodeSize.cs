using System.Globalization;
using System.Text.RegularExpressions;

namespace FootballPhysics.Tests.Architecture;

/// <summary>Counts the size of the core and of the other packages. To delete a comment or to join lines of brackets changes no count.</summary>
internal sealed partial class CodeSize
{
    // The numbers of these folders are those of the physics.
    private static readonly string[] s_tables = ["Numerics", "Laws", "Scenes", "Polyfills"];

    private readonly SortedDictionary<string, (int Files, int Lines, int Working)> _folders = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, int> _others = new(StringComparer.Ordinal);
    private int _constants;
    private int _friction;

    private CodeSize()
    {
    }

    /// <summary>The number of files, lines and working lines of each folder of the core.</summary>
    public IReadOnlyDictionary<string, (int Files, int Lines, int Working)> Folders => _folders;

    /// <summary>
    /// Each count with its name: the working lines of the core and of each other package; the numeric constants of the core outside the tables of the
    /// physics; and its files there that use the sliding friction, each of which a new law of friction must visit.
    /// </summary>
    public IEnumerable<(string Name, int Count)> Counts =>
    [
        ("core: working lines", _folders.Values.Sum(folder => folder.Working)),
        ("core: constants", _constants),
        ("core: files that use the sliding friction", _friction),
        .. _others.Select(package => ($"{package.Key}: working lines", package.Value)),
    ];

    /// <summary>Returns the counts of a folder of packages. The core is the package Football.Physics.</summary>
    public static CodeSize Of(string sources)
    {
        var size = new CodeSize();
        foreach (string package in Directory.EnumerateDirectories(sources, "Football*"))
        {
            string name = Path.GetFileName(package);
            if (name != "Football.Physics")
            {
                size._others[name] = 0;
            }

            foreach (string path in Directory.EnumerateFiles(package, "*.cs", SearchOption.AllDirectories))
            {
                string[] folders = Path.GetRelativePath(package, path).Split(Path.DirectorySeparatorChar);
                if (!folders.Contains("bin") && !folders.Contains("obj"))
                {
                    size.Add(name, folders[0], File.ReadAllLines(path));
                }
            }
        }

        return size;
    }

    /// <summary>True if a line contains code other than brackets. Documentation, comments and blank lines do not.</summary>
    public static bool IsWorking(string line)
    {
        string text = line.Trim();
        return text.Length > 0 && !text.StartsWith("//", StringComparison.Ordinal) && !Brackets().IsMatch(text);
    }

    public override string ToString() => string.Join('\n',
    [
        .. _folders.Select(folder => string.Create(
            CultureInfo.InvariantCulture, $"{folder.Key,-12} {folder.Value.Files,4} files {folder.Value.Lines,6} lines {folder.Value.Working,6} working")),
        .. Counts.Select(count => string.Create(CultureInfo.InvariantCulture, $"{count.Name}: {count.Count}")),
    ]);

    private void Add(string package, string folder, string[] lines)
    {
        string[] working = [.. lines.Where(IsWorking)];
        if (package != "Football.Physics")
        {
            _others[package] += working.Length;
            return;
        }

        (int files, int all, int before) = _folders.GetValueOrDefault(folder);
        _folders[folder] = (files + 1, all + lines.Length, before + working.Length);
        if (!s_tables.Contains(folder))
        {
            _constants += working.Count(line => Constant().IsMatch(line));
            _friction += working.Any(line => Friction().IsMatch(line)) ? 1 : 0;
        }
    }

    [GeneratedRegex(@"^[{}()\[\];,]+$")]
    private static partial Regex Brackets();

    [GeneratedRegex(@"\bconst (?:double|float|int|long|uint|ulong|byte|short)\b|\bstatic readonly (?:double|float|int|long|uint|ulong|byte|short)\b[^=]*= *-?[0-9.]")]
    private static partial Regex Constant();

    [GeneratedRegex(@"SlidingFriction|\bFriction\b")]
    private static partial Regex Friction();
}
