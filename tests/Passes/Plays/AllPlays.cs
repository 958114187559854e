namespace FootballPhysics.Passes.Plays;

/// <summary>The plays of <see cref="Reach"/>: what games do with the library, by its public interface alone.</summary>
internal static class AllPlays
{
    public static IReadOnlyList<(string Name, Action Play)> Named { get; } =
    [
        ("ball", OneBall.Play),
        ("air", Airs.Play),
        ("crowd", Crowd.Play),
        ("squeezes", Squeezes.Play),
        ("group", Groups.Play),
        ("masses", Masses.Play),
        ("engine", Engine.Play),
        ("nets", NetsAndGoals.Play),
        ("slopes", Slopes.Play),
        ("netcode", Netcodes.Play),
        ("queries", Queries.Play),
        ("hostile", Hostile.Play),
    ];
}
