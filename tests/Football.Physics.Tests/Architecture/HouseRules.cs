namespace FootballPhysics.Tests.Architecture;

/// <summary>What the house rules ask of the text of a source tree, and where it is broken.</summary>
internal static class HouseRules
{
    public const int LongestFile = 450;
    public const int LongestType = 600;
    public const int LongestMethod = 80;

    private static readonly string[] s_kinds = ["class", "struct", "interface", "enum", "record", "namespace"];

    /// <summary>The only file of tolerances in the folders that move a ball.</summary>
    public const string Tolerances = "Contacts/ContactTolerances.cs";

    /// <summary>Files of those folders with small numbers of another kind, and the reason.</summary>
    public static IReadOnlyDictionary<string, string> OtherSmallNumbers { get; } = new Dictionary<string, string>
    {
        ["Integration/EventLocator.cs"] = "rounding of a time on a step, whatever the event is",
        ["Integration/PathSegment.cs"] = "rounding of a time on a path that a game queries",
        ["Simulation/DragJumpGuard.cs"] = "the jump of the drag law",
        ["Simulation/FlightPhase.cs"] = "the jump of the drag law",
        ["Simulation/OwnForceGuard.cs"] = "accuracy of a step under custom forces",
        ["Simulation/SolverSettings.cs"] = "the default of a setting",
        ["Simulation/StabilityLimit.cs"] = "stability and accuracy of a step",
        ["Simulation/ZoneSearch.cs"] = "zones, which no ball touches",
    };

    public static IReadOnlyList<string> LongFiles(IReadOnlyList<SourceFile> tree) =>
        [.. tree.Where(file => file.Lines > LongestFile).Select(file => $"{file.Path}: {file.Lines} lines")];

    /// <summary>The parts of a type are summed.</summary>
    public static IReadOnlyList<string> LongTypes(IReadOnlyList<SourceFile> tree) =>
    [
        .. from file in tree
           from type in file.Types
           group type.LastLine - type.FirstLine + 1 by (Folder(file), type.Name) into parts
           where parts.Sum() > LongestType
           select $"{parts.Key.Name}: {parts.Sum()} lines in {parts.Count()} parts",
    ];

    /// <summary>Methods, with their attributes, of more lines than the limit.</summary>
    public static IReadOnlyList<string> LongMethods(IReadOnlyList<SourceFile> tree)
    {
        var found = new List<string>();
        foreach (SourceFile file in tree)
        {
            int start = 0;
            for (int i = 0; i < file.Tokens.Count; i++)
            {
                if (Text(file, i) is ";" or "}" || (Text(file, i) == "{" && DeclaresType(file, start, i)))
                {
                    start = i + 1;
                }
                else if (Text(file, i) == "{")
                {
                    i = Closing(file, i, "{", "}");
                    int lines = file.Tokens[i].Line - file.Tokens[start].Line + 1;
                    if (lines > LongestMethod)
                    {
                        found.Add($"{file.Path}({file.Tokens[start].Line}): {lines} lines");
                    }

                    start = i + 1;
                }
            }
        }

        return found;
    }

    /// <summary>True if the tokens before a brace declare a type or a namespace. A constraint such as "where T : struct" does not.</summary>
    private static bool DeclaresType(SourceFile file, int from, int brace) =>
        Enumerable.Range(from, Math.Max(0, brace - from - 1)).Any(i => s_kinds.Contains(Text(file, i)) && file.Tokens[i + 1].IsWord);

    /// <summary>typeof(…) == or != something: a question that a type parameter's own members answer.</summary>
    public static IReadOnlyList<string> QuestionsOfType(IReadOnlyList<SourceFile> tree)
    {
        var found = new List<string>();
        foreach (SourceFile file in tree)
        {
            for (int i = 0; i < file.Tokens.Count; i++)
            {
                if (Text(file, i) != "typeof")
                {
                    continue;
                }

                int end = Closing(file, i + 1, "(", ")");
                bool asksAfter = Text(file, end + 1) is "=" or "!" && Text(file, end + 2) == "=";
                bool asksBefore = Text(file, i - 1) == "=" && Text(file, i - 2) is "=" or "!";
                if (asksAfter || asksBefore)
                {
                    found.Add($"{file.Path}({file.Tokens[i].Line}): asks for a type");
                }
            }
        }

        return found;
    }

