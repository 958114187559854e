namespace FootballPhysics.Labs.Stability;

/// <summary>The result of a scene.</summary>
/// <param name="Kind">The kind of the scene, which is a row of the results; empty if there is one kind only.</param>
/// <param name="Method">The integrator.</param>
/// <param name="Tally">The counts.</param>
/// <param name="Findings">The claims that do not hold.</param>
/// <param name="Refusal">The field that the library rejects; null if it accepts the scene.</param>
internal sealed record StressOutcome(string Kind, Integrator Method, Tally Tally, IReadOnlyList<Finding> Findings, Finding? Refusal = null)
{
    /// <summary>The first claim that does not hold; null if all hold.</summary>
    public Finding? Failure => Findings.Count > 0 ? Findings[0] : null;

    public string Verdict => Failure is { } f ? $"{f.Check}: {f.Detail}" : "holds";
}

/// <summary>
/// Counts of one scene, or their sum over many. Steps are pieces of motion; MostSteps is the most of them in one frame. Stalled counts the steps that
/// reached their last piece, and StalledFrames the frames with such a step. InNets counts the frames that began in a net. EnergyShare is the highest
/// share of the allowed energy that the method created in a frame.
/// </summary>
internal readonly record struct Tally(
    long Scenes, long Failed, long Frames, long Steps, long MostSteps, long Stalled, long StalledFrames, long Impacts, long Events, long Rests, long InNets, double EnergyShare)
{
    public string Verdict => Scenes == 0 ? "-" : Failed == 0 ? "holds" : FormattableString.Invariant($"{Failed} FAILED");

    public static Tally operator +(in Tally a, in Tally b) => new(
        a.Scenes + b.Scenes, a.Failed + b.Failed, a.Frames + b.Frames, a.Steps + b.Steps, Math.Max(a.MostSteps, b.MostSteps), a.Stalled + b.Stalled, a.StalledFrames + b.StalledFrames,
        a.Impacts + b.Impacts, a.Events + b.Events, a.Rests + b.Rests, a.InNets + b.InNets, Math.Max(a.EnergyShare, b.EnergyShare));

    /// <summary>Returns the counts of a frame.</summary>
    public static Tally Of(StepLog log) => new()
    {
        Frames = 1,
        Steps = log.Steps,
        MostSteps = log.Steps,
        Stalled = log.StalledSteps,
        StalledFrames = log.StalledSteps > 0 ? 1 : 0,
        Impacts = log.Events.Count(BallEventKind.Impact),
        Events = log.Events.Count,
        Rests = log.Events.Count(BallEventKind.Rest),
    };
}

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
