using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>Another law of friction needs few changes: those of benchmarks/Friction/slip-speed.patch, which benchmarks/friction.sh builds and compares with a closed form.</summary>
public sealed class FrictionPatchTests
{
    private const string Patch = "benchmarks/Friction/slip-speed.patch";

    [Fact]
    public void The_patch_changes_at_most_four_files()
    {
        int files = RepositoryFiles.Text(Patch).Split('\n').Count(line => line.StartsWith("+++ ", StringComparison.Ordinal));
        Assert.InRange(files, 1, 4);
    }

    [Fact]
    public void The_patch_fits_the_code()
    {
        string file = "";
        var before = new List<string>();
        foreach (string line in RepositoryFiles.Text(Patch).TrimEnd('\n').Split('\n').Append("@@"))
        {
            if (line.StartsWith("diff ", StringComparison.Ordinal) || line.StartsWith("@@", StringComparison.Ordinal))
            {
                Assert.Contains(string.Join('\n', before), file, StringComparison.Ordinal);
                before.Clear();
            }
            else if (line.StartsWith("--- a/", StringComparison.Ordinal))
            {
                file = RepositoryFiles.Text(line["--- a/".Length..]);
            }
            else if (line.StartsWith(' ') || (line.StartsWith('-') && !line.StartsWith("---", StringComparison.Ordinal)))
            {
                before.Add(line[1..]);
            }
        }
    }
}
