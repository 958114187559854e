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
