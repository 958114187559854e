namespace FootballPhysics.Tracks;

/// <summary>The answers of a match fit that are reliable to within their standard deviations.</summary>
[Flags]
public enum MatchAnswers
{
    /// <summary>None: only the positions, and about the speeds.</summary>
    None = 0,

    /// <summary>The velocities of the flights.</summary>
    Launches = 1,

    /// <summary>The spins of the flights.</summary>
    Spins = 2,

    /// <summary>The wind and the drag of the ball.</summary>
    WindAndDrag = 4,

    /// <summary>The surface.</summary>
    Surface = 8,
}

/// <summary>Faults of a track that a match fit suspects or has removed.</summary>
[Flags]
public enum TrackSuspicions
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>The points or residuals are too large for a ball in metres and seconds: other units, times or columns.</summary>
    Units = 1,

    /// <summary>The flights fall with another g: the clock, the frame rate or the scale of the heights is wrong.</summary>
    Scale = 2,

    /// <summary>The wind changes within the track: a half is turned, or the wind changed.</summary>
    Turned = 4,

    /// <summary>Another law of drag describes the flights better, but not to within the noise: another ball.</summary>
    DragLaw = 8,

    /// <summary>The residuals are far above the noise: the motion is not that of a free ball.</summary>
    Misfit = 16,

    /// <summary>Points lay on straight lines between others. They were left out.</summary>
    Lines = 32,

    /// <summary>Points repeated the position of a moving ball. They were left out.</summary>
    Held = 64,
}

/// <summary>Decides which answers of a match fit are reliable, and names the suspected faults of the track.</summary>
/// <remarks>The limits come from simulated tracks with known faults (football lab verdicts).</remarks>
internal sealed class MatchVerdict
{
    /// <summary>The maximum residual and noise of a track in metres and seconds, in m.</summary>
    private const double MostRms = 0.5;
    private const double MostNoise = 0.35;

    /// <summary>The residual above which no law of a free ball describes the flights: in m, and as a multiple of the noise plus m.</summary>
    private const double LeastSeen = 0.02;
    private const double SeenShare = 3;
    private const double SeenError = 0.05;

    /// <summary>The share of the points above the ground in flights below which the ball does not fly as one does.</summary>
    private const double LeastCovered = 0.35;

    /// <summary>The residual beyond the noise that another drag than that of the ball must not leave: in m, and as a multiple of the noise.</summary>
    /// <remarks>Below: the residual of a tenth of the flights of a ball with other drag is above it by chance. Above: constant drags pass.</remarks>
    private const double LawError = 0.0065;
    private const double LawShare = 0.7;

    /// <summary>The minimum number of flights, and the largest noise in m, for shared parameters; the minimum number of impacts for the surface.</summary>
    private const int LeastFlights = 4;
    private const double CoarseNoise = 0.06;
    private const int LeastImpacts = 4;

    /// <summary>The largest standard deviations of a good launch, in m/s, and of a good spin, in rad/s; this share of the flights must have them.</summary>
    private const double MostVelocity = 1;
    private const double MostSpin = 20;
    private const double GoodShare = 0.2;

    private const double ShortestFlight = 0.3;

    private readonly MatchFitResult _fit;
    private readonly MatchDoubts _doubts;
    private readonly TrackRuns _runs;

    public MatchVerdict(MatchFitResult fit, MatchDoubts doubts, TrackRuns runs)
    {
        _fit = fit;
        _doubts = doubts;
        _runs = runs;
        Suspicions = (runs.OnLines > 0 ? TrackSuspicions.Lines : 0) | (runs.Held > 0 ? TrackSuspicions.Held : 0)
            | (fit.Rms > MostRms || fit.Noise > MostNoise ? TrackSuspicions.Units : 0)
            | (doubts.IsScaled ? TrackSuspicions.Scale : 0) | (doubts.IsTurned ? TrackSuspicions.Turned : 0)
            | (doubts.HasNoCrisis || (doubts.HasOtherLaw && doubts.Excess > Math.Sqrt((LawError * LawError) + (LawShare * fit.Noise * LawShare * fit.Noise))) ? TrackSuspicions.DragLaw : 0)
            | (IsMisfit(fit.Rms, fit.Noise) || fit.Covered < LeastCovered ? TrackSuspicions.Misfit : 0);
        bool isFree = fit.Flights > 0 && (Suspicions & ~(TrackSuspicions.Lines | TrackSuspicions.Held)) == 0;
        bool many = isFree && fit.Flights >= LeastFlights && fit.Noise <= CoarseNoise;
        bool launches = isFree && Share(flight => IsGoodLaunch(flight.VelocityDeviation)) >= GoodShare;
        bool spins = launches && many && Share(flight => IsGoodSpin(flight.SpinDeviation)) >= GoodShare;
        Answers = (launches ? MatchAnswers.Launches : 0) | (spins ? MatchAnswers.Spins | MatchAnswers.WindAndDrag : 0) | (spins && fit.Impacts >= LeastImpacts ? MatchAnswers.Surface : 0);
    }

