namespace FootballPhysics.Batch;

/// <summary>With which numbers the balls of a batch are flown.</summary>
public enum BatchPrecision
{
    /// <summary>
    /// Floats with compensated sums, several balls at once in wide registers. With steps up to 20 ms a landing is typically 1e-6 m from the
    /// single ball's at the same step, of 99 % of footballers' shots within 1e-5 m, of all within 1e-4 m (5e-4 m with steps of 40 ms).
    /// The published drag law's jump is located in the step that crosses it. What only grazes it or slides along it, what spins faster than a
    /// surface speed of 14 m/s, and what is beyond 128 m/s or 100 m above the ground, is flown in double.
    /// </summary>
    Single = 0,

    /// <summary>The single ball itself, one by one: its bits.</summary>
    Double = 1,
}
