using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The drag coefficient of a ball without spin as a function of the Reynolds number, through its drag crisis.</summary>
internal readonly struct ReynoldsDrag
{
    private readonly double _subcritical; // a
    private readonly double _criticalReynolds; // Re_c
    private readonly double _perWidth; // 1/Re_s
    private readonly double _supercritical; // b₀
    private readonly double _riseFrom; // Re₀
    private readonly double _slope; // (b₁ − b₀)/(Re₁ − Re₀)

    public ReynoldsDrag(DragCurve curve)
    {
        _subcritical = curve.Subcritical;
        _criticalReynolds = curve.CriticalReynolds;
        _perWidth = 1.0 / curve.Width;
        _supercritical = curve.Supercritical;
        _riseFrom = curve.RiseFrom;
        _slope = (curve.Risen - curve.Supercritical) / (curve.RiseTo - curve.RiseFrom);
    }

    /// <summary>Returns q = σ((Re_c − Re)/Re_s), the share of subcritical flow: 1 at low speed, 0 at high speed.</summary>
    public double SubcriticalShare(double reynolds) => Elementary.Logistic((_criticalReynolds - reynolds) * _perWidth);

    /// <summary>Returns C_D = (a − b₀) q + b₀ + (Re − Re₀) σ(−(Re − Re₀)/Re_s) (b₁ − b₀)/(Re₁ − Re₀).</summary>
    public double Coefficient(double reynolds)
    {
        double beyond = reynolds - _riseFrom;
        return ((_subcritical - _supercritical) * SubcriticalShare(reynolds)) + _supercritical
            + (beyond * Elementary.Logistic(beyond * _perWidth) * _slope);
    }

    /// <summary>Returns an upper bound on C_D up to a Reynolds number; without such a limit C_D is unbounded.</summary>
    public double Largest(double reynolds) => Math.Max(_subcritical, _supercritical) + (Math.Max(0, reynolds - _riseFrom) * _slope);
}