    /// <summary>True if residuals are too large for a free ball.</summary>
    public static bool IsMisfit(double rms, double noise) => rms > Math.Max(LeastSeen, SeenShare * noise) + SeenError;

    /// <summary>True if the standard deviations of a velocity allow a good launch.</summary>
    public static bool IsGoodLaunch(Vector3d deviation) => Most(deviation) <= MostVelocity;

    /// <summary>True if the standard deviations of a spin allow a good spin.</summary>
    public static bool IsGoodSpin(Vector3d deviation) => Most(deviation) <= MostSpin;

    public MatchAnswers Answers { get; }

    public TrackSuspicions Suspicions { get; }

    /// <summary>The verdict in words; the reservations follow a semicolon.</summary>
    public string Explanation => Good + Removed;

    private string Good =>
        Has(TrackSuspicions.Units) ? FormattableString.Invariant($"nothing: the fit is {_fit.Rms:0.00} m off, and its points are {_fit.Noise:0.00} m; check units, times and columns")
        : _fit.Flights == 0 ? "nothing that flies long enough: only when the ball was touched, and where it was on the ground"
        : Has(TrackSuspicions.Scale) ? FormattableString.Invariant($"where the ball flew and about how fast; it falls with {_doubts.Weight:0.000} g, as if the clock ran {Math.Abs((100 / Math.Sqrt(_doubts.Weight)) - 100):0.0} % {(_doubts.Weight < 1 ? "fast" : "slow")} or heights had another scale: check the frame rate, the times and the unit")
        : Has(TrackSuspicions.Turned) ? FormattableString.Invariant($"where the ball flew and about how fast; the wind changes by {_doubts.WindChange:0.0} m/s at about {_doubts.WindTime:0} s: check whether a half is turned, and fit the parts apart")
        : Has(TrackSuspicions.DragLaw) ? "where the ball flew and about how fast; its drag is not that of the ball, and its spins follow another law too: name the ball, or fit its launches one by one"
        : Has(TrackSuspicions.Misfit) ? "where the ball flew and about how fast; its track is not that of a free ball to within its noise, so no spin, wind or drag"
        : !Answers.HasFlag(MatchAnswers.Launches) ? "where the ball flew and about how fast; its flights are too short, or too coarse, for their launches"
        : !Answers.HasFlag(MatchAnswers.Spins) ? "launches of its flights; too few, or too coarse, for wind, drag and surface: those stay about what was known before"
        : !Answers.HasFlag(MatchAnswers.Surface) ? "launches and spins, wind and drag; too few impacts for the surface"
        : "launches and spins, wind and drag, and the surface";

    private string Removed =>
        (_runs.OnLines > 0 ? FormattableString.Invariant($"; {_runs.OnLines} points on straight lines between others were left out") : "")
        + (_runs.Held > 0 ? FormattableString.Invariant($"; {_runs.Held} repeated points were left out") : "");

    private bool Has(TrackSuspicions fault) => (Suspicions & fault) != 0;

    private double Share(Func<MatchPiece, bool> isGood)
    {
        MatchPiece[] flights = [.. _fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight && piece.Duration >= ShortestFlight)];
        return flights.Length == 0 ? 0 : (double)flights.Count(isGood) / flights.Length;
    }

    private static double Most(Vector3d deviation) => Math.Max(deviation.X, Math.Max(deviation.Y, deviation.Z));
}
