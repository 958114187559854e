using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Estimates sliding friction and speed-dependent rolling friction from the windows of a match.</summary>
/// <remarks>
/// Slides use a weighted median, because their windows are few and differ. Rolls use a line c₀ + c₁ v, with outliers down-weighted (Huber). Pitches
/// vary from one spot to the next, so the scatter of the windows counts, not only their own standard errors.
/// </remarks>
internal sealed class GroundFriction
{
    /// <summary>The minimum scatter of resistances across a real pitch.</summary>
    private const double SlideScatter = 0.02;
    private const double RollScatter = 0.01;

    /// <summary>Constants of robust statistics: two factors of the median, and the Huber threshold in standard deviations.</summary>
    /// <remarks>
    /// The factors convert a median absolute deviation to a standard deviation, and the standard error of a mean to that of a median.
    /// </remarks>
    internal const double Mad = 1.4826;
    private const double MedianLoss = 1.2533;
    private const double Outlier = 1.5;

    /// <summary>The prior standard deviations of c₀ and c₁ (s/m), about the ground's own values.</summary>
    private const double KnownRolling = 0.1;
    private const double KnownBySpeed = 0.005;

    private const int Rounds = 20;

    private readonly List<Estimate> _estimates = [];

    /// <summary>Estimates the parameters.</summary>
    /// <param name="ground">The prior surface.</param>
    /// <param name="windows">The windows.</param>
    public GroundFriction(Ground ground, List<GroundWindow> windows)
    {
        Ground = ground;
        List<GroundWindow> slides = windows.FindAll(w => w.Motion == MotionState.Sliding);
        List<GroundWindow> rolls = windows.FindAll(w => w.Motion == MotionState.Rolling);
        if (slides.Count > 0)
        {
            FindSliding(slides);
        }

        if (rolls.Count > 0)
        {
            FindRolling(rolls);
        }
    }

    /// <summary>The ground with the estimated frictions.</summary>
    public Ground Ground { get; private set; }

    /// <summary>The estimated parameters.</summary>
    public IReadOnlyList<Estimate> Estimates => _estimates;

    /// <summary>The mean speed of the rolling windows, in m/s; 0 if there are none.</summary>
    public double RollingSpeed { get; private set; }

    /// <summary>The standard deviation of c₀ + c₁ v at this speed.</summary>
    public double RollingDeviation { get; private set; }

    /// <summary>Estimates sliding friction as the weighted median of the slides.</summary>
    private void FindSliding(List<GroundWindow> slides)
    {
        double[] values = [.. slides.Select(w => w.Resistance)];
        double scatter = Math.Max(SlideScatter, Scatter(values, Median(values)));
        slides.Sort((a, b) => a.Resistance.CompareTo(b.Resistance));
        double all = 0;
        foreach (GroundWindow window in slides)
        {
            all += Weight(window, scatter);
        }

        // The weighted median, interpolated between its neighbours.
        double median = slides[^1].Resistance;
        double sum = 0;
        for (int i = 0; i < slides.Count; i++)
        {
            double weight = Weight(slides[i], scatter);
            double next = sum + (0.5 * weight);
            if (next >= 0.5 * all)
            {
                double before = i > 0 ? sum - (0.5 * Weight(slides[i - 1], scatter)) : next;
                double share = next > before ? ((0.5 * all) - before) / (next - before) : 1;
                median = i > 0 ? slides[i - 1].Resistance + (share * (slides[i].Resistance - slides[i - 1].Resistance)) : slides[i].Resistance;
                break;
            }

            sum += weight;
        }

        _estimates.Add(new Estimate("slidingFriction", median, (slides.Count > 2 ? MedianLoss : 1) / Math.Sqrt(all)));
        Ground = Ground with { Material = Ground.Material with { SlidingFriction = median } };
    }

    /// <summary>Estimates c₀ and c₁ by iteratively reweighted least squares, with priors.</summary>
    private void FindRolling(List<GroundWindow> rolls)
    {
        // 1. Start with the prior c₁ and the median c₀. 2. Reweighted least squares for both. 3. Clamp negative values to zero.
        double[] start = [.. rolls.Select(w => w.Resistance - (Ground.Material.RollingResistancePerSpeed * w.Speed))];
        double middle = Median(start);
        double level = middle;
        double growth = Ground.Material.RollingResistancePerSpeed;
        double scatter = Math.Max(RollScatter, Scatter(start, middle));
        double a = 0, b = 0, c = 0;
        for (int round = 0; round < Rounds; round++)
        {
            a = 1 / (KnownRolling * KnownRolling);
            b = 0;
            c = 1 / (KnownBySpeed * KnownBySpeed);
            double x = a * Ground.Material.RollingResistance;
            double y = c * Ground.Material.RollingResistancePerSpeed;
            foreach (GroundWindow window in rolls)
            {
                double weight = Weight(window, scatter);
                double off = Math.Abs(window.Resistance - level - (growth * window.Speed)) * Math.Sqrt(weight);
                weight *= Huber.Weight(off, Outlier);
                a += weight;
                b += weight * window.Speed;
                c += weight * window.Speed * window.Speed;
                x += weight * window.Resistance;
                y += weight * window.Speed * window.Resistance;
            }

            growth = Math.Max(0, ((a * y) - (b * x)) / ((a * c) - (b * b)));
            level = Math.Max(0, (x - (b * growth)) / a);
        }

        double size = (a * c) - (b * b);
        double known = 1 / (KnownRolling * KnownRolling);
        RollingSpeed = b / (a - known);
        RollingDeviation = Math.Sqrt((c - (2 * b * RollingSpeed) + (a * RollingSpeed * RollingSpeed)) / size);
        _estimates.Add(new Estimate("rollingFriction", level, Math.Sqrt(c / size)));
        _estimates.Add(new Estimate("rollingFrictionBySpeed", growth, Math.Sqrt(a / size)));
        Ground = Ground with { Material = Ground.Material with { RollingResistance = level, RollingResistancePerSpeed = growth } };
    }

    private static double Weight(GroundWindow window, double scatter) => 1 / ((window.StandardError * window.StandardError) + (scatter * scatter));

    private static double Scatter(double[] values, double middle) => Mad * Median([.. values.Select(value => Math.Abs(value - middle))]);

    private static double Median(double[] values)
    {
        double[] sorted = (double[])values.Clone();
        Array.Sort(sorted);
        return 0.5 * (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]);
    }
}
