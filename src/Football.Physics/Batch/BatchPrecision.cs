namespace Football.Physics;

/// <summary>With which numbers the balls of a batch are flown.</summary>
public enum BatchPrecision
{
    /// <summary>
    /// Floats with compensated sums, several balls at once in wide registers. From the single ball's landing at the same step typically 1e-6 m,
    /// 99 % of footballers' shots within 1e-5 m (2e-5 m over 100 m without air). The published drag law's jump is located where a step
    /// begins and ends on different sides of it; the one shot in some hundred that only grazes it, or slides along it, is up to 1 mm off with
    /// steps of 10 ms, 5 cm with 20 to 40 ms. Spins above 60 rad/s: 95 % within 2e-4 m.
    /// </summary>
    Single = 0,

    /// <summary>The single ball itself, one by one: its bits.</summary>
    Double = 1,
}
