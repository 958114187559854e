#:property PublishAot=false
#:property RestorePackagesWithLockFile=false
#:property NoWarn=$(NoWarn);CS1591;CA1852

// Builds the library, its part for many balls and its engine part for Unity, puts them into the package's Plugins, and packs the package for the package manager. It needs only the .NET SDK.
//   dotnet run samples/Unity/pack.cs [DIR]                  the .tgz in DIR (default out)
//   dotnet run samples/Unity/pack.cs --branch NAME          the built package as the only content of a git branch, for Unity's "Install package from git URL"
// --native DIR, before these and as often as you like: with the C library that src/Football.Physics.Native/build.sh built into DIR, for jobs in Burst.
// FOOTBALL_ADDRESS=https://… is the address of the repository's pages, for the links of the package manager; default the address of "origin".
using System.Diagnostics;
using System.Formats.Tar;
using System.IO.Compression;
using System.Text;
using System.Text.RegularExpressions;

string root = AppContext.GetData("EntryPointFileDirectoryPath") is string folder ? Path.GetFullPath(Path.Combine(folder, "../..")) : Environment.CurrentDirectory;
string package = Path.Combine(root, "samples/Unity/com.football.physics");

// The C libraries: path in the package, source, and the names of the platform in a .meta file.
var natives = new SortedDictionary<string, byte[]>(StringComparer.Ordinal);
while (args is ["--native", string prefix, ..] && AddNative(Path.GetFullPath(prefix)))
{
    args = args[2..];
}

if (!Directory.Exists(package) || args.Length > 2 || (args.Length == 2 && args[0] != "--branch") || (args.Length == 1 && args[0].StartsWith('-')))
{
    Console.Error.WriteLine("Usage: dotnet run samples/Unity/pack.cs [--native DIR]... [DIR | --branch NAME]");
    return 2;
}

const string Library = "Football.Physics";
// Write to the error stream: the standard output contains only the path of the tarball.
Console.Error.WriteLine($"Building {Library}");
Run("dotnet", ["build", "-c", "Release", "-f", "netstandard2.1", Path.Combine(root, "src", Library), "-v", "q"]);
foreach (string kind in (string[])["dll", "xml"])
{
    File.Copy(Path.Combine(root, "src", Library, "bin/Release/netstandard2.1", $"{Library}.{kind}"), Path.Combine(package, "Plugins", $"{Library}.{kind}"), true);
}

string version = Run("dotnet", ["msbuild", Path.Combine(root, "src/Football.Physics"), "-t:FindVersion", "-getProperty:Version"]);
string manifest = WithLinks(Regex.Replace(File.ReadAllText(Path.Combine(package, "package.json")), "\"version\": \".*\"", $"\"version\": \"{version}\""));
string[] files = [.. Directory.EnumerateFiles(package, "*", SearchOption.AllDirectories).Select(file => Path.GetRelativePath(package, file).Replace('\\', '/')).Concat(natives.Keys).Order(StringComparer.Ordinal)];
if (args is ["--branch", string branch])
{
    WriteBranch(branch);
}
else
{
    WriteTarball(Path.GetFullPath(args is [string directory] ? directory : Path.Combine(root, "out")));
}

return 0;

// Writes a tarball for the package manager, with all files under "package/". Equal files give equal bytes.
void WriteTarball(string directory)
{
    Directory.CreateDirectory(directory);
    string path = Path.Combine(directory, $"com.football.physics-{version}.tgz");
    using (var zipped = new GZipStream(File.Create(path), CompressionLevel.SmallestSize))
    using (var tar = new TarWriter(zipped, TarEntryFormat.Pax))
    {
        foreach (string file in files)
        {
            using var content = new MemoryStream(Content(file));
            tar.WriteEntry(new UstarTarEntry(TarEntryType.RegularFile, "package/" + file)
            {
                DataStream = content,
                Mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead,
                ModificationTime = new DateTimeOffset(2026, 1, 1, 0, 0, 0, TimeSpan.Zero),
            });
        }
    }

    Console.WriteLine(path);
}

// Commits only the package, without the work tree or the index of the repository. If the branch already has this package, makes no commit.
void WriteBranch(string name)
{
    string reference = "refs/heads/" + name;
    var tree = new StringBuilder();
    foreach (string file in files)
    {
        tree.Append("100644 blob ").Append(Git(["hash-object", "-w", "--stdin"], Content(file))).Append('\t').Append(file).Append('\n');
    }

    // Use a separate index; mktree takes only one level.
    string index = Path.GetTempFileName();
    File.Delete(index);
    Environment.SetEnvironmentVariable("GIT_INDEX_FILE", index);
    Git(["update-index", "--add", "--index-info"], Encoding.UTF8.GetBytes(tree.ToString()));
    string written = Git(["write-tree"]);
    File.Delete(index);
    Environment.SetEnvironmentVariable("GIT_INDEX_FILE", null);
    string before = Git(["for-each-ref", "--format=%(objectname)", reference]);
    if (before.Length > 0 && Git(["rev-parse", before + "^{tree}"]) == written)
    {
        Console.WriteLine($"{name}: {before}, unchanged");
        return;
    }

    string message = $"Package for Unity {version}\n\nBuilt from {Git(["rev-parse", "HEAD"])}.";
    string commit = Git(["commit-tree", written, "-m", message, .. before.Length > 0 ? ["-p", before] : (string[])[]]);
    Git(["update-ref", reference, commit]);
    Console.WriteLine($"{name}: {commit}");
}

