using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.Xml.Linq;

namespace FootballPhysics.Mutants;

/// <summary>Runs the tests on the mutants, one process at a time.</summary>
/// <param name="folder">A folder for copies of the built tests. It is deleted at the end.</param>
/// <param name="sample">The mutants.</param>
internal sealed class Play(string folder, Sample sample) : IDisposable
{
    private const string Namespace = "FootballPhysics.Tests.";

    // Slower tests run only on the mutants that pass all others, in s. The slowest do not run.
    private const double Slow = 0.3;
    private const double Slowest = 4;

    // A first process runs quick tests for about this long, in s.
    private const double First = 2.5;

    // The duration of a class that may be new, in s.
    private const double Unknown = 5;

    // Rules for the sources, and tests that compile or start other programs: they say nothing about behaviour.
    private static readonly string[] Excluded = [Namespace + "Architecture.", Namespace + "Laws.ChangedLawTests"];

    private static readonly string[] Programs = ["tests/Football.Physics.Tests", "labs/Football.Physics.Labs.Tests"];

    private readonly List<Unit> _quick = [];
    private readonly List<Unit> _slow = [];

    /// <summary>Copies the tests, runs them without any mutant, and finds the mutants that each class reaches.</summary>
    /// <param name="classes">The only classes to run, or null for all.</param>
    /// <returns>False if a test fails.</returns>
    public bool Prepare(string[]? classes)
    {
        Dispose();
        Copy("tests/Football.Physics.Tests", "tests");
        Copy("tests/Football.Physics.Labs.Tests", "labs");
        Copy("tests/Package.Tests", "golden");
        bool pass = Golden(-1) == 0;
        foreach (string program in Programs.Where(at => classes is null && !File.Exists(Times(at))))
        {
            if (Run(program, -1, 3600, [.. Excluded.SelectMany(at => (string[])["-class-", at + "*"]), "-result-xml", Times(program)], out _) != 0)
            {
                // The list ends at the first failure, so the next run must not rely on it.
                File.Delete(Times(program));
                pass = false;
            }
        }

        var methods = Programs.Where(at => File.Exists(Times(at))).SelectMany(at => XDocument.Load(Times(at)).Descendants("test")).GroupBy(at => (Class: (string)at.Attribute("type")!, Method: (string)at.Attribute("method")!))
            .Select(at => (at.Key.Class, Name: $"{at.Key.Class}.{at.Key.Method}", Seconds: at.Sum(test => (double)test.Attribute("time")!)))
            .Where(at => !Excluded.Any(at.Class.StartsWith)).ToLookup(at => at.Class);
        foreach (string of in classes is null ? methods.Select(at => at.Key) : Classes().Where(at => classes.Contains(at[(at.LastIndexOf('.') + 1)..])))
        {
            var slow = methods[of].Where(at => classes is null && at.Seconds > Slow).ToArray();
            _slow.AddRange(slow.Where(at => at.Seconds < Slowest).Select(at => new Unit(at.Name, at.Seconds, [])));
            if (slow.Length == 0 || slow.Length < methods[of].Count())
            {
                double seconds = methods[of].Sum(at => at.Seconds) - slow.Sum(at => at.Seconds);
                _quick.Add(new Unit(of, methods.Contains(of) ? seconds : Unknown, [.. slow.Select(at => at.Name)]));
            }
        }

        return pass & Reach(_quick);
    }

    // A list of the durations of the tests. Delete it after the tests have changed much.
    private static string Times(string program) => Path.Combine(LibrarySources.Root, "artifacts/mutants", Path.GetFileName(program) + ".xml");

    private static string ProgramOf(string test) => Programs[test.StartsWith(Namespace, StringComparison.Ordinal) ? 0 : 1];

    private IEnumerable<string> Classes() => Programs.SelectMany(program =>
    {
        using Process list = Process.Start(new ProcessStartInfo(Path.Combine(folder, program), ["-list", "classes", "-noColor"]) { RedirectStandardOutput = true })!;
        return list.StandardOutput.ReadToEnd().Split('\n').Where(at => at.StartsWith("FootballPhysics.", StringComparison.Ordinal)).Select(at => at.Trim());
    });

    private bool Reach(List<Unit> units)
    {
        bool pass = true;
        string reached = Path.Combine(folder, "reached");
        foreach (Unit unit in units)
        {
            File.Delete(reached);
            pass &= Run([unit], -2, out _) == 0;
            unit.Reached = File.Exists(reached) ? [.. File.ReadAllText(reached).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(text => int.Parse(text, CultureInfo.InvariantCulture))] : [];
        }

        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{units.Count} groups of tests, {units.Sum(at => at.Seconds):0} s"));
        return pass;
    }

