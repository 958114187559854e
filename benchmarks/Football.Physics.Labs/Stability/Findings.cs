namespace FootballPhysics.Labs.Stability;

/// <summary>A claim that does not hold in a scene.</summary>
/// <param name="Check">The claim.</param>
/// <param name="Detail">Numbers.</param>
/// <param name="Size">The size of the violation, in the unit of the claim.</param>
/// <param name="Absurdity">The number of decades by which the scene is outside ordinary numbers.</param>
internal sealed record Finding(string Check, string Detail, double Size = 1, double Absurdity = 0);

/// <summary>Findings of many scenes by kind: their number, the worst size, and the most ordinary scene.</summary>
internal sealed class Findings
{
    private readonly SortedDictionary<string, (long Count, (long Scene, Finding Found) Worst, (long Scene, Finding Found) Tamest)> _kinds = new(StringComparer.Ordinal);

    /// <summary>The number of kinds.</summary>
    public int Kinds => _kinds.Count;

    /// <summary>Adds a finding. The order of the calls does not matter: of two equal findings the scene with the lower number remains.</summary>
    public void Add(string kind, long scene, Finding found)
    {
        if (!_kinds.TryGetValue(kind, out var known))
        {
            _kinds[kind] = (1, (scene, found), (scene, found));
            return;
        }

        bool worse = found.Size > known.Worst.Found.Size || (found.Size == known.Worst.Found.Size && scene < known.Worst.Scene);
        bool tamer = found.Absurdity < known.Tamest.Found.Absurdity || (found.Absurdity == known.Tamest.Found.Absurdity && scene < known.Tamest.Scene);
        _kinds[kind] = (known.Count + 1, worse ? (scene, found) : known.Worst, tamer ? (scene, found) : known.Tamest);
    }

    /// <summary>Returns a table with a row per kind.</summary>
    public LabTable Table(string name, string first)
    {
        var table = new LabTable(name, first, "times", "worst", "scene", "detail", "tamest, decades", "its scene", "its detail");
        foreach ((string kind, (long count, (long Scene, Finding Found) worst, (long Scene, Finding Found) tamest)) in _kinds)
        {
            table.Add(kind, count, worst.Found.Size, worst.Scene, worst.Found.Detail, tamest.Found.Absurdity, tamest.Scene, tamest.Found.Detail);
        }

        return table;
    }
}