// Adds the libraries of a folder that build.sh wrote, each with its .meta file. Returns false if there is none.
bool AddNative(string prefix)
{
    (string File, string Folder, string Platform, string System, string Processor)[] all =
    [
        ("lib/libfootball_physics.so", "Linux", "Linux64", "Linux", "x86_64"),
        ("lib/libfootball_physics.dylib", "macOS", "OSXUniversal", "OSX", "ARM64"),
        ("bin/football_physics.dll", "Windows", "Win64", "Windows", "x86_64"),
    ];
    bool found = false;
    foreach ((string file, string directory, string platform, string system, string processor) in all.Where(item => File.Exists(Path.Combine(prefix, item.File))))
    {
        string target = $"Plugins/{directory}/{Path.GetFileName(file)}";
        natives[target] = File.ReadAllBytes(Path.Combine(prefix, file));
        natives[target + ".meta"] = Encoding.UTF8.GetBytes($"""
            fileFormatVersion: 2
            guid: {GuidOf(target)}
            PluginImporter:
              serializedVersion: 2
              isPreloaded: 0
              platformData:
              - first:
                  Any:
                second:
                  enabled: 0
                  settings: {"{}"}
              - first:
                  Editor: Editor
                second:
                  enabled: 1
                  settings:
                    CPU: {processor}
                    OS: {system}
              - first:
                  Standalone: {platform}
                second:
                  enabled: 1
                  settings:
                    CPU: {processor}

            """.ReplaceLineEndings("\n"));
        natives[$"Plugins/{directory}.meta"] = Encoding.UTF8.GetBytes($"fileFormatVersion: 2\nguid: {GuidOf($"Plugins/{directory}")}\nfolderAsset: yes\nDefaultImporter:\n  externalObjects: {{}}\n");
        found = true;
    }

    return found;
}

// Returns the GUID of a file of the package, which stays the same.
static string GuidOf(string path) => Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(Encoding.UTF8.GetBytes("com.football.physics/" + path)))[..32];

byte[] Content(string file) => natives.TryGetValue(file, out byte[]? native) ? native : file == "package.json" ? Encoding.UTF8.GetBytes(manifest) : File.ReadAllBytes(Path.Combine(package, file));

// Returns the text with absolute links, which need an address. Without an address, the package manager opens the files in the package.
string WithLinks(string text)
{
    string address = Environment.GetEnvironmentVariable("FOOTBALL_ADDRESS") ?? Git(["config", "--default", "", "--get", "remote.origin.url"]);
    address = Regex.Replace(address, "^(?:ssh://)?git@([^:/]+)[:/](.+)$", "https://$1/$2");
    Match parts = Regex.Match(address, "^(https?)://(?:[^@/]*@)?(.+?)(?:\\.git)?/?$");
    if (!parts.Success)
    {
        return text;
    }

    // Leave out the name and password that the address of a clone may contain.
    string pages = $"{parts.Groups[1].Value}://{parts.Groups[2].Value}/blob/HEAD/samples/Unity/com.football.physics";
    string links = $"  \"documentationUrl\": \"{pages}/Documentation~/index.md\",\n  \"changelogUrl\": \"{pages}/CHANGELOG.md\",\n  \"licensesUrl\": \"{pages}/LICENSE.md\",\n";
    return text.Replace("  \"license\":", links + "  \"license\":");
}

string Git(string[] arguments, byte[]? input = null) => Run("git", ["-C", root, .. arguments], input);

string Run(string program, string[] arguments, byte[]? input = null)
{
    var start = new ProcessStartInfo(program, arguments) { RedirectStandardInput = true, RedirectStandardOutput = true };
    using Process process = Process.Start(start)!;
    using (Stream to = process.StandardInput.BaseStream)
    {
        to.Write(input ?? []);
    }

    string output = process.StandardOutput.ReadToEnd().Trim();
    process.WaitForExit();
    if (process.ExitCode != 0)
    {
        Console.Error.WriteLine($"{program} {arguments[0]} failed.\n{output}");
        Environment.Exit(1);
    }

    return output;
}