    /// <summary>Returns how the mutant ends: killed, GOLDEN, SURVIVED or NOT-REACHED.</summary>
    /// <param name="mutant">Its number.</param>
    /// <param name="by">The class or the method that failed, or null.</param>
    public string End(int mutant, out string? by)
    {
        Unit[] reaching = [.. _quick.Where(at => at.Reached.Contains(mutant)).OrderBy(at => (at.Seconds + 0.02) / (1 + at.Kills))];
        double sum = 0;
        Unit[] first = [.. reaching.TakeWhile(at => (sum += at.Seconds) < First)];
        return Kills(first, mutant, out by) || Kills([.. reaching.Skip(first.Length)], mutant, out by) ? "killed"
            : Golden(mutant) is not 0 ? "GOLDEN" : reaching.Length > 0 ? "SURVIVED" : "NOT-REACHED";
    }

    /// <summary>Finds the mutants that the slow tests reach.</summary>
    /// <returns>False if a test fails.</returns>
    public bool PrepareSlow() => Reach(_slow);

    /// <summary>Returns true if a slow test fails.</summary>
    public bool KilledBySlow(int mutant, out string? by) => Kills([.. _slow.Where(at => at.Reached.Contains(mutant)).OrderBy(at => at.Seconds)], mutant, out by);

    private bool Kills(Unit[] units, int mutant, out string? by)
    {
        by = null;
        foreach (IGrouping<string, Unit> ofProgram in units.GroupBy(at => ProgramOf(at.Name)))
        {
            if (Run([.. ofProgram], mutant, out string? failed) != 0)
            {
                foreach (Unit unit in ofProgram)
                {
                    unit.Kills += failed is not null && (failed + ".").StartsWith(unit.Name + ".", StringComparison.Ordinal) ? 1 : 0;
                }

                by = failed ?? "the limit of time";
                return true;
            }
        }

        return false;
    }

    /// <summary>Deletes the copies.</summary>
    public void Dispose()
    {
        if (Directory.Exists(folder))
        {
            Directory.Delete(folder, true);
        }
    }

    private int? Golden(int mutant) => Run("golden/Package.Tests", mutant, 60, ["-class", "FootballPhysics.Package.Tests.GoldenTests"], out _);

    private int? Run(Unit[] units, int mutant, out string? failed) => Run(ProgramOf(units[0].Name), mutant, mutant < 0 ? 3600 : 5 + (4 * units.Sum(at => at.Seconds)),
        units.SelectMany(at => (string[])[at.Name.EndsWith("Tests", StringComparison.Ordinal) ? "-class" : "-method", at.Name, .. at.Without.SelectMany(method => (string[])["-method-", method])]), out failed);

    // 0 if all tests pass; null if they do not end within the limit of processor time, in s.
    private int? Run(string program, int mutant, double limit, IEnumerable<string> arguments, out string? failed)
    {
        string path = Path.Combine(folder, program);
        var start = new ProcessStartInfo(path, ["-maxThreads", "1", "-noColor", "-stopOnFail", .. arguments])
        {
            WorkingDirectory = Path.GetDirectoryName(path),
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            Environment =
            {
                // A short run gains nothing from profiles.
                ["DOTNET_TieredPGO"] = "0",
                ["FOOTBALL_MUTANT"] = mutant.ToString(CultureInfo.InvariantCulture),
                ["FOOTBALL_MUTANTS_REACHED"] = Path.Combine(folder, "reached"),
            },
        };
        using Process process = Process.Start(start)!;
        string? first = null;
        process.OutputDataReceived += (_, line) =>
        {
            string? text = line.Data is not null && line.Data.Contains("[FAIL]", StringComparison.Ordinal) ? line.Data.Trim() : null;
            first ??= text?[..text.IndexOfAny([' ', '('])];
            if (mutant < 0 && text is not null)
            {
                Console.Error.WriteLine(text);
            }
        };
        process.ErrorDataReceived += (_, _) => { };
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        var watch = Stopwatch.StartNew();
        while (!process.WaitForExit(500))
        {
            // A blocked process uses no processor time.
            if (Used(process) > limit || watch.Elapsed.TotalSeconds > 10 * limit)
            {
                process.Kill(true);
                process.WaitForExit();
                failed = first;
                return null;
            }
        }

        process.WaitForExit();
        failed = first;
        return process.ExitCode;
    }

    // The processor time, in s, or 0 if the process has ended meanwhile.
    private static double Used(Process process)
    {
        try
        {
            return process.TotalProcessorTime.TotalSeconds;
        }
        catch (Exception e) when (e is InvalidOperationException or Win32Exception)
        {
            return 0;
        }
    }

    private void Copy(string project, string to)
    {
        string from = Path.Combine(LibrarySources.Root, project, "bin/Release/net10.0");
        foreach (string path in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string at = Path.Combine(folder, to, Path.GetRelativePath(from, path));
            Directory.CreateDirectory(Path.GetDirectoryName(at)!);
            File.Copy(path, at);
        }

        File.WriteAllBytes(Path.Combine(folder, to, "Football.Physics.dll"), sample.Library);
    }

    /// <summary>The quick tests of a class, or one slow method.</summary>
    private sealed class Unit(string name, double seconds, string[] without)
    {
        public string Name => name;

        public double Seconds => seconds;

        public string[] Without => without;

        public HashSet<int> Reached { get; set; } = [];

        public int Kills { get; set; }
    }
}
