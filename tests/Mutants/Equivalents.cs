namespace FootballPhysics.Mutants;

/// <summary>The mutants that no test can kill, because no state of a ball can distinguish them from the original. They are in <c>equivalents.tsv</c>.</summary>
internal sealed class Equivalents
{
    private readonly Dictionary<string, string> _reasons = [];

    private Equivalents()
    {
    }

    /// <summary>Reads the list. Each line has the name of a mutant and a reason: file, member, text, number of the text in the member and reason, separated by tabs.</summary>
    public static Equivalents Read()
    {
        var list = new Equivalents();
        foreach (string line in File.ReadAllLines(Path.Combine(LibrarySources.Root, "tests/Mutants/equivalents.tsv")))
        {
            int end = line.LastIndexOf('\t');
            if (line.Split('\t').Length != 5 || end == line.Length - 1)
            {
                throw new InvalidDataException($"equivalents.tsv: a line needs a file, a member, a text, a number and a reason, but is \"{line}\".");
            }

            list._reasons.Add(line[..end], line[(end + 1)..]);
        }

        return list;
    }

    /// <summary>Returns why a mutant is equivalent, or null if the list does not contain it.</summary>
    public string? ReasonOf(string name) => _reasons.GetValueOrDefault(name);

    /// <summary>Checks that each line for a folder or file still has its mutant in the sources.</summary>
    /// <exception cref="InvalidDataException">A line has none.</exception>
    public void RequireThatAllExist(string room, string[] names)
    {
        HashSet<string> known = [.. names];
        foreach (string name in _reasons.Keys.Where(at => (at.StartsWith(room + "\t", StringComparison.Ordinal) || at.StartsWith(room + "/", StringComparison.Ordinal)) && !known.Contains(at)))
        {
            throw new InvalidDataException($"equivalents.tsv: the sources have no mutant \"{name}\". Correct the line, or remove it.");
        }
    }
}
