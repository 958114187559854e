namespace FootballPhysics.Labs.Following;

/// <summary>The measures of a filter over some tracks.</summary>
internal sealed class FollowScore
{
    /// <summary>The numbers of points after a kick at which errors are measured.</summary>
    public static readonly int[] After = [3, 5, 10];

    public static readonly string[] Quantities = ["position", "velocity", "spin", "ahead"];

    /// <summary>The greatest error that counts, in deviations.</summary>
    private const double Most = 5;

    /// <summary>Squares of errors in the deviations of the oracle, by points after the kick (the last: ahead), of the filter and of the oracle.</summary>
    public double[] Filter { get; } = new double[4];

    public double[] Oracle { get; } = new double[4];

    public int[] Counts { get; } = new int[4];

    public int[] Within1 { get; } = new int[4];

    public int[] Within3 { get; } = new int[4];

    public int[] Covered { get; } = new int[4];

    public int Kicks { get; set; }

    public int Missed { get; set; }

    public int False { get; set; }

    public double Seconds { get; set; }

    /// <summary>Squares of the oracle's errors of the velocity in the deviations of the Cramér–Rao bound.</summary>
    public double[] Bound { get; } = new double[3];

    public int[] BoundCounts { get; } = new int[3];

    public List<string> Falses { get; } = [];

    public void AddError(int at, double filter, double oracle)
    {
        Filter[at] += Math.Pow(Math.Min(Most, filter), 2);
        Oracle[at] += Math.Pow(Math.Min(Most, oracle), 2);
        Counts[at]++;
    }

    /// <summary>The same of kicks into the air only: along the ground, the upward velocity is at the end of its range, where the bound does not hold.</summary>
    public double[] AirBound { get; } = new double[3];

    public int[] AirCounts { get; } = new int[3];

    public void AddBound(int at, double error, bool isInAir)
    {
        double square = Math.Pow(Math.Min(Most, error), 2);
        Bound[at] += square;
        BoundCounts[at]++;
        AirBound[at] += isInAir ? square : 0;
        AirCounts[at] += isInAir ? 1 : 0;
    }

    public double BoundRatio(int at) => at < Bound.Length && BoundCounts[at] > 0 ? Math.Sqrt(Bound[at] / BoundCounts[at]) : double.NaN;

    public double AirBoundRatio(int at) => AirCounts[at] > 0 ? Math.Sqrt(AirBound[at] / AirCounts[at]) : double.NaN;

    public void AddCover(int quantity, Vector3d error, double deviation)
    {
        double ratio = error.Length / Math.Sqrt(3) / deviation;
        Covered[quantity]++;
        Within1[quantity] += ratio <= 1 ? 1 : 0;
        Within3[quantity] += ratio <= 3 ? 1 : 0;
    }

    public double Ratio(int at) => Counts[at] == 0 ? double.NaN : Math.Sqrt(Filter[at] / Oracle[at]);

    public double OracleError(int at) => Counts[at] == 0 ? double.NaN : Math.Sqrt(Oracle[at] / Counts[at]);

    public double Share1(int quantity) => 100.0 * Within1[quantity] / Math.Max(1, Covered[quantity]);

    public double Share3(int quantity) => 100.0 * Within3[quantity] / Math.Max(1, Covered[quantity]);

    public void Add(FollowScore other)
    {
        for (int i = 0; i < 4; i++)
        {
            Filter[i] += other.Filter[i];
            Oracle[i] += other.Oracle[i];
            Counts[i] += other.Counts[i];
            Within1[i] += other.Within1[i];
            Within3[i] += other.Within3[i];
            Covered[i] += other.Covered[i];
        }

        Kicks += other.Kicks;
        Missed += other.Missed;
        False += other.False;
        Seconds += other.Seconds;
        for (int i = 0; i < Bound.Length; i++)
        {
            Bound[i] += other.Bound[i];
            BoundCounts[i] += other.BoundCounts[i];
            AirBound[i] += other.AirBound[i];
            AirCounts[i] += other.AirCounts[i];
        }

        Falses.AddRange(other.Falses);
    }
}
