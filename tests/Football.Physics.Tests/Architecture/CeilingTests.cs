using System.Globalization;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>The size of the code stays below the ceilings of tests/ceilings.tsv. A change that makes the code smaller lowers them.</summary>
public sealed class CeilingTests
{
    private const string Ceilings = "tests/ceilings.tsv";

    /// <summary>tests/regenerate.sh lowers the ceilings to the counts, and raises none.</summary>
    [Fact]
    public void No_count_is_above_its_ceiling_or_far_below()
    {
        (string Name, int Count)[] counts = [.. CodeSize.Of(Path.Combine(RepositoryFiles.Root, "src")).Counts];
        string[] lines = RepositoryFiles.Text(Ceilings).TrimEnd('\n').Split('\n');
        if (RepositoryFiles.Regenerates)
        {
            File.WriteAllLines(Path.Combine(RepositoryFiles.Root, Ceilings), Lowered(lines, counts));
            return;
        }

        Assert.Empty(Faults(lines, counts));
    }

    [Theory]
    [InlineData(1000, null)]
    [InlineData(990, null)]
    [InlineData(1001, "a: working lines is 1001, above its ceiling 1000. Make the code smaller. To raise the ceiling, state in tests/ceilings.tsv what the code adds.")]
    [InlineData(989, "a: working lines is 989, more than 1 % below its ceiling 1000. Lower the ceiling in tests/ceilings.tsv to 989: tests/regenerate.sh does so.")]
    public void A_count_above_its_ceiling_is_found_and_one_far_below(int count, string? fault) =>
        Assert.Equal(fault is null ? [] : [fault], Faults(["count\tceiling\tadded", "a: working lines\t1000\t"], [("a: working lines", count)]));

    [Fact]
    public void A_count_without_a_ceiling_is_found_and_a_ceiling_without_a_count() => Assert.Equal(
        ["b has no ceiling. Add a line to tests/ceilings.tsv: its name, a tab, 2, a tab.", "a has a ceiling, but there is no such count. Remove its line from tests/ceilings.tsv."],
        Faults(["count\tceiling\tadded", "a\t1\t"], [("b", 2)]));

    [Fact]
    public void Ceilings_are_lowered_and_not_raised() => Assert.Equal(
        ["count\tceiling\tadded", "a\t900\t", "b\t1000\tA feature: 100."],
        Lowered(["count\tceiling\tadded", "a\t1000\t", "b\t1000\tA feature: 100."], [("a", 900), ("b", 1001)]));

    [Fact]
    public void A_line_works_if_it_contains_more_than_brackets()
    {
        string[] working = ["int a = 1;", "    } while (b);", "})) // The end.", "[Fact]", "#if NET"];
        string[] idle = ["", "   ", "// Words.", "    /// <summary>Words.</summary>", "{", "    });", "],", "}"];
        Assert.All(working, line => Assert.True(CodeSize.IsWorking(line), line));
        Assert.All(idle, line => Assert.False(CodeSize.IsWorking(line), line));
    }

    [Fact]
    public void Constants_and_friction_count_outside_the_tables_of_the_physics()
    {
        string root = Directory.CreateTempSubdirectory("football-size-").FullName;
        try
        {
            string[] file = ["class A", "{", "    private const double B = 1;", "    private static readonly double[] C = [2];", "    private static readonly int D = 3;", "    // Friction.", "    double E => f.SlidingFriction;", "}"];
            Write("Football.Physics/Contacts/A.cs", file);
            Write("Football.Physics/Contacts/obj/B.cs", file);
            Write("Football.Physics/Laws/A.cs", file);
            Write("Football.Physics/Game/A.cs", ["class A", "{", "    // Friction.", "    string B => nameof(Frictions);", "}"]);
            Write("Football.Other/A.cs", file);
            CodeSize size = CodeSize.Of(root);
            Assert.Equal([("core: working lines", 12), ("core: constants", 2), ("core: files that use the sliding friction", 1), ("Football.Other: working lines", 5)], size.Counts);
            Assert.Equal((1, 8, 5), size.Folders["Laws"]);
        }
        finally
        {
            Directory.Delete(root, true);
        }

        void Write(string path, string[] lines)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(root, path))!);
            File.WriteAllLines(Path.Combine(root, path), lines);
        }
    }

    private static List<string> Faults(IReadOnlyList<string> lines, IReadOnlyList<(string Name, int Count)> counts)
    {
        var faults = new List<string>();
        var ceilings = lines.Skip(1).Select(line => line.Split('\t')).ToDictionary(line => line[0], line => int.Parse(line[1], CultureInfo.InvariantCulture));
        foreach ((string name, int count) in counts)
        {
            if (!ceilings.Remove(name, out int ceiling))
            {
                faults.Add($"{name} has no ceiling. Add a line to {Ceilings}: its name, a tab, {count}, a tab.");
            }
            else if (count > ceiling)
            {
                faults.Add($"{name} is {count}, above its ceiling {ceiling}. Make the code smaller. To raise the ceiling, state in {Ceilings} what the code adds.");
            }
            else if (count < 0.99 * ceiling)
            {
                faults.Add($"{name} is {count}, more than 1 % below its ceiling {ceiling}. Lower the ceiling in {Ceilings} to {count}: tests/regenerate.sh does so.");
            }
        }

        return [.. faults, .. ceilings.Keys.Select(name => $"{name} has a ceiling, but there is no such count. Remove its line from {Ceilings}.")];
    }

    private static IEnumerable<string> Lowered(IReadOnlyList<string> lines, IReadOnlyList<(string Name, int Count)> counts)
    {
        var known = counts.ToDictionary(count => count.Name, count => count.Count);
        foreach (string line in lines)
        {
            string[] cells = line.Split('\t');
            bool lower = known.TryGetValue(cells[0], out int count) && count < int.Parse(cells[1], CultureInfo.InvariantCulture);
            yield return lower ? $"{cells[0]}\t{count}\t{cells[2]}" : line;
        }
    }
}
