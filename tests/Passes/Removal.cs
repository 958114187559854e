using System.Diagnostics;
using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Mutants;

namespace FootballPhysics.Passes;

/// <summary>Removes the bodies that no play reaches, one at a time, and runs the tests that reach each of them.</summary>
internal static class Removal
{
    private const string Project = "Football.Physics.Tests";

    // A first process runs the fastest tests of a body for about this long, in s.
    private const double First = 1;

    // A test that ends later than this time and this multiple of its duration without the body has failed, in s.
    private const double Patience = 120;
    private const double Slower = 20;

    private static readonly string s_folder = Path.Combine(MarkedLibrary.Folder, "removed");

    /// <summary>Prints how each body ends: killed (a test fails without it), SURVIVED (tests reach it, and pass without it), or NOT-REACHED.</summary>
    /// <param name="bodies">The numbers of the bodies.</param>
    /// <param name="only">Parts of names. Only bodies whose name contains one of them are removed; null for all.</param>
    /// <returns>False if a body has no test that fails.</returns>
    public static bool Print(int[] bodies, string[]? only)
    {
        bodies = [.. bodies.Where(i => only is null || only.Any(Reach.NameOf(MarkedLibrary.Methods[i]).Contains))];
        var methods = new List<Method>();
        byte[] library = RemovedBodies.Compiled(bodies, methods);
        CopyTests();
        File.WriteAllBytes(Path.Combine(s_folder, "Football.Physics.dll"), library);

        // Tests of the sources say nothing about the behaviour, and tests of allocations or of compiled code fail in any case with switches.
        string reached = Path.Combine(s_folder, "reached.txt");
        string times = Path.Combine(s_folder, "times.xml");
        File.Delete(reached);
        if (Run(-1, ["-class-", "FootballPhysics.Tests.Architecture.*", "-result-xml", times], double.PositiveInfinity, reached) is not 0)
        {
            Console.WriteLine("Some tests fail although no body is removed. They do not count.");
        }

        Dictionary<string, double> passed = XDocument.Load(times).Descendants("test").GroupBy(test => $"{(string)test.Attribute("type")!}.{(string)test.Attribute("method")!}")
            .Where(tests => tests.All(test => (string)test.Attribute("result")! == "Pass")).ToDictionary(tests => tests.Key, tests => tests.Sum(test => (double)test.Attribute("time")!));
        ILookup<int, string> testsOf = File.ReadAllLines(reached).Select(line => line.Split(' '))
            .SelectMany(line => line[1..].Where(passed.ContainsKey).Select(test => (Body: int.Parse(line[0], CultureInfo.InvariantCulture), Test: test))).ToLookup(at => at.Body, at => at.Test);
        bool all = true;
        for (int i = 0; i < bodies.Length; i++)
        {
            string[] tests = [.. testsOf[i].Distinct().OrderBy(test => passed[test])];
            double sum = 0;
            string[] first = [.. tests.TakeWhile(test => (sum += passed[test]) < First)];
            bool killed = Fails(i, first, passed) || Fails(i, tests[first.Length..], passed);
            all &= killed;
            Method body = methods[bodies[i]];
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{(killed ? "killed" : tests.Length > 0 ? "SURVIVED" : "NOT-REACHED"),-11} {Reach.NameOf(body)}: {body.Lines}, {tests.Length} tests, {(tests.Length > 0 ? tests[0] : "")}"));
        }

        return all;
    }

    private static bool Fails(int body, string[] tests, Dictionary<string, double> passed) => tests.Length > 0
        && Run(body, tests.SelectMany(test => (string[])["-method", test]), Patience + (Slower * tests.Sum(test => passed[test])), null) is not 0;

    private static void CopyTests()
    {
        string from = Path.Combine(LibrarySources.Root, "tests", Project, "bin/Release/net10.0");
        foreach (string path in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string to = Path.Combine(s_folder, Path.GetRelativePath(from, path));
            Directory.CreateDirectory(Path.GetDirectoryName(to)!);
            File.Copy(path, to, true);
        }
    }

    // The exit code, or null if the tests do not end within a time, in s.
    private static int? Run(int body, IEnumerable<string> arguments, double limit, string? reached)
    {
        var start = new ProcessStartInfo(Path.Combine(s_folder, Project), ["-maxThreads", "1", "-noColor", .. reached is null ? ["-stopOnFail"] : Array.Empty<string>(), .. arguments])
        {
            WorkingDirectory = s_folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            Environment = { ["DOTNET_TieredPGO"] = "0", [RemovedBodies.Variable] = body.ToString(CultureInfo.InvariantCulture), [RemovedBodies.Reached] = reached },
        };
        using Process process = Process.Start(start)!;
        process.OutputDataReceived += (_, _) => { };
        process.ErrorDataReceived += (_, _) => { };
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        if (!process.WaitForExit(double.IsFinite(limit) ? TimeSpan.FromSeconds(limit) : Timeout.InfiniteTimeSpan))
        {
            process.Kill(true);
            return null;
        }

        process.WaitForExit();
        return process.ExitCode;
    }
}
