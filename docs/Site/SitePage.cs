using Markdig;
using Markdig.Extensions.AutoIdentifiers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace FootballPhysics.Site;

/// <summary>A section of a page.</summary>
/// <param name="Page">The title of the page.</param>
/// <param name="Heading">The heading of the section.</param>
/// <param name="Address">The address of the section in the site.</param>
/// <param name="Text">Its words, for the search.</param>
/// <param name="Code">Its programs and the code in its sentences.</param>
internal sealed record Section(string Page, string Heading, string Address, string Text, string Code);

/// <summary>A page of the site, made from a page of Markdown.</summary>
internal class SitePage
{
    private static readonly MarkdownPipeline Pipeline = new MarkdownPipelineBuilder().UsePipeTables().UseAutoIdentifiers(AutoIdentifierOptions.GitHub).Build();

    private readonly ApiIndex _api;

    /// <summary>Reads a page.</summary>
    /// <param name="source">Its path in the repository, with slashes.</param>
    /// <param name="text">Its Markdown.</param>
    /// <param name="api">The API reference, to link types and members.</param>
    /// <param name="file">Its name in the site; null for that of the source.</param>
    public SitePage(string source, string text, ApiIndex api, string? file = null)
    {
        _api = api;
        Source = source;
        File = file ?? FileOf(source);
        Document = Markdown.Parse(text, Pipeline);
        // Two pages have the name of the library as their heading.
        Title = source == "README.md" ? "About" : Words(Document.Descendants<HeadingBlock>().First().Inline!);
        foreach (LinkInline link in Document.Descendants<LinkInline>())
        {
            Turn(link);
        }

        if (source == Api)
        {
            MakeHeadings();
        }
        else if (!source.StartsWith(Internals, StringComparison.Ordinal))
        {
            // Pages for contributors also name folders and private types.
            LinkCode();
            LanguageTabs.Group(Document);
            LiveBlocks.Insert(Document, File);
        }
    }

    /// <summary>The API reference, which is one page of Markdown and many of the site.</summary>
    public const string Api = "docs/api.md";

    /// <summary>The page that lists all others.</summary>
    public const string ContentsSource = "docs/contents.md";

    /// <summary>The text of the first page.</summary>
    public const string LandingSource = "docs/Site/Assets/landing.md";

    /// <summary>The folder of the pages for contributors.</summary>
    public const string Internals = "docs/internals/";

    public string Source { get; }

    /// <summary>Its name in the site.</summary>
    public string File { get; }

    public string Title { get; }

    /// <summary>Files of the repository that it shows, by their paths.</summary>
    public List<string> Pictures { get; } = [];

    /// <summary>The entries of "On this page": address within the page, heading, and whether it belongs to the heading above.</summary>
    public virtual IEnumerable<(string Address, string Heading, bool IsSub)> Contents => Document.OfType<HeadingBlock>().Where(heading => heading.Level == 2)
        .Select(heading => ("#" + heading.GetAttributes().Id, Words(heading.Inline!), false));

    /// <summary>Its sections, for the search and for the lists of guides that use a type.</summary>
    public virtual IEnumerable<Section> Sections
    {
        get
        {
            string heading = Title;
            string address = File;
            var blocks = new List<Block>();
            foreach (Block block in Document)
            {
                if (block is HeadingBlock next)
                {
                    yield return Made();
                    (heading, address, blocks) = (Words(next.Inline!), $"{File}#{next.GetAttributes().Id}", []);
                }
                else
                {
                    blocks.Add(block);
                }
            }

            yield return Made();

            Section Made() => new(Title, heading, address, string.Join(' ', blocks.Select(Words)), string.Join(' ', blocks.Select(Code)));
        }
    }

    /// <summary>The page as HTML, without the frame.</summary>
    public string Html => Document.ToHtml(Pipeline);

    protected MarkdownDocument Document { get; }

