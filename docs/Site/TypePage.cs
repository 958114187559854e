using System.Net;
using System.Text.RegularExpressions;
using Markdig.Helpers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace FootballPhysics.Site;

/// <summary>The page of a type: its members under headings, each with an anchor, and the guides that use the type.</summary>
internal sealed partial class TypePage : SitePage
{
    private const int Shown = 5;

    private readonly List<(ApiMember Member, string Text)> _members = [];
    private readonly string _text;

    /// <summary>Makes the page.</summary>
    /// <param name="type">The type.</param>
    /// <param name="api">All types.</param>
    /// <param name="guides">The sections of the guides that use it, the most relevant first.</param>
    public TypePage(ApiType type, ApiIndex api, IReadOnlyList<Section> guides)
        : base(Api, "# " + type.Text, api, type.Page)
    {
        Type = type;
        _text = string.Join(' ', Document.OfType<ParagraphBlock>().Select(Words));
        int at = Document.TakeWhile(block => block is not ListBlock).Count();
        if (at < Document.Count)
        {
            var items = ((ListBlock)Document[at]).Cast<ListItemBlock>().ToList();
            Document.RemoveAt(at);
            Arrange(items, at, api);
        }

        if (guides.Count > 0)
        {
            Document.Insert(at, new HtmlBlock(null) { Lines = new StringLineGroup(Uses(guides)) });
        }
    }

    public ApiType Type { get; }

    /// <inheritdoc/>
    public override IEnumerable<(string Address, string Heading, bool IsSub)> Contents => Type.Members.GroupBy(member => member.Group).SelectMany(group =>
        group.Select(member => ("#" + member.ShortId, member.Name == "new" ? "new " + Title : member.Name, true)).Distinct().Prepend(("#" + AddressOf(group.Key), group.Key, false)));

    /// <summary>One section for the type, and one per member.</summary>
    public override IEnumerable<Section> Sections =>
        _members.Select(member => new Section(Title, member.Member.Name == "new" ? "new " + Title : $"{Title}.{member.Member.Name}", $"{File}#{member.Member.Id}", member.Text, "")).Prepend(new Section(Title, Title, File, _text, ""));

    /// <summary>Writes the members under a heading per group.</summary>
    private void Arrange(List<ListItemBlock> items, int at, ApiIndex api)
    {
        ListBlock? list = null;
        for (int i = 0; i < items.Count; i++)
        {
            ApiMember member = Type.Members[i];
            bool isFirst = Type.Members.Take(i).All(other => other.Name != member.Name);
            if (i == 0 || Type.Members[i - 1].Group != member.Group)
            {
                Document.Insert(at++, Heading(member.Group));
                Document.Insert(at++, list = new ListBlock(items[i].Parser!));
                list.GetAttributes().AddClass("members");
            }

            items[i].Parent!.Remove(items[i]);
            list!.Add(items[i]);
            _members.Add((member, Words(items[i])));
            Mark(items[i], member, isFirst, api);
        }
    }

    /// <summary>Gives a member its anchor, and links the types of its signature.</summary>
    private static void Mark(ListItemBlock item, ApiMember member, bool isFirst, ApiIndex api)
    {
        item.GetAttributes().Id = member.Id;
        ContainerInline line = ((ParagraphBlock)item[0]).Inline!;
        var code = (CodeInline)line.FirstChild!;
        var rest = (LiteralInline)code.NextSibling!;
        Match value = Value().Match(rest.Content.ToString());
        rest.Content = new StringSlice(rest.Content.ToString()[value.Length..]);
        string group = isFirst && member.ShortId != member.Id ? $"<span id=\"{member.ShortId}\"></span>" : "";
        code.ReplaceBy(new HtmlInline($"{group}<code class=\"signature\">{api.Linked(code.Content)}{value.Groups[1].Value}</code><a class=\"anchor\" href=\"#{member.Id}\" aria-label=\"Link to {member.Name}\">#</a> "));
    }

    /// <summary>Links to the sections that use the type; those after the first few can be unfolded.</summary>
    private static string Uses(IReadOnlyList<Section> guides)
    {
        string[] links = [.. guides.Select(section => $"<li><a href=\"{section.Address}\">{WebUtility.HtmlEncode(section.Heading == section.Page ? section.Page : $"{section.Page}: {section.Heading}")}</a></li>")];
        string rest = string.Concat(links.Skip(Shown));
        return $"<div class=\"uses\"><p>In the guides</p><ul>{string.Concat(links.Take(Shown))}</ul>"
            + (rest.Length > 0 ? $"<details><summary>{links.Length - Shown} more</summary><ul>{rest}</ul></details>" : "") + "</div>";
    }

    /// <summary>The text between a member's signature and its summary: a colon, after the number of an enumeration's value.</summary>
    [GeneratedRegex(@"^( = -?\d+)?:\s*")]
    private static partial Regex Value();
}
