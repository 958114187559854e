namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A ball that several surfaces touch".</summary>
/// <param name="Name">What touches it, how it moves, and the method.</param>
/// <param name="Integrator">The method.</param>
/// <param name="Subject">Makes the case.</param>
internal sealed record ContactRow(string Name, Integrator Integrator, Func<ContactCase> Subject);
