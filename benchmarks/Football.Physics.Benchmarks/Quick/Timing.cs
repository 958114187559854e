namespace FootballPhysics.Benchmarks;

/// <summary>Medians of alternating rounds.</summary>
/// <param name="Nanoseconds">The median time of the subject, ns per operation.</param>
/// <param name="YardstickNanoseconds">The median time of the yardstick, ns per operation.</param>
/// <param name="Ratio">The median of the rounds' ratios.</param>
/// <param name="Bytes">The number of bytes that the subject allocates per operation.</param>
internal sealed record Timing(double Nanoseconds, double YardstickNanoseconds, double Ratio, double Bytes);
