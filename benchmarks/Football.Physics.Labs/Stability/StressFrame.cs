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
