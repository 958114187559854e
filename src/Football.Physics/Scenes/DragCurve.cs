using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Laws;

/// <summary>The drag coefficient of a ball without spin as a function of the Reynolds number, through the drag crisis.</summary>
/// <remarks>
/// Re = 2r|u|/ν. C_D = (a − b₀) q + b₀ + (Re − Re₀) σ(−(Re − Re₀)/Re_s) (b₁ − b₀)/(Re₁ − Re₀) with q = σ((Re − Re_c)/Re_s), σ(x) = 1/(1 + eˣ).
/// <para>The formula and the coefficients of the balls are those of Kiratidis and Leinweber (arXiv:1710.02784). Their wind-tunnel speeds are converted to
/// Reynolds numbers with the viscosity (1.51393e-5 m²/s) and diameter (0.22 m) of their study. The curves are measured up to Re 5.1e5 (35 m/s), and
/// extrapolated beyond.</para>
/// </remarks>
public sealed record DragCurve
{
    /// <summary>The diameter of the balls in the tunnel divided by the viscosity of its air, in s/m.</summary>
    private const double TunnelScale = 0.22 / 1.5139322873757089e-5;

    /// <summary>The highest wind speed in the tunnel, in m/s.</summary>
    private const double TunnelFastest = 35.0;

    /// <summary>a, the drag coefficient below the crisis. 0.01 … 2; default 0.49.</summary>
    /// <remarks>The default is derived: the mean of Tango 12, Teamgeist and Brazuca, rounded.</remarks>
    public double Subcritical { get; init; } = 0.49;

    /// <summary>Re_c, the Reynolds number of the crisis. 80 000 … 600 000; default 186 000.</summary>
    /// <remarks>The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double CriticalReynolds { get; init; } = 186_000;

    /// <summary>Re_s, the width of the crisis. 10 000 … 100 000; default 17 000.</summary>
    /// <remarks>The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double Width { get; init; } = 17_000;

    /// <summary>b₀, the drag coefficient just above the crisis. 0.01 … 2; default 0.155.</summary>
    /// <remarks>The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double Supercritical { get; init; } = 0.155;

    /// <summary>b₁, the drag coefficient at <see cref="RiseTo"/>. Default 0.185.</summary>
    /// <remarks>The range is from <see cref="Supercritical"/> to twice that value. The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double Risen { get; init; } = 0.185;

    /// <summary>Re₀, the Reynolds number above which drag rises again. 80 000 … 600 000; default 230 000.</summary>
    /// <remarks>The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double RiseFrom { get; init; } = 230_000;

    /// <summary>Re₁, the Reynolds number at which drag has risen to <see cref="Risen"/>. Default 510 000.</summary>
    /// <remarks>The value must be at least <see cref="RiseFrom"/> + <see cref="Width"/>. The default is derived as for <see cref="Subcritical"/>.</remarks>
    public double RiseTo { get; init; } = 510_000;

    /// <summary>A generic ball: the mean of Tango 12, Teamgeist and Brazuca, rounded.</summary>
    /// <remarks>The values are derived. The rounding was chosen to reproduce Hong and Asai's four drag coefficients and the flight reported by Mencke
    /// et al.</remarks>
    internal static DragCurve Generic { get; } = new();

    /// <summary>Tango 12: crisis at 12.86 m/s (measured: Kiratidis and Leinweber).</summary>
    internal static DragCurve Tango12 { get; } = OfTunnelSpeeds(0.5452, 12.86, 1.304, 0.1657, 0.1953, 16.22);

    /// <summary>Teamgeist: crisis at 12.58 m/s (measured: Kiratidis and Leinweber).</summary>
    internal static DragCurve Teamgeist { get; } = OfTunnelSpeeds(0.4927, 12.58, 1.071, 0.1440, 0.1540, 23.17);

    /// <summary>Jabulani: crisis at 18.69 m/s (measured: Kiratidis and Leinweber).</summary>
    internal static DragCurve Jabulani { get; } = OfTunnelSpeeds(0.4839, 18.69, 1.377, 0.1413, 0.1780, 23.29);

    /// <summary>Brazuca: crisis at 12.92 m/s (measured: Kiratidis and Leinweber).</summary>
    internal static DragCurve Brazuca { get; } = OfTunnelSpeeds(0.4740, 12.92, 1.000, 0.1657, 0.2112, 14.61);

    /// <summary>A present-day ball in match play: roughness 0.86, crisis at Re 95 000 (6.5 m/s at sea level).</summary>
    /// <remarks>
    /// The curve was measured on the flights in one minute of a match in 2024, at 2 600 m. A second minute gives 85 000 … 110 000. The measurement cannot
    /// separate the effects of the ball, its spin and the air in the stadium.
    /// </remarks>
    internal static DragCurve Modern { get; } = OfRoughness(0.86);

    /// <summary>Telstar 18 (derived): its crisis is at 2.7/2.3 of Brazuca's (Asai and Hong 2021), and its range 8 … 10 % below (Goff, Hong and Asai 2018, press).</summary>
    internal static DragCurve Telstar18 { get; } =
        Brazuca with { CriticalReynolds = 220_000, Width = 17_000, Supercritical = 0.202, Risen = 0.258, RiseFrom = 250_000 };

    /// <summary>Flight 2020 (guess). Measured is only: an earlier crisis and slightly more drag than a ball of 32 panels (Asai and Hong 2021).</summary>
    internal static DragCurve Flight2020 { get; } =
        OfRoughness(0) with { CriticalReynolds = 170_000, Width = 15_000, Supercritical = 0.165, Risen = 0.200, RiseFrom = 211_000 };

