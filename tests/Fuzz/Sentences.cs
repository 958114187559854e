namespace FootballPhysics.Fuzz;

/// <summary>The messages for people: one line each, a sentence or the question that names the intended word.</summary>
internal static class Sentences
{
    public static bool Is(string message) => message.Length > 1 && message[^1] is '.' or '?' && !message.Any(char.IsControl);
}
