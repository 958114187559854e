namespace FootballPhysics.Scenarios.Input;

/// <summary>Suggests the intended name for a misspelt one.</summary>
public static class Spelling
{
    /// <summary>The maximum length of a name that is treated as misspelt.</summary>
    private const int Longest = 40;

    /// <summary>Returns the known name that is closest to the given one; null if none is close.</summary>
    public static string? Closest(string given, IEnumerable<string> names) => given.Length > Longest ? null : names
        .Select(name => (Name: name, Distance: Distance(given.ToUpperInvariant(), name.ToUpperInvariant())))
        .Where(item => item.Distance <= Math.Max(1, item.Name.Length / 3)
            || (given.Length >= 3 && item.Name.StartsWith(given, StringComparison.OrdinalIgnoreCase)))
        .OrderBy(item => item.Distance)
        .Select(item => item.Name)
        .FirstOrDefault();

    /// <summary>Returns the edit distance: the number of insertions, deletions, replacements and swaps of neighbours.</summary>
    private static int Distance(string from, string to)
    {
        var cost = new int[from.Length + 1, to.Length + 1];
        for (int i = 0; i <= from.Length; i++)
        {
            for (int j = 0; j <= to.Length; j++)
            {
                if (i == 0 || j == 0)
                {
                    cost[i, j] = i + j;
                    continue;
                }

                int replace = cost[i - 1, j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
                cost[i, j] = Math.Min(replace, Math.Min(cost[i - 1, j], cost[i, j - 1]) + 1);
                if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                {
                    cost[i, j] = Math.Min(cost[i, j], cost[i - 2, j - 2] + 1);
                }
            }
        }

        return cost[from.Length, to.Length];
    }
}
