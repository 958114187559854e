namespace Football.Physics;

/// <summary>
/// The drag coefficient of a ball without spin by Reynolds number, measured in wind tunnels through the drag crisis
/// (Kiratidis and Leinweber, arXiv:1710.02784).
/// </summary>
internal sealed class ReynoldsDrag
{
    /// <summary>Diameter of the balls in the tunnel over the viscosity of its air: what turns the fit's m/s into Reynolds numbers, s/m.</summary>
    private const double TunnelScale = 0.22 / 1.5139322873757089e-5;

    private readonly double _subcritical; // a
    private readonly double _criticalReynolds; // Re_c
    private readonly double _perWidth; // 1/Re_s
    private readonly double _supercritical; // b₀
    private readonly double _riseFrom; // Re₀
    private readonly double _slope; // (b₁ − b₀)/(Re₁ − Re₀)

    private ReynoldsDrag(
        double subcritical,
        double criticalReynolds,
        double width,
        double supercritical,
        double later,
        double riseFrom,
        double riseTo)
    {
        _subcritical = subcritical;
        _criticalReynolds = criticalReynolds;
        _perWidth = 1.0 / width;
        _supercritical = supercritical;
        _riseFrom = riseFrom;
        _slope = (later - supercritical) / (riseTo - riseFrom);
    }

    /// <summary>Tango 12 (measured).</summary>
    public static ReynoldsDrag Tango12 { get; } = OfTunnelSpeeds(0.5452, 12.86, 1.304, 0.1657, 0.1953, 16.22);

    /// <summary>Teamgeist (measured).</summary>
    public static ReynoldsDrag Teamgeist { get; } = OfTunnelSpeeds(0.4927, 12.58, 1.071, 0.1440, 0.1540, 23.17);

    /// <summary>Jabulani (measured).</summary>
    public static ReynoldsDrag Jabulani { get; } = OfTunnelSpeeds(0.4839, 18.69, 1.377, 0.1413, 0.1780, 23.29);

    /// <summary>Brazuca (measured).</summary>
    public static ReynoldsDrag Brazuca { get; } = OfTunnelSpeeds(0.4740, 12.92, 1.000, 0.1657, 0.2112, 14.61);

    /// <summary>No ball in particular: the mean of the four without Jabulani, rounded (derived).</summary>
    public static ReynoldsDrag Generic { get; } = new(0.49, 186_000, 17_000, 0.155, 0.185, 230_000, 510_000);

    /// <summary>q = σ((Re − Re_c)/Re_s), the share of the subcritical flow: 1 slow, 0 fast.</summary>
    public double SubcriticalShare(double reynolds) => Elementary.Logistic((_criticalReynolds - reynolds) * _perWidth);

    /// <summary>C_D = (a − b₀) q + b₀ + (Re − Re₀) σ(−(Re − Re₀)/Re_s) (b₁ − b₀)/(Re₁ − Re₀).</summary>
    public double Coefficient(double reynolds)
    {
        double beyond = reynolds - _riseFrom;
        return ((_subcritical - _supercritical) * SubcriticalShare(reynolds)) + _supercritical
            + (beyond * Elementary.Logistic(beyond * _perWidth) * _slope);
    }

    /// <summary>An upper bound for C_D up to a Reynolds number: it rises without end.</summary>
    public double Largest(double reynolds) => _subcritical + (Math.Max(0, reynolds - _riseFrom) * _slope);

    /// <summary>A row of the fit, whose rise is given up to 35 m/s.</summary>
    private static ReynoldsDrag OfTunnelSpeeds(
        double subcritical, double criticalSpeed, double width, double supercritical, double later, double riseFrom) =>
        new(subcritical, TunnelScale * criticalSpeed, TunnelScale * width, supercritical, later, TunnelScale * riseFrom, TunnelScale * 35.0);
}
