using FootballPhysics.Labs.Stability;

namespace FootballPhysics.Labs.Hostile;

/// <summary>A frame of a hostile scene that has been played, and where its findings go.</summary>
/// <param name="scene">The scene.</param>
/// <param name="simulator">Its simulator.</param>
/// <param name="absurdity">How far the scene lies outside ordinary numbers, decades.</param>
/// <param name="findings">Where findings go.</param>
internal sealed class HostileFrame(HostileScene scene, Simulator simulator, double absurdity, HostileFindings findings)
{
    private readonly EnergyCheck _energy = new(scene.Scene, scene.Settings, scene.Upward, simulator);
    private readonly StepLog _again = new();
    private BallState _before;
    private BallState _after;

    public HostileScene Scene => scene;

    /// <summary>Height of the centre of a ball on the ground, m.</summary>
    public double Contact => simulator.ContactHeight;

    /// <summary>Depth, m, that heights of so many digits cannot tell from none.</summary>
    public double Touching => 1e-9 + (4 * Ulp(Contact));

    public int Index { get; private set; }

    /// <summary>Length of the frame, s.</summary>
    public double Length { get; private set; }

    public StepLog Log { get; } = new();

    public ref readonly BallState Before => ref _before;

    public ref readonly BallState After => ref _after;

    /// <summary>The highest speed that is known of the frame, m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>The energy that the frame has made, and how much of it the method may make; null where nothing is promised.</summary>
    public FrameEnergy? Energy() => _energy.Of(in _before, Length, in _after, Log.Events.Span);

    /// <summary>Plays the next frame from where the last one ended.</summary>
    public void Play(int index, ref BallState state, double length)
    {
        Index = index;
        Length = length;
        _before = state;
        Log.Clear();
        simulator.Step(ref state, length, Log);
        _after = state;
        Fastest = Math.Max(_before.Velocity.Length, _after.Velocity.Length);
        foreach (ref readonly BallEvent item in Log.Events)
        {
            Fastest = Math.Max(Fastest, Math.Max(item.Velocity.Length, item.VelocityBefore.Length));
        }
    }

    /// <summary>Plays the same frame again, for the time that it takes.</summary>
    public void Again()
    {
        BallState state = _before;
        _again.Clear();
        simulator.Step(ref state, Length, _again);
    }

    /// <summary>Puts another end in the place of that which was played, to see that the checks find it.</summary>
    public void Forge(BallState after) => _after = after;

    /// <summary>Something that must not be.</summary>
    /// <param name="kind">What.</param>
    /// <param name="size">How bad.</param>
    /// <param name="detail">Numbers.</param>
    public void Find(string kind, double size, FormattableString detail)
    {
        double absurd = absurdity + Absurdity.Outside(Length, 1e-4, 0.1);
        findings.Add(kind, new HostileSighting(scene.Number, size, absurd, FormattableString.Invariant($"frame {Index} of {Length} s: ") + FormattableString.Invariant(detail)));
    }

    /// <summary>The same of a scene in which every number is one that a game might have is worth a word of its own.</summary>
    public void FindMild(string kind, double size, FormattableString detail) => Find(scene.IsMild ? $"{kind}, mild" : kind, size, detail);

    /// <summary>The distance to the next number.</summary>
    public static double Ulp(double value) => Math.BitIncrement(Math.Abs(value)) - Math.Abs(value);
}
