using FootballPhysics.Site;

namespace FootballPhysics.Web.Tests;

/// <summary>The site, written once for all tests.</summary>
internal static class SitePages
{
    private static readonly Lazy<IReadOnlyList<string>> s_pages = new(() => SiteWriter.Write(Browser.Repository, Folder));

    /// <summary>The names of its pages; those of types are not among them.</summary>
    public static IReadOnlyList<string> All => s_pages.Value;

    private static string Folder => Path.Combine(Browser.Pictures, "site");

    /// <summary>The path of a file of the site.</summary>
    public static string File(string name) => Path.Combine(All.Count > 0 ? Folder : "", name);
}
