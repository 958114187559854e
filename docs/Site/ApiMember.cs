using System.Text.RegularExpressions;

namespace FootballPhysics.Site;

/// <summary>A member of a type, read from its signature in the API reference.</summary>
/// <param name="Group">The heading under which its type lists it.</param>
/// <param name="Name">Its name; all overloads share it.</param>
/// <param name="Id">Its anchor: the name and the types of its parameters, so that a new overload changes no anchor.</param>
internal sealed partial record ApiMember(string Group, string Name, string Id)
{
    /// <summary>Reads a signature.</summary>
    public static ApiMember Of(string signature)
    {
        Match parts = Signature().Match(signature);
        string before = parts.Groups["before"].Value;
        string name = parts.Groups["name"].Value;
        string tail = parts.Groups["tail"].Value;
        if (!parts.Success)
        {
            throw new FormatException($"docs/api.md has a signature of an unknown form: {signature}");
        }

        if (before == "new ")
        {
            name = "new";
        }

        string group = name == "new" ? "Constructors"
            : name.StartsWith("operator ", StringComparison.Ordinal) ? "Operators"
            : tail.StartsWith('(') ? "Methods"
            : tail.EndsWith('}') ? "Properties"
            : before.StartsWith("event ", StringComparison.Ordinal) ? "Events"
            : before.Length == 0 ? "Values"
            : "Fields";
        return new ApiMember(group, name, string.Join('-', [name.Replace(' ', '-'), .. Types(tail)]));
    }

    /// <summary>The anchor that all overloads share; it is at the first of them.</summary>
    public string ShortId => Name.Replace(' ', '-');

    /// <summary>Where the name is in a signature; the words before and after it are types, keywords and parameters.</summary>
    public static int NameIn(string signature) => Signature().Match(signature).Groups["name"].Index;

    /// <summary>The types of the parameters as words of an anchor.</summary>
    private static IEnumerable<string> Types(string tail)
    {
        string parameters = Parameters().Match(tail).Groups[1].Value;
        return parameters.Length == 0 ? []
            : Commas().Split(parameters).Select(parameter => NotWord().Replace(Type().Match(parameter).Groups[1].Value.Replace("[]", " array", StringComparison.Ordinal), "-").Trim('-'));
    }

    [GeneratedRegex(@"^(?<before>(?:.*? )?)(?<name>operator \w+|\w+)(?:<[\w, ]+>)?(?<tail>\(.*\)|\[.*\] \{.*\}| \{.*\}| = .*)?$")]
    private static partial Regex Signature();

    [GeneratedRegex(@"^[(\[](.*)[)\]]")]
    private static partial Regex Parameters();

    /// <summary>A comma between parameters, not between the arguments of a generic type.</summary>
    [GeneratedRegex(", (?![^<]*>)")]
    private static partial Regex Commas();

    [GeneratedRegex(@"^(?:in |out |ref )?(.*?) \w+(?: = .*)?$")]
    private static partial Regex Type();

    [GeneratedRegex(@"\W+")]
    private static partial Regex NotWord();
}
