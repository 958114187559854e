namespace FootballPhysics.Tests.Architecture;

/// <summary>The rooms of the library, and who names what he must not know.</summary>
internal static class Rooms
{
    /// <summary>Each knows itself and those before it. A folder inside a room belongs to that.</summary>
    public static IReadOnlyList<string> Order { get; } =
    [
        "Polyfills",
        "Numerics",
        "State",
        "Scenes",
        "Laws",
        "Integration",
        "Contacts",
        "Events",
        "Simulation",
        "Prediction",
        "Aiming",
        "Game",
        "Thesis",
        "Tracks",
        "Batch",
        "Engines",
    ];

    /// <summary>Every place where a file names a type of a room above its own, and every file that is in no room.</summary>
    public static IReadOnlyList<string> Violations(IReadOnlyList<SourceFile> tree)
    {
        var violations = new List<string>();
        var rooms = new Dictionary<string, string>();
        foreach (SourceFile file in tree)
        {
            if (!Order.Contains(file.Room))
            {
                violations.Add($"{file.Path}: in none of the rooms");
            }

            foreach (DeclaredType type in file.Types)
            {
                rooms[type.Name] = file.Room;
            }
        }

        foreach (SourceFile file in tree)
        {
            for (int i = 0; i < file.Tokens.Count; i++)
            {
                CodeToken token = file.Tokens[i];
                if (rooms.TryGetValue(token.Text, out string? room) && Height(room) > Height(file.Room) && NamesType(file, i))
                {
                    violations.Add($"{file.Path}({token.Line}): {file.Room} names {token.Text}, which is of {room}");
                }
            }
        }

        return violations;
    }

    private static int Height(string room) => Order.TakeWhile(other => other != room).Count();

    /// <summary>Whether a word that is a type's name stands where a type stands, and is not a member that is called like it.</summary>
    private static bool NamesType(SourceFile file, int i)
    {
        string At(int place) => place >= 0 && place < file.Tokens.Count ? file.Tokens[place].Text : "";
        bool NameAt(int place) => place >= 0 && place < file.Tokens.Count && file.Tokens[place].IsName;
        string before = At(i - 1);
        string after = At(i + 1);
        if (before == "." || IsDeclaredAsMember(file, i))
        {
            return false;
        }

        // new T, T name, T<…>, T[] and T? name are types whatever else is called T.
        bool surely = before is "new" or "is" or "as" or "typeof"
            || (before == "(" && At(i - 2) is "typeof" or "sizeof" or "default")
            || NameAt(i + 1)
            || after == "<"
            || (after == "[" && At(i + 2) == "]")
            || (after == "?" && (NameAt(i + 2) || At(i + 2) is ">" or "," or ")"));

        // <T>, (T)x, : T, T.Member and [T] only where no member has that name.
        return surely || (!HasMember(file, file.Tokens[i].Text)
            && (after == "." || before is "<" or ":" or "[" || after == ">" || (before == "," && after is "{" or "," or "where") || (before == "(" && after == ")")));
    }

    /// <summary>Whether it is the name that is declared here: Speed in double Speed { … }.</summary>
    private static bool IsDeclaredAsMember(SourceFile file, int i) =>
        i > 0 && i + 1 < file.Tokens.Count
        && (file.Tokens[i - 1].IsName || file.Tokens[i - 1].Text is ">" or "]" or "?")
        && file.Tokens[i + 1].Text is "{" or "=" or ";" or "(" or ")" or "," or "<";

    private static bool HasMember(SourceFile file, string name) =>
        Enumerable.Range(0, file.Tokens.Count).Any(i => file.Tokens[i].Text == name && IsDeclaredAsMember(file, i));
}
