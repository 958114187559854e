using System.Net;
using System.Text.RegularExpressions;

namespace FootballPhysics.Site;

/// <summary>A type of the API reference.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Address">Its anchor in docs/api.md.</param>
/// <param name="Family">The heading under which docs/api.md lists it.</param>
/// <param name="Text">Its section of docs/api.md, without the heading's sign.</param>
/// <param name="Members">Its members, in order.</param>
internal sealed record ApiType(string Name, string Address, string Family, string Text, IReadOnlyList<ApiMember> Members)
{
    /// <summary>The name of its page in the site.</summary>
    public string Page => $"api-{Address}.html";
}

/// <summary>The types and members of docs/api.md, and their addresses in the site.</summary>
internal sealed partial class ApiIndex
{
    private readonly Dictionary<string, ApiType> _byName = [];
    private readonly Dictionary<string, ApiType> _byAddress = [];
    private readonly HashSet<string> _values;

    /// <summary>Reads the reference.</summary>
    /// <param name="text">The text of docs/api.md.</param>
    public ApiIndex(string text)
    {
        string[] parts = text.Split("\n## ");
        Overview = parts[0];
        var families = new Dictionary<string, string>();
        string family = "";
        foreach (Match line in Listed().Matches(Overview))
        {
            family = line.Groups["family"].Success ? line.Groups["family"].Value : family;
            families[line.Groups["type"].Value] = family;
        }

        foreach (string part in parts.Skip(1))
        {
            string name = part.Split('\n')[0];
            string address = SitePage.AddressOf(name);
            var type = new ApiType(name, address, families[name], part, [.. Member().Matches(part).Select(member => ApiMember.Of(member.Groups[1].Value))]);
            _byName.Add(name, type);
            _byAddress.Add(address, type);
        }

        _values = [.. Types.SelectMany(type => type.Members).Where(member => member.Group == "Values").Select(member => member.Name)];
    }

    /// <summary>The text before the first type: the list of all types.</summary>
    public string Overview { get; }

    public IReadOnlyCollection<ApiType> Types => _byName.Values;

    /// <summary>The type with an anchor of docs/api.md; null if there is none.</summary>
    public ApiType? At(string address) => _byAddress.GetValueOrDefault(address);

    /// <summary>The address of a type or of one of its members, for example "Ball" or "Ball.Step(dt)"; null if the reference does not contain it.</summary>
    public string? Find(string code)
    {
        string[] parts = code.Split('(')[0].Split('.');
        if (parts.Length > 2 || !_byName.TryGetValue(parts[0], out ApiType? type))
        {
            return null;
        }

        // A bare name can also be a value of an enumeration: Goal is a type and an event.
        return parts.Length == 1 ? (_values.Contains(code) ? null : type.Page)
            : type.Members.FirstOrDefault(member => member.Name == parts[1]) is { } found ? $"{type.Page}#{found.ShortId}"
            : null;
    }

    /// <summary>A signature as HTML, in which every type of the reference is a link.</summary>
    public string Linked(string signature)
    {
        int name = ApiMember.NameIn(signature);
        int at = 0;
        var html = new List<string>();
        foreach (Match word in Word().Matches(signature))
        {
            html.Add(WebUtility.HtmlEncode(signature[at..word.Index]));
            html.Add(word.Index == name ? $"<b>{word.Value}</b>"
                : _byName.TryGetValue(word.Value, out ApiType? type) ? $"<a href=\"{type.Page}\">{word.Value}</a>"
                : word.Value);
            at = word.Index + word.Length;
        }

        return string.Concat(html) + WebUtility.HtmlEncode(signature[at..]);
    }

    [GeneratedRegex(@"^(?:\*\*(?<family>.+)\*\*|- \[(?<type>\w+)\]\(.*)$", RegexOptions.Multiline)]
    private static partial Regex Listed();

    [GeneratedRegex("^- `([^`]+)`", RegexOptions.Multiline)]
    private static partial Regex Member();

    [GeneratedRegex(@"\w+")]
    private static partial Regex Word();
}
