namespace FootballPhysics.Tests.Architecture;

/// <summary>A word or a sign of code, and its line. Comments, strings, characters and directives are none.</summary>
internal readonly record struct CodeToken(string Text, int Line)
{
    public bool IsWord => char.IsLetter(Text[0]) || Text[0] == '_';

    /// <summary>A word that is not a keyword, or one that stands for a type, like int.</summary>
    public bool IsName => IsWord && (!s_keywords.Contains(Text) || IsBuiltInType);

    public bool IsBuiltInType => s_builtInTypes.Contains(Text);

    private static readonly HashSet<string> s_builtInTypes =
        [.. "bool byte char decimal double float int long object sbyte short string uint ulong ushort void nint nuint var".Split(' ')];

    private static readonly HashSet<string> s_keywords =
    [
        .. s_builtInTypes,
        .. ("abstract and as base break case catch checked class const continue default delegate do else enum event explicit extern false finally fixed for "
            + "foreach goto if implicit in init interface internal is lock namespace new not null operator or out override params private protected public "
            + "readonly ref return sealed sizeof stackalloc static struct switch this throw true try typeof unchecked unsafe using virtual volatile when "
            + "where while with yield").Split(' '),
    ];

    /// <summary>The tokens of a text.</summary>
    public static IReadOnlyList<CodeToken> Of(string text)
    {
        var tokens = new List<CodeToken>();
        int line = 1;
        int i = 0;
        while (i < text.Length)
        {
            char c = text[i];
            int from = i;
            if (char.IsWhiteSpace(c))
            {
                i++;
            }
            else if (c == '#' || At(text, i, "//"))
            {
                i = End(text, i, "\n", 0);
            }
            else if (At(text, i, "/*"))
            {
                i = End(text, i + 2, "*/", 2);
            }
            else if (StringStart(text, i) is { } quote)
            {
                i = StringEnd(text, i, quote);
            }
            else if (c == '\'')
            {
                i = End(text, text[i + 1] == '\\' ? i + 3 : i + 2, "'", 1);
            }
            else
            {
                i++;
                while (IsPartOfWord(c) && i < text.Length && IsPartOfWord(text[i]))
                {
                    i++;
                }

                tokens.Add(new CodeToken(text[from..i], line));
            }

            line += text.AsSpan(from, i - from).Count('\n');
        }

        return tokens;
    }

    private static bool IsPartOfWord(char c) => char.IsLetterOrDigit(c) || c == '_';

    private static bool At(string text, int i, string what) => string.CompareOrdinal(text, i, what, 0, what.Length) == 0;

    private static int End(string text, int from, string mark, int length)
    {
        int at = text.IndexOf(mark, Math.Min(from, text.Length), StringComparison.Ordinal);
        return at < 0 ? text.Length : at + length;
    }

    /// <summary>Where the quotes of a string are that begins here with $ and @; null where none does.</summary>
    private static int? StringStart(string text, int i)
    {
        int quote = i;
        while (quote < text.Length && text[quote] is '$' or '@')
        {
            quote++;
        }

        return quote < text.Length && text[quote] == '"' ? quote : null;
    }

    private static int StringEnd(string text, int from, int quote)
    {
        bool filled = text.AsSpan(from, quote - from).Contains('$');
        bool verbatim = text.AsSpan(from, quote - from).Contains('@');
        if (At(text, quote, "\"\"\""))
        {
            return End(text, quote + 3, "\"\"\"", 3);
        }

        int i = quote + 1;
        while ((i < text.Length && text[i] != '"') || (verbatim && At(text, i, "\"\"")))
        {
            i = verbatim && At(text, i, "\"\"") ? i + 2
                : !verbatim && text[i] == '\\' ? i + 2
                : filled && At(text, i, "{{") ? i + 2
                : filled && text[i] == '{' ? HoleEnd(text, i)
                : i + 1;
        }

        return i + 1;
    }

    /// <summary>The end of what stands in braces in a string, in which there may be strings.</summary>
    private static int HoleEnd(string text, int from)
    {
        int depth = 0;
        int i = from;
        do
        {
            depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
            i = StringStart(text, i) is { } quote ? StringEnd(text, i, quote) : i + 1;
        }
        while (depth > 0 && i < text.Length);
        return i;
    }
}
