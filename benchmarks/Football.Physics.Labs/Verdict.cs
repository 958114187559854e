namespace FootballPhysics.Labs;

/// <summary>Reached or missed.</summary>
internal static class Verdict
{
    public static string Of(bool reached) => reached ? "reached" : "MISSED";
}
