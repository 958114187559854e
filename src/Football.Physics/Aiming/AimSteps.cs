namespace Football.Physics;

/// <summary>How long the steps are in which an aim flies its kicks, s: each as long as its question allows.</summary>
internal readonly struct AimSteps
{
    /// <summary>Miss distance from which on the rough step will do, m.</summary>
    private const double RoughMiss = 5e-4;

    private AimSteps(double search, double hit, double roughHit, double rehearsedHit, double? roll, bool areShort)
    {
        Search = search;
        Hit = hit;
        RoughHit = roughHit;
        RehearsedHit = rehearsedHit;
        Roll = roll;
        AreShort = areShort;
    }

    /// <summary>With RK4: a search within 1e-4 m, a hit with the drag law's jump located within 1e-5 m, a rough one within 1e-4 m, a rehearsed one within 5e-4 m.</summary>
    public static AimSteps Long => new(search: 0.25, hit: 0.1, roughHit: 0.2, rehearsedHit: 0.3, roll: 2.0, areShort: false);

    /// <summary>For a kick that grazes the drag law's jump, so that longer steps were wrong about it.</summary>
    public static AimSteps Short => new(search: 0.02, hit: 0.02, roughHit: 0.02, rehearsedHit: 0.02, roll: null, areShort: true);

    /// <summary>Of flights that only look where a kick goes.</summary>
    public double Search { get; }

    /// <summary>Of flights from which a hit is said.</summary>
    public double Hit { get; }

    /// <summary>Of a roll of which only the direction counts; null where none may be as rough as that.</summary>
    public double? Roll { get; }

    /// <summary>Whether they are the short ones: longer steps were wrong then.</summary>
    public bool AreShort { get; }

    private double RoughHit { get; }

    private double RehearsedHit { get; }

    /// <summary>Of flights from which a miss distance of a size is to be known.</summary>
    public double HitWithin(double miss) => miss >= RoughMiss ? RoughHit : Hit;

    /// <summary>Of flights that show by how little a rehearsed kick misses, which is then corrected.</summary>
    public double RehearsedWithin(double miss) => miss >= RoughMiss ? RehearsedHit : Hit;
}
