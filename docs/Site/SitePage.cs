using Markdig;
using Markdig.Extensions.AutoIdentifiers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace FootballPhysics.Site;

/// <summary>A page of the site, made from a page of Markdown.</summary>
internal sealed class SitePage
{
    private static readonly MarkdownPipeline Pipeline = new MarkdownPipelineBuilder().UsePipeTables().UseAutoIdentifiers(AutoIdentifierOptions.GitHub).Build();

    private readonly MarkdownDocument _document;
    private readonly IReadOnlySet<string> _types;

    /// <summary>Reads a page.</summary>
    /// <param name="source">Its path in the repository, with slashes.</param>
    /// <param name="text">Its Markdown.</param>
    /// <param name="types">The headings of the API reference, as addresses, each of which has a page of its own.</param>
    /// <param name="file">Its name in the site; null for that of the source.</param>
    public SitePage(string source, string text, IReadOnlySet<string> types, string? file = null)
    {
        _types = types;
        Source = source;
        File = file ?? FileOf(source);
        _document = Markdown.Parse(text, Pipeline);
        Title = Words(_document.Descendants<HeadingBlock>().First().Inline!);
        foreach (LinkInline link in _document.Descendants<LinkInline>())
        {
            Turn(link);
        }
    }

    /// <summary>The API reference, which is one page of Markdown and many of the site.</summary>
    public const string Api = "docs/api.md";

    /// <summary>The page of a type of the API.</summary>
    public static string TypePage(string address) => $"api-{address}.html";

    public string Source { get; }

    /// <summary>Its name in the site.</summary>
    public string File { get; }

    public string Title { get; }

    /// <summary>Files of the repository that it shows, by their paths.</summary>
    public List<string> Pictures { get; } = [];

    /// <summary>Its sections of the second level: address within the page, and heading.</summary>
    public IEnumerable<(string Address, string Heading)> Contents => _document.OfType<HeadingBlock>().Where(heading => heading.Level == 2)
        .Select(heading => ("#" + heading.GetAttributes().Id, Words(heading.Inline!)));

    /// <summary>The address of a heading, as in a link to it.</summary>
    public static string AddressOf(string heading) => Markdown.Parse("# " + heading, Pipeline).Descendants<HeadingBlock>().First().GetAttributes().Id!;

    /// <summary>What stands in it, as HTML.</summary>
    public string Html => _document.ToHtml(Pipeline);

    /// <summary>Its sections, for the search: heading, where it is, and the words below it.</summary>
    public IEnumerable<(string Heading, string Address, string Text)> Sections
    {
        get
        {
            string heading = Title;
            string address = File;
            var words = new List<string>();
            foreach (Block block in _document)
            {
                if (block is HeadingBlock next)
                {
                    yield return (heading, address, string.Join(' ', words));
                    (heading, address, words) = (Words(next.Inline!), $"{File}#{next.GetAttributes().Id}", []);
                }
                else
                {
                    words.Add(Words(block));
                }
            }

            yield return (heading, address, string.Join(' ', words));
        }
    }

    /// <summary>The page that lists all others.</summary>
    public const string ContentsSource = "docs/contents.md";

    /// <summary>The folder of the pages for contributors.</summary>
    public const string Internals = "docs/internals/";

    private static string FileOf(string source) => source == "README.md" ? "index.html"
        : (source.StartsWith(Internals, StringComparison.Ordinal) ? "internals-" : "") + Path.GetFileNameWithoutExtension(source) + ".html";

    private static string Words(ContainerInline inlines) => string.Concat(inlines.Descendants().Select(inline => inline switch
    {
        LiteralInline literal => literal.Content.ToString(),
        CodeInline code => code.Content,
        LineBreakInline => " ",
        _ => "",
    }));

    private static string Words(Block block) => block switch
    {
        LeafBlock { Inline: { } inline } => Words(inline),
        CodeBlock code => code.Lines.ToString().ReplaceLineEndings(" "),
        ContainerBlock container => string.Join(' ', container.Select(Words)),
        _ => "",
    };

    /// <summary>Links to pages lead to those of the site; what else is in the repository is not in it.</summary>
    private void Turn(LinkInline link)
    {
        string url = link.Url!;
        if (url.StartsWith('#') && Source == Api && _types.Contains(url[1..]))
        {
            link.Url = TypePage(url[1..]);
        }

        if (url.Contains("://", StringComparison.Ordinal) || url.StartsWith('#'))
        {
            return;
        }

        string[] parts = url.Split('#', 2);
        string target = Path.GetRelativePath("/", Path.GetFullPath(Path.Combine("/", Path.GetDirectoryName(Source)!, parts[0]))).Replace('\\', '/');
        if (link.IsImage)
        {
            Pictures.Add(target);
            link.Url = Path.GetFileName(target);
        }
        else if (target == Api && parts.Length > 1 && _types.Contains(parts[1]))
        {
            link.Url = TypePage(parts[1]);
        }
        else
        {
            link.Url = (target.EndsWith(".md", StringComparison.Ordinal) ? FileOf(target) : target) + (parts.Length > 1 ? "#" + parts[1] : "");
        }
    }
}
