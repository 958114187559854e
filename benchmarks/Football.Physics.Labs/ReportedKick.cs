namespace FootballPhysics.Labs;

/// <summary>A published number of a kick.</summary>
/// <param name="Name">The kick.</param>
/// <param name="Number">The name of the number.</param>
/// <param name="Reported">The published number; null if none is known.</param>
/// <param name="Within">The tolerance.</param>
/// <param name="Of">Computes the number in a scene.</param>
/// <param name="WhyNot">The known reason for a deviation.</param>
internal sealed record ReportedKick(string Name, string Number, double? Reported, double Within, Func<Scene, double> Of, string? WhyNot = null)
{
    public string? Verdict(double value) => Reported is { } reported ? Math.Abs(value - reported) <= Within ? "met" : "NOT MET" : null;
}
