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

/// <summary>Counts of one scene, or their sum over many.</summary>
internal readonly record struct Tally
{
    public long Scenes { get; init; }

    public long Failed { get; init; }

    public long Frames { get; init; }

    /// <summary>The pieces of motion, and the most in one frame.</summary>
    public long Steps { get; init; }

    public long MostSteps { get; init; }

    /// <summary>The steps that reached their last piece, and the frames with such a step.</summary>
    public long Stalled { get; init; }

    public long StalledFrames { get; init; }

    public long Impacts { get; init; }

    public long Events { get; init; }

    public long Rests { get; init; }

    /// <summary>The frames that began in a net.</summary>
    public long InNets { get; init; }

    /// <summary>The highest share of the allowed energy that the method created in a frame.</summary>
    public double EnergyShare { get; init; }

    public string Verdict => Scenes == 0 ? "-" : Failed == 0 ? "holds" : FormattableString.Invariant($"{Failed} FAILED");

    public static Tally operator +(in Tally a, in Tally b) => new()
    {
        Scenes = a.Scenes + b.Scenes,
        Failed = a.Failed + b.Failed,
        Frames = a.Frames + b.Frames,
        Steps = a.Steps + b.Steps,
        MostSteps = Math.Max(a.MostSteps, b.MostSteps),
        Stalled = a.Stalled + b.Stalled,
        StalledFrames = a.StalledFrames + b.StalledFrames,
        Impacts = a.Impacts + b.Impacts,
        Events = a.Events + b.Events,
        Rests = a.Rests + b.Rests,
        InNets = a.InNets + b.InNets,
        EnergyShare = Math.Max(a.EnergyShare, b.EnergyShare),
    };

    /// <summary>Returns the counts of a frame.</summary>
    public static Tally Of(StepLog log)
    {
        int impacts = 0;
        int rests = 0;
        foreach (ref readonly BallEvent item in log.Events)
        {
            impacts += item.Kind == BallEventKind.Impact ? 1 : 0;
            rests += item.Kind == BallEventKind.Rest ? 1 : 0;
        }

        return new Tally
        {
            Frames = 1,
            Steps = log.Steps,
            MostSteps = log.Steps,
            Stalled = log.StalledSteps,
            StalledFrames = log.StalledSteps > 0 ? 1 : 0,
            Impacts = impacts,
            Events = log.Events.Count,
            Rests = rests,
        };
    }
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
