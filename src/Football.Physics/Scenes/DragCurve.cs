namespace FootballPhysics.Laws;

/// <summary>
/// Drag coefficient of a ball without spin by Reynolds number Re = 2r|u|/ν, through its drag crisis: the form and the rows of Kiratidis and
/// Leinweber (arXiv:1710.02784), whose wind-tunnel speeds are turned into Reynolds numbers with their viscosity, 1.51393e-5 m²/s, and diameter,
/// 0.22 m.
/// </summary>
/// <remarks>
/// C_D = (a − b₀) q + b₀ + (Re − Re₀) σ(−(Re − Re₀)/Re_s) (b₁ − b₀)/(Re₁ − Re₀) with q = σ((Re − Re_c)/Re_s), σ(x) = 1/(1 + eˣ). Measured up
/// to Re 5.1e5 (35 m/s); beyond, an extrapolation.
/// </remarks>
public sealed record DragCurve
{
    /// <summary>Diameter of the balls in the tunnel over the viscosity of its air, s/m.</summary>
    private const double TunnelScale = 0.22 / 1.5139322873757089e-5;

    /// <summary>The fastest wind in the tunnel, m/s.</summary>
    private const double TunnelFastest = 35.0;

    /// <summary>a, C_D below the drag crisis. 0.01 … 2; default 0.49, derived: mean of Tango 12, Teamgeist and Brazuca, rounded.</summary>
    public double Subcritical { get; init; } = 0.49;

    /// <summary>Re_c, the Reynolds number of the crisis. 80 000 … 600 000; default 186 000, derived as <see cref="Subcritical"/>.</summary>
    public double CriticalReynolds { get; init; } = 186_000;

    /// <summary>Re_s, the width of the crisis. 10 000 … 100 000; default 17 000, derived as <see cref="Subcritical"/>.</summary>
    public double Width { get; init; } = 17_000;

    /// <summary>b₀, C_D just above the crisis. 0.01 … 2; default 0.155, derived as <see cref="Subcritical"/>.</summary>
    public double Supercritical { get; init; } = 0.155;

    /// <summary>b₁, C_D at <see cref="RiseTo"/>. From <see cref="Supercritical"/> to twice that; default 0.185, derived as <see cref="Subcritical"/>.</summary>
    public double Risen { get; init; } = 0.185;

    /// <summary>Re₀, from where on C_D rises again. 80 000 … 600 000; default 230 000, derived as <see cref="Subcritical"/>.</summary>
    public double RiseFrom { get; init; } = 230_000;

    /// <summary>Re₁, where it has risen to <see cref="Risen"/>. At least <see cref="RiseFrom"/> + <see cref="Width"/>; default 510 000, derived as <see cref="Subcritical"/>.</summary>
    public double RiseTo { get; init; } = 510_000;

    /// <summary>No ball in particular (derived: the mean of Tango 12, Teamgeist and Brazuca, rounded so that Hong and Asai's four C_D and Mencke's flight hold).</summary>
    public static DragCurve Generic { get; } = new();

    /// <summary>Tango 12 (measured: Kiratidis and Leinweber; crisis at 12.86 m/s).</summary>
    public static DragCurve Tango12 { get; } = OfTunnelSpeeds(0.5452, 12.86, 1.304, 0.1657, 0.1953, 16.22);

    /// <summary>Teamgeist (measured: Kiratidis and Leinweber; crisis at 12.58 m/s).</summary>
    public static DragCurve Teamgeist { get; } = OfTunnelSpeeds(0.4927, 12.58, 1.071, 0.1440, 0.1540, 23.17);

    /// <summary>Jabulani (measured: Kiratidis and Leinweber; crisis at 18.69 m/s).</summary>
    public static DragCurve Jabulani { get; } = OfTunnelSpeeds(0.4839, 18.69, 1.377, 0.1413, 0.1780, 23.29);

    /// <summary>Brazuca (measured: Kiratidis and Leinweber; crisis at 12.92 m/s).</summary>
    public static DragCurve Brazuca { get; } = OfTunnelSpeeds(0.4740, 12.92, 1.000, 0.1657, 0.2112, 14.61);

    /// <summary>
    /// A ball of today as it flies in a match (roughness 0.86: crisis at Re 95 000, 6.5 m/s at sea level). Measured on the flights of one minute of one match in 2024, at 2 600 m; a second
    /// minute has it between 85 000 and 110 000. What of it is the ball, its spin or the stadium's air, that cannot tell.
    /// </summary>
    public static DragCurve Modern { get; } = OfRoughness(0.86);

    /// <summary>Re_c of the smoothest match ball.</summary>
    private const double SmoothCrisis = 272_000;

    /// <summary>The least Reynolds number that a crisis may have.</summary>
    internal const double LeastCriticalReynolds = 80_000;

    /// <summary>The least width that a crisis may have.</summary>
    internal const double LeastWidth = 10_000;

    internal const double MostWidth = 100_000;
    internal const double MostReynolds = 600_000;

    /// <summary>The curve with its crisis elsewhere: its width, and where drag rises again, in proportion.</summary>
    internal DragCurve WithCrisisAt(double reynolds)
    {
        // Kept within the ranges that Validate allows: the result is always a curve.
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

    /// <summary>The curve of a ball by how rough it is: the crisis comes earlier, and drag above it is higher, the rougher the ball and the more turbulent the air.</summary>
    /// <remarks>
    /// Re_c = 272 000 · (80 000/272 000)^ρ; Re_s = 0.075 Re_c (1 + 1.3 ρ²); b₀ = 0.141 + 0.022 ρ, b₁ = b₀ + 0.03; Re₀ = 1.24 Re_c; a = 0.49. Between the rows of the tunnel, of
    /// which ρ is 0 (Jabulani), 0.30 (Brazuca, Tango 12) and 0.32 (Teamgeist), derived; beyond, up to <see cref="Modern"/>, by the flights of one match. What makes a ball rougher:
    /// wider seams (measured: the strongest of all, Hong, Goff and Asai 2020) and deeper ones, texture, wear (measured: the crisis moves with use, Appl. Sci. 11, 7204, 2021); spin
    /// and the turbulence in a stadium do the same as roughness does (known of spheres; how much of it each has, guess).
    /// </remarks>
    /// <param name="roughness">ρ: 0 as smooth as any match ball was, 0.3 a ball with few panels in a wind tunnel's still air, 1 worn, spinning, in turbulent air.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="roughness"/> is out of range.</exception>
    public static DragCurve OfRoughness(double roughness)
    {
        Check.Within(nameof(roughness), roughness, 0, 1);

        // Geometric between the two crises: 272 000 (80 000/272 000)^ρ.
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

    /// <summary>A row of the fit, in m/s of the tunnel's wind.</summary>
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
