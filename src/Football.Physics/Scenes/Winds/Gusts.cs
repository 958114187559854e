namespace FootballPhysics.Laws;

/// <summary>Gusts of a wind: turbulence of a Dryden spectrum, drifting with the mean wind; a pure function of seed, place and time.</summary>
public sealed record Gusts
{
    /// <summary>The seed: another one, other gusts of the same strength. Any; default 0.</summary>
    public long Seed { get; init; }

    /// <summary>
    /// Standard deviation along the wind over the wind at the reference height; across it 0.8 of that, upwards 0.5. 0 … 1; default 0.18 (guess: open
    /// grassland at 10 m).
    /// </summary>
    public double Intensity { get; init; } = 0.18;

    /// <summary>Length L of the largest gusts, m. 1 … 1000; default 40 (guess).</summary>
    public double Length { get; init; } = 40;

    internal void Validate()
    {
        Check.Within("air.wind.gusts.intensity", Intensity, 0, 1);
        Check.Within("air.wind.gusts.length", Length, 1, 1000);
    }
}
