namespace FootballPhysics.Mutants;

/// <summary>The mutants that no test can kill, because no state of a ball can distinguish them from the original. They are in <c>equivalents.tsv</c>.</summary>
internal sealed class Equivalents
{
    private readonly Dictionary<(string File, string Member, string What), string> _reasons = [];

    private Equivalents()
    {
    }

    /// <summary>Reads the list. Each line has a file, a member, the mutant as the program prints it, and a reason, separated by tabs.</summary>
    public static Equivalents Read()
    {
        var list = new Equivalents();
        foreach (string line in File.ReadAllLines(Path.Combine(LibrarySources.Root, "tests/Mutants/equivalents.tsv")))
        {
            string[] parts = line.Split('\t');
            if (parts.Length != 4 || parts[3].Length == 0)
            {
                throw new InvalidDataException($"equivalents.tsv: a line needs a file, a member, a mutant and a reason, but is \"{line}\".");
            }

            list._reasons.Add((parts[0], parts[1], parts[2]), parts[3]);
        }

        return list;
    }

    /// <summary>Returns why a mutant is equivalent, or null if the list does not contain it.</summary>
    public string? ReasonOf(Mutant mutant) => _reasons.GetValueOrDefault((mutant.File, mutant.Member, mutant.What));

    /// <summary>Checks that each line for a folder or file still has its mutant in the sources.</summary>
    /// <exception cref="InvalidDataException">A line has none.</exception>
    public void RequireThatAllExist(string room, IEnumerable<Mutant> all)
    {
        var known = all.Select(at => (at.File, at.Member, at.What)).ToHashSet();
        foreach (var line in _reasons.Keys.Where(at => (at.File == room || at.File.StartsWith(room + "/", StringComparison.Ordinal)) && !known.Contains(at)))
        {
            throw new InvalidDataException($"equivalents.tsv: {line.File} has no mutant \"{line.What}\" in {line.Member}. Correct the line, or remove it.");
        }
    }
}
