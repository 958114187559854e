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

    // Slower tests run on their own, after all others, in s. The slowest do not run.
    private const double Slow = 0.3;
    private const double Slowest = 4;

    // A first process runs quick tests for about this long, in s.
    private const double First = 2.5;

    // Rules for the sources, and tests that compile or start other programs: they say nothing about behaviour.
    private static readonly string[] Excluded = [Namespace + "Architecture.", Namespace + "Laws.ChangedLawTests"];

    private readonly List<Unit> _units = [];

    /// <summary>Copies the tests, runs them without any mutant, and finds the mutants that each class reaches.</summary>
    /// <param name="classes">The only classes to run, or null for all.</param>
    /// <returns>False if a test fails.</returns>
    public bool Prepare(string[]? classes)
    {
        Dispose();
        Copy("tests/Football.Physics.Tests", "tests");
        Copy("tests/Package.Tests", "golden");
        string program = Path.Combine(folder, "tests/Football.Physics.Tests");
        using Process list = Process.Start(new ProcessStartInfo(program, ["-list", "classes", "-noColor"]) { RedirectStandardOutput = true })!;
        string[] names = [.. list.StandardOutput.ReadToEnd().Split('\n').Where(at => at.StartsWith(Namespace, StringComparison.Ordinal)).Select(at => at.Trim())];
        bool pass = Golden(-1) == 0;
        foreach (string of in names.Where(at => classes is null ? !Excluded.Any(at.StartsWith) : classes.Contains(at[(at.LastIndexOf('.') + 1)..])))
        {
            string reached = Path.Combine(folder, "reached");
            string xml = Path.Combine(folder, "times.xml");
            File.Delete(reached);
            pass &= Run("tests/Football.Physics.Tests", -2, 3600, ["-class", of, "-result-xml", xml], out _) == 0;
            HashSet<int> mutants = File.Exists(reached) ? [.. File.ReadAllText(reached).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(text => int.Parse(text, CultureInfo.InvariantCulture))] : [];
            (string Name, double Seconds)[] methods = [.. XDocument.Load(xml).Descendants("test").GroupBy(at => (string)at.Attribute("method")!).Select(at => ($"{of}.{at.Key}", at.Sum(test => (double)test.Attribute("time")!)))];
            string[] slow = [.. methods.Where(at => at.Seconds > Slow).Select(at => at.Name)];
            if (methods.Length > slow.Length)
            {
                _units.Add(new Unit(of, false, methods.Where(at => at.Seconds <= Slow).Sum(at => at.Seconds), slow, mutants));
            }

            _units.AddRange(methods.Where(at => at.Seconds is > Slow and < Slowest).Select(at => new Unit(at.Name, true, at.Seconds, [], mutants)));
        }

        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{_units.Count} groups of tests, {_units.Sum(at => at.Seconds):0} s"));
        return pass;
    }

    /// <summary>Returns how the mutant ends: killed, GOLDEN, SURVIVED or NOT-REACHED.</summary>
    /// <param name="mutant">Its number.</param>
    /// <param name="by">The class or the method that failed, or null.</param>
    public string End(int mutant, out string? by)
    {
        by = null;
        Unit[] reaching = [.. _units.Where(at => at.Reached.Contains(mutant)).OrderBy(at => at.IsMethod).ThenBy(at => (at.Seconds + 0.02) / (1 + at.Kills))];
        double sum = 0;
        Unit[] first = [.. reaching.TakeWhile(at => !at.IsMethod && (sum += at.Seconds) < First)];
        Unit[] rest = [.. reaching.Skip(first.Length)];
        foreach (Unit[] some in (Unit[][])[first, [.. rest.Where(at => !at.IsMethod)], [.. rest.Where(at => at.IsMethod)]])
        {
            if (some.Length > 0 && Run(some, mutant, out string? failed) is not 0)
            {
                by = failed ?? "the limit of time";
                foreach (Unit unit in some.Where(at => failed is not null && (failed + ".").StartsWith(at.Name + ".", StringComparison.Ordinal)))
                {
                    unit.Kills++;
                }

                return "killed";
            }
        }

        return Golden(mutant) is not 0 ? "GOLDEN" : reaching.Length > 0 ? "SURVIVED" : "NOT-REACHED";
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

    private int? Run(Unit[] units, int mutant, out string? failed) => Run("tests/Football.Physics.Tests", mutant, 5 + (4 * units.Sum(at => at.Seconds)),
        units.SelectMany(at => (string[])[at.IsMethod ? "-method" : "-class", at.Name, .. at.Without.SelectMany(method => (string[])["-method-", method])]), out failed);

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
    private sealed class Unit(string name, bool isMethod, double seconds, string[] without, HashSet<int> reached)
    {
        public string Name => name;

        public bool IsMethod => isMethod;

        public double Seconds => seconds;

        public string[] Without => without;

        public HashSet<int> Reached => reached;

        public int Kills { get; set; }
    }
}
