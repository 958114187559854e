namespace FootballPhysics.Tests.Architecture;

/// <summary>A type, or a part of one, that a file declares outside of any other.</summary>
/// <param name="Name">Its name, without its type parameters.</param>
/// <param name="Kind">class, struct, interface, enum, record or delegate.</param>
/// <param name="FirstLine">Where its declaration stands.</param>
/// <param name="LastLine">Where it ends.</param>
internal sealed record DeclaredType(string Name, string Kind, int FirstLine, int LastLine)
{
    private static readonly string[] s_kinds = ["class", "struct", "interface", "enum", "record", "delegate"];

    /// <summary>The types of a file.</summary>
    public static IReadOnlyList<DeclaredType> In(IReadOnlyList<CodeToken> tokens)
    {
        var types = new List<DeclaredType>();
        for (int i = 0; i < tokens.Count; i++)
        {
            if (!s_kinds.Contains(tokens[i].Text))
            {
                continue;
            }

            // Names of types start with a capital; those of delegates stand before the parenthesis, behind what they return.
            int name = i + 1;
            while (name < tokens.Count && (tokens[name].Text is "struct" or "class" || (tokens[i].Text == "delegate" && tokens[name + 1].Text is not "(" and not "<")))
            {
                name++;
            }

            int end = BodyEnd(tokens, name);
            types.Add(new DeclaredType(tokens[name].Text, tokens[i].Text, tokens[i].Line, tokens[end].Line));
            i = end;
        }

        return types;
    }

    /// <summary>The closing brace of a declaration, or the semicolon of one without a body.</summary>
    private static int BodyEnd(IReadOnlyList<CodeToken> tokens, int from)
    {
        int depth = 0;
        for (int i = from; i < tokens.Count; i++)
        {
            depth += tokens[i].Text switch
            {
                "{" or "(" => 1,
                "}" or ")" => -1,
                _ => 0,
            };
            if (depth == 0 && tokens[i].Text is "}" or ";")
            {
                return i;
            }
        }

        return tokens.Count - 1;
    }
}