    /// <summary>Fussballliebe (guess). Measured is only: the shortest flight of ten balls, and an earlier crisis (KJSS 35(2):392, 2024).</summary>
    internal static DragCurve Fussballliebe { get; } =
        OfRoughness(0) with { CriticalReynolds = 160_000, Width = 14_500, Supercritical = 0.215, Risen = 0.270, RiseFrom = 198_000 };

    /// <summary>Trionda: the crisis is measured; the drag above it is a guess (more drag at speed, a few metres short: press).</summary>
    internal static DragCurve Trionda { get; } = OfRoughness(0.35) with { Supercritical = 0.175, Risen = 0.222 };

    /// <summary>A smooth sphere (derived from Achenbach 1972): a late crisis, and little drag above it.</summary>
    internal static DragCurve SmoothSphere { get; } =
        Generic with { CriticalReynolds = 340_000, Width = 22_000, Supercritical = 0.10, Risen = 0.20, RiseFrom = 420_000 };

    /// <summary>The Reynolds number of the crisis of the smoothest match ball.</summary>
    private const double SmoothCrisis = 272_000;

    /// <summary>The minimum Reynolds number of a crisis.</summary>
    internal const double LeastCriticalReynolds = 80_000;

    /// <summary>The minimum width of a crisis.</summary>
    internal const double LeastWidth = 10_000;

    internal const double MostWidth = 100_000;
    internal const double MostReynolds = 600_000;

    /// <summary>Returns the curve with its crisis at another Reynolds number; width and rise scale in proportion.</summary>
    internal DragCurve WithCrisisAt(double reynolds)
    {
        // Clamp to the ranges of Validate, so that the result is always valid.
        double moved = Math.Min(MostReynolds, Math.Max(LeastCriticalReynolds, reynolds));
        double share = moved / CriticalReynolds;
        double width = Math.Min(MostWidth, Math.Max(LeastWidth, share * Width));
        double riseFrom = Math.Min(MostReynolds, Math.Max(LeastCriticalReynolds, share * RiseFrom));
        return this with
        {
            CriticalReynolds = moved,
            Width = width,
            RiseFrom = riseFrom,
            RiseTo = Math.Max(RiseTo, riseFrom + width),
        };
    }

    /// <summary>Returns the curve of a ball with a given roughness.</summary>
    /// <remarks>
    /// The rougher the ball and the more turbulent the air, the earlier the crisis: ρ moves the crisis.
    /// Re_c = 272 000 · (80 000/272 000)^ρ; Re_s = 0.075 Re_c (1 + 1.3 ρ²), at least 10 000; b₀ = 0.141 + 0.022 ρ, b₁ = b₀ + 0.03; Re₀ = 1.24 Re_c; a = 0.49.
    /// <para>b₀ is a guess (slope 0.02 ± 0.03), because drag above the crisis does not follow roughness (Ward et al. 2023).</para>
    /// <para>The wind-tunnel balls have a derived roughness of 0 (Jabulani), 0.30 (Brazuca, Tango 12) and 0.32 (Teamgeist). Above that, up to
    /// <see cref="Modern"/>, the curve is fitted to the flights of one match.
    /// Wider seams make a ball rougher; this is the strongest effect (measured, Hong, Goff and Asai 2020). Deeper seams, texture and wear also make it rougher
    /// (measured: the crisis moves with use, Appl. Sci. 11, 7204, 2021). Spin and turbulence act like roughness (known for spheres); their shares are a
    /// guess.</para>
    /// </remarks>
    /// <param name="roughness">ρ, 0 … 1. 0: the smoothest match ball; 0.3: a ball with few panels in still air; 1: a worn, spinning ball in turbulent air.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="roughness"/> is out of range.</exception>
    public static DragCurve OfRoughness(double roughness)
    {
        Check.Within(nameof(roughness), roughness, 0, 1);

        // Geometric interpolation between the two crises.
        double critical = SmoothCrisis * Elementary.Exp(roughness * Elementary.Log(LeastCriticalReynolds / SmoothCrisis));
        double supercritical = 0.141 + (0.022 * roughness);
        return new DragCurve
        {
            Subcritical = 0.49,
            CriticalReynolds = critical,
            Width = Math.Max(LeastWidth, 0.075 * critical * (1.0 + (1.3 * roughness * roughness))),
            Supercritical = supercritical,
            Risen = supercritical + 0.03,
            RiseFrom = 1.24 * critical,
            RiseTo = TunnelScale * TunnelFastest,
        };
    }

    internal void Validate()
    {
        SceneFields.Check(SceneFields.Drag, this, "ball.dragCurve.");
        Check.Within("ball.dragCurve.risen", Risen, Supercritical, 2 * Supercritical);
        Check.AtLeast("ball.dragCurve.riseTo", RiseTo, RiseFrom + Width);
    }

    /// <summary>Creates a curve from a row of the fit, which is given in wind speeds of the tunnel, m/s.</summary>
    private static DragCurve OfTunnelSpeeds(
        double subcritical, double criticalSpeed, double width, double supercritical, double risen, double riseFrom) => new()
        {
            Subcritical = subcritical,
            CriticalReynolds = TunnelScale * criticalSpeed,
            Width = TunnelScale * width,
            Supercritical = supercritical,
            Risen = risen,
            RiseFrom = TunnelScale * riseFrom,
            RiseTo = TunnelScale * TunnelFastest,
        };
}
