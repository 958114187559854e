namespace FootballPhysics.Labs.Hostile;

/// <summary>Everything that was found, by kind. Threads may share it.</summary>
internal sealed class HostileFindings
{
    private readonly Lock _lock = new();
    private readonly SortedDictionary<string, HostileFinding> _findings = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, HostileFinding> _refusals = new(StringComparer.Ordinal);

    public IReadOnlyDictionary<string, HostileFinding> Findings => _findings;

    /// <summary>How many kinds of findings there are so far.</summary>
    public int Kinds
    {
        get
        {
            lock (_lock)
            {
                return _findings.Count;
            }
        }
    }

    /// <summary>Scenes that the library refuses to build, by field.</summary>
    public IReadOnlyDictionary<string, HostileFinding> Refusals => _refusals;

    public void Add(string kind, in HostileSighting sighting) => Add(_findings, kind, in sighting);

    public void AddRefusal(string field, in HostileSighting sighting) => Add(_refusals, field, in sighting);

    private void Add(SortedDictionary<string, HostileFinding> to, string kind, in HostileSighting sighting)
    {
        lock (_lock)
        {
            if (!to.TryGetValue(kind, out HostileFinding? finding))
            {
                to[kind] = finding = new HostileFinding();
            }

            finding.Add(in sighting);
        }
    }
}
