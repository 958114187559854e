namespace FootballPhysics.Labs;

/// <summary>A number of a kick that somebody measured or told.</summary>
/// <param name="Name">The kick.</param>
/// <param name="Number">What of it.</param>
/// <param name="Told">The number; null where none is known.</param>
/// <param name="Within">How near it is near.</param>
/// <param name="Of">The number in a scene.</param>
/// <param name="WhyNot">Why it is not met, as far as is known.</param>
internal sealed record ToldKick(string Name, string Number, double? Told, double Within, Func<Scene, double> Of, string? WhyNot = null)
{
    public string? Verdict(double value) => Told is { } told ? Math.Abs(value - told) <= Within ? "met" : "NOT MET" : null;
}
