using System.Globalization;
using System.Runtime.CompilerServices;

namespace FootballPhysics.Labs.Stability;

/// <summary>Checks a frame.</summary>
internal delegate void FrameCheck(StressFrame frame);

/// <summary>A frame of a scene, and the list of its findings.</summary>
/// <param name="scene">The scene.</param>
/// <param name="simulator">Its simulator.</param>
/// <param name="absurdity">The number of decades by which the scene is outside ordinary numbers.</param>
/// <param name="findings">The list.</param>
internal sealed class StressFrame(StressScene scene, Simulator simulator, double absurdity, List<Finding> findings)
{
    /// <summary>The accuracy of a contact far from the ground, as a share of the distance.</summary>
    private const double FarShare = 1e-7;

    private readonly EnergyCheck _energy = new(scene, simulator);
    private BallState _before;
    private BallState _after;

    public StressScene Scene => scene;

    public Simulator Simulator => simulator;

    public AirBounds Air { get; } = new(scene.Scene);

    /// <summary>The height of the centre of a ball on the ground, m.</summary>
    public double Contact => simulator.ContactHeight;

    /// <summary>The deepest penetration, m: rounding of the height, and more for a ball that goes beyond <see cref="Limits.Length"/>.</summary>
    public double Touching
    {
        get
        {
            double farthest = Math.Max(Farthest(in _before), Farthest(in _after));
            return farthest > Limits.Length ? FarShare * farthest : 1e-9 + (4 * Ulp(Contact));
        }
    }

    public int Index { get; private set; } = -1;

    public bool HasFindings => findings.Count > 0;

    /// <summary>The length of the frame, s.</summary>
    public double Length { get; private set; }

    public StepLog Log { get; } = new();

    public ref readonly BallState Before => ref _before;

    public ref readonly BallState After => ref _after;

    /// <summary>The highest known speed in the frame, m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>The sum over all frames so far.</summary>
    public Tally Tally { get; private set; }

    /// <summary>Returns the energy that the frame created, and the part that the method may create; null if nothing is guaranteed.</summary>
    public FrameEnergy? Energy()
    {
        FrameEnergy? energy = _energy.Of(in _before, Length, in _after, Log.Events.Span);
        Tally = Tally with { EnergyShare = Math.Max(Tally.EnergyShare, energy?.Share ?? 0) };
        return energy;
    }

    /// <summary>Simulates the next frame, from the end of the last one.</summary>
    public void Play(ref BallState state, double length)
    {
        Index++;
        Length = length;
        _before = state;
        Log.Clear();
        simulator.Step(ref state, length, Log);
        _after = state;
        Tally += Tally.Of(Log) with { InNets = _before.Nets != 0 ? 1 : 0 };
        Fastest = Math.Max(_before.Velocity.Length, _after.Velocity.Length);
        foreach (ref readonly BallEvent item in Log.Events)
        {
            Fastest = Math.Max(Fastest, Math.Max(item.Velocity.Length, item.VelocityBefore.Length));
        }
    }

    /// <summary>Replaces the end of the frame, to test that the checks find it.</summary>
    public void Forge(BallState after) => _after = after;

    /// <summary>Adds a finding.</summary>
    public void Find(string check, double size, FormattableString detail) => findings.Add(new Finding(
        check, FormattableString.Invariant($"frame {Index} of {Length} s: {detail}"), size, absurdity + Absurdity.Outside(Length, 1e-4, 0.1)));

    /// <summary>Adds a finding, under a separate name if a game may have all numbers of the scene.</summary>
    public void FindMild(string check, double size, FormattableString detail) => Find(scene.IsMild ? $"{check}, mild" : check, size, detail);

    /// <summary>Adds a finding if a condition holds.</summary>
    public void FindIf(bool isWrong, string check, double size, [InterpolatedStringHandlerArgument(nameof(isWrong))] LazyText detail)
    {
        if (isWrong)
        {
            Find(check, size, $"{detail.ToString()}");
        }
    }

    /// <summary>Adds a finding if a condition holds, under a separate name if a game may have all numbers of the scene.</summary>
    public void FindMildIf(bool isWrong, string check, double size, [InterpolatedStringHandlerArgument(nameof(isWrong))] LazyText detail) =>
        FindIf(isWrong, scene.IsMild ? $"{check}, mild" : check, size, detail);

    /// <summary>Returns the distance to the next number.</summary>
    public static double Ulp(double value) => Math.BitIncrement(Math.Abs(value)) - Math.Abs(value);

    private double Farthest(in BallState s) => Math.Abs(s.Position.Y - Contact) + (s.Velocity.Length * Length);
}

/// <summary>A text that is formatted only if it is needed.</summary>
[InterpolatedStringHandler]
internal ref struct LazyText
{
    private DefaultInterpolatedStringHandler _text;

    public LazyText(int literalLength, int formattedCount, bool isNeeded, out bool formats)
    {
        formats = isNeeded;
        _text = isNeeded ? new DefaultInterpolatedStringHandler(literalLength, formattedCount, CultureInfo.InvariantCulture) : default;
    }

    public void AppendLiteral(string text) => _text.AppendLiteral(text);

    public void AppendFormatted<T>(T value, string? format = null) => _text.AppendFormatted(value, format);

    public override readonly string ToString() => _text.ToString();
}

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