    /// <summary>
    /// Read-only spans in the rooms that every step runs through. The getter of their items has a modifier in its signature that Unity's older Mono
    /// does not know: it throws a <see cref="MissingMethodException"/> when the method that calls it is compiled.
    /// </summary>
    public static IReadOnlyList<string> ReadOnlySpans(IReadOnlyList<SourceFile> tree) =>
    [
        .. from file in tree
           where Folder(file).Split('/')[0] is "Laws" or "Contacts" or "Integration" or "Numerics" or "Simulation" or "State"
           from token in file.Tokens
           where token.Text == "ReadOnlySpan"
           select $"{file.Path}({token.Line}): use Span",
    ];

    /// <summary>Numbers of 1e-4 and less in the folders that move a ball, outside the file of tolerances and the files with a reason of their own.</summary>
    public static IReadOnlyList<string> LooseTolerances(IReadOnlyList<SourceFile> tree) =>
    [
        .. from file in tree
           where file.Room is "Contacts" or "Integration" or "Simulation" && file.Path != Tolerances && !OtherSmallNumbers.ContainsKey(file.Path)
           from i in Enumerable.Range(0, file.Tokens.Count)
           where IsSmall(file, i)
           select $"{file.Path}({file.Tokens[i].Line}): {Text(file, i)}-{Text(file, i + 2)} belongs to {Tolerances}",
    ];

    /// <summary>Numbers of four or more digits, such as those of a law, that several files contain. The folder Numerics counts as one file.</summary>
    public static IReadOnlyList<string> RepeatedNumbers(IReadOnlyList<SourceFile> tree) =>
    [
        .. from file in tree
           from i in Enumerable.Range(0, file.Tokens.Count)
           where Text(file, i + 1) == "." && char.IsDigit(Text(file, i)[0]) && Text(file, i + 2) is [>= '0' and <= '9', ..]
           let number = $"{Text(file, i)}.{Text(file, i + 2)}".TrimEnd('f')
           where number.Replace(".", "").Trim('0').Length >= 4
           group file by number into files
           let paths = files.Select(file => file.Room == "Numerics" ? file.Room : file.Path).Distinct().ToArray()
           where paths.Length > 1
           select $"{files.Key}: {string.Join(", ", paths)}",
    ];

    private static bool IsSmall(SourceFile file, int i) =>
        Text(file, i) is [>= '0' and <= '9', .., 'e' or 'E'] && Text(file, i + 1) == "-" && int.TryParse(Text(file, i + 2), out int power) && power >= 4;

    /// <summary>Switch expressions over an enumeration of the tree whose last arm takes every value to come for one of those that there are.</summary>
    public static IReadOnlyList<string> OpenSwitches(IReadOnlyList<SourceFile> tree)
    {
        HashSet<string> enums = [.. tree.SelectMany(file => file.Types).Where(type => type.Kind == "enum").Select(type => type.Name)];
        var found = new List<string>();
        foreach (SourceFile file in tree)
        {
            for (int i = 0; i < file.Tokens.Count; i++)
            {
                if (Text(file, i) == "switch" && Text(file, i + 1) == "{" && IsOpen(file, i + 1, enums))
                {
                    found.Add($"{file.Path}({file.Tokens[i].Line}): _ => is an answer");
                }
            }
        }

        return found;
    }

    private static bool IsOpen(SourceFile file, int brace, HashSet<string> enums)
    {
        int end = Closing(file, brace, "{", "}");
        bool overEnum = false;
        bool answers = false;
        bool pattern = true;
        for (int i = brace + 1; i < end; i++)
        {
            string text = Text(file, i);
            if (text is "{" or "(" or "[")
            {
                i = Closing(file, i, text, text == "{" ? "}" : text == "(" ? ")" : "]");
            }
            else if (text == ",")
            {
                pattern = true;
            }
            else if (text == "=" && Text(file, i + 1) == ">")
            {
                answers |= Text(file, i - 1) == "_" && Text(file, i + 2) != "throw";
                pattern = false;
            }
            else
            {
                overEnum |= pattern && enums.Contains(text) && Text(file, i + 1) == ".";
            }
        }

        return overEnum && answers;
    }

    /// <summary>Where the bracket closes that opens at a place.</summary>
    private static int Closing(SourceFile file, int from, string open, string close)
    {
        int depth = 0;
        for (int i = from; i < file.Tokens.Count; i++)
        {
            depth += Text(file, i) == open ? 1 : Text(file, i) == close ? -1 : 0;
            if (depth == 0)
            {
                return i;
            }
        }

        return file.Tokens.Count - 1;
    }

    private static string Text(SourceFile file, int i) => i >= 0 && i < file.Tokens.Count ? file.Tokens[i].Text : "";

    private static string Folder(SourceFile file) => file.Path[..(file.Path.LastIndexOf('/') + 1)];
}
