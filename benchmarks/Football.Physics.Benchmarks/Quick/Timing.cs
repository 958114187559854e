namespace FootballPhysics.Benchmarks;

/// <summary>Medians of alternating rounds.</summary>
/// <param name="Nanoseconds">Median time of the subject, ns an operation.</param>
/// <param name="YardstickNanoseconds">The same of the yardstick.</param>
/// <param name="Ratio">Median of the rounds' ratios.</param>
/// <param name="Bytes">Bytes that the subject allocates an operation.</param>
internal sealed record Timing(double Nanoseconds, double YardstickNanoseconds, double Ratio, double Bytes);