    /// <summary>The address of a heading, as in a link to it.</summary>
    public static string AddressOf(string heading) => Markdown.Parse("# " + heading, Pipeline).Descendants<HeadingBlock>().First().GetAttributes().Id!;

    /// <summary>A heading of the second level.</summary>
    protected static HeadingBlock Heading(string text)
    {
        var heading = (HeadingBlock)Markdown.Parse("## " + text, Pipeline)[0];
        heading.Parent!.Remove(heading);
        return heading;
    }

    /// <summary>The words of a block.</summary>
    internal static string Words(Block block) => block switch
    {
        LeafBlock { Inline: { } inline } => Words(inline),
        CodeBlock code => code.Lines.ToString().ReplaceLineEndings(" "),
        ContainerBlock container => string.Join(' ', container.Select(Words)),
        _ => "",
    };

    private static string Words(ContainerInline inlines) => string.Concat(inlines.Descendants().Select(inline => inline switch
    {
        LiteralInline literal => literal.Content.ToString(),
        CodeInline code => code.Content,
        LineBreakInline => " ",
        _ => "",
    }));

    /// <summary>The programs of a block, and the code in its sentences.</summary>
    internal static string Code(Block block) => string.Join(' ', block.Descendants<CodeInline>().Select(code => code.Content)
        .Concat(block.Descendants<CodeBlock>().Concat(block is CodeBlock self ? [self] : []).Select(code => code.Lines.ToString())));

    /// <summary>The name in the site of a page of the repository.</summary>
    public static string FileOf(string source) => source == LandingSource ? "index.html" : source == "README.md" ? "readme.html"
        : (source.StartsWith(Internals, StringComparison.Ordinal) ? "internals-" : "") + Path.GetFileNameWithoutExtension(source) + ".html";

    /// <summary>The API reference has its families of types as bold lines; they become headings, so that links can lead to them.</summary>
    private void MakeHeadings()
    {
        foreach (ParagraphBlock line in Document.OfType<ParagraphBlock>().Where(line => line.Inline!.FirstChild is EmphasisInline { DelimiterCount: 2, NextSibling: null }).ToArray())
        {
            Document[Document.IndexOf(line)] = Heading(Words(line.Inline!));
        }
    }

    /// <summary>Names of types and members in the sentences of a guide become links to the reference.</summary>
    private void LinkCode()
    {
        foreach (CodeInline code in Document.Descendants<ParagraphBlock>().SelectMany(text => text.Inline!.Descendants<CodeInline>()).Where(code => code.Parent is not LinkInline).ToArray())
        {
            if (_api.Find(code.Content) is { } address)
            {
                var link = new LinkInline(address, "");
                code.ReplaceBy(link);
                link.AppendChild(code);
            }
        }
    }

    /// <summary>Links to pages lead to those of the site; links to other files of the repository stay as they are.</summary>
    private void Turn(LinkInline link)
    {
        string url = link.Url!;
        string[] parts = url.Split('#', 2);
        if (url.Contains("://", StringComparison.Ordinal) || (parts[0].Length == 0 && Source != Api))
        {
            return;
        }

        string target = parts[0].Length == 0 ? Source : Path.GetRelativePath("/", Path.GetFullPath(Path.Combine("/", Path.GetDirectoryName(Source)!, parts[0]))).Replace('\\', '/');
        if (link.IsImage)
        {
            Pictures.Add(target);
            link.Url = Path.GetFileName(target);
        }
        else if (target == Api && parts.Length > 1 && _api.At(parts[1]) is { } type)
        {
            link.Url = (link.FirstChild is CodeInline { NextSibling: null } code ? _api.Find(code.Content) : null) ?? type.Page;
        }
        else
        {
            link.Url = (target.EndsWith(".md", StringComparison.Ordinal) ? FileOf(target) : target) + (parts.Length > 1 ? "#" + parts[1] : "");
        }
    }
}
