namespace FootballPhysics.Web.Tests;

/// <summary>
/// The pages of the site in a browser, desktop and phone, light and dark: no error, nothing beyond the edge, and nothing is loaded that is hidden.
/// One page of each kind; all pages if FOOTBALL_FULL is 1, as in .ci/run --full.
/// </summary>
public sealed class SitePageTests(Browser browser, ITestOutputHelper told)
{
    private static readonly string[] s_kinds = ["index.html", "gallery.html", "getting-started.html", "cookbook.html", "api.html", "api-ball.html"];

    internal static bool IsFull => Environment.GetEnvironmentVariable("FOOTBALL_FULL") == "1";

    public static TheoryData<int, bool> Windows => new() { { 1280, false }, { 1280, true }, { 390, false }, { 390, true } };

    [Theory]
    [MemberData(nameof(Windows))]
    public async Task Pages_show_no_error_fit_the_window_and_load_only_visible_content(int width, bool dark)
    {
        string[] pages = IsFull ? [.. SitePages.All, .. Directory.GetFiles(Path.GetDirectoryName(SitePages.File("index.html"))!, "api-*.html").Select(file => Path.GetFileName(file)!)] : s_kinds;
        foreach (string page in pages)
        {
            await using Window window = await browser.Open(SitePages.File(page), width, dark);
            // Without a budget of time: what a page loads by itself, it begins to load at once.
            await window.Page.WaitForLoadStateAsync();
            await window.Page.EvaluateAsync("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))");
            Assert.True(window.Errors.Count == 0, $"{page}, {width}, {(dark ? "dark" : "light")}: {string.Join(", ", window.Errors)}");
            string[] hidden = [.. window.Loaded.Select(url => Path.GetFileName(new Uri(url).LocalPath)).Where(file => file is "play.html" or "replay.html" or "live-runtime.js" or "search-index.js")];
            Assert.True(hidden.Length == 0, $"{page}, {width}: loads {string.Join(", ", hidden)}");
            double[] size = await window.Numbers("[document.documentElement.scrollWidth, innerWidth, getComputedStyle(document.documentElement).colorScheme === 'dark' ? 1 : 0, document.querySelectorAll('iframe, video, audio').length]");
            Assert.True(size[0] <= size[1], $"{page}: {size[0]} pixels wide in a window of {size[1]}");
            Assert.Equal(dark ? 1 : 0, size[2]);
            Assert.Equal(0, size[3]);
            if (!IsFull)
            {
                await window.Picture($"site-{Path.GetFileNameWithoutExtension(page)}-{width}-{(dark ? "dark" : "light")}");
            }
        }

        told.WriteLine($"{pages.Length} pages, {width} pixels, {(dark ? "dark" : "light")}: no error, no request for hidden content");
    }

    [Fact]
    public async Task The_language_is_chosen_once_and_the_theme_stays()
    {
        await using Window window = await browser.Open(SitePages.File("aiming.html"));
        const string Shown = "[...document.querySelectorAll('.tab:not([hidden])')].map(tab => tab.dataset.language === 'Python' ? 1 : 0)";
        double[] before = await window.Numbers(Shown);
        Assert.True(before.Length >= 3 && before.All(python => python == 0));
        await window.Page.ClickAsync("[role=tab]:has-text('Python') >> nth=0");
        Assert.All(await window.Numbers(Shown), python => Assert.Equal(1, python));
        await window.Page.ClickAsync("#theme");
        await window.Page.GotoAsync(new Uri(SitePages.File("prediction.html")).AbsoluteUri);
        Assert.Contains(1, await window.Numbers(Shown));
        Assert.Equal("dark", await window.Page.EvaluateAsync<string>("() => getComputedStyle(document.documentElement).colorScheme"));
        // A picture follows the theme of the page, not that of the system: its paper is dark in the middle of a margin.
        await window.Page.EvaluateAsync("() => document.querySelector('img[src$=\".svg\"]').scrollIntoView()");
        double[] paper = await window.Numbers("(() => { const picture = document.querySelector('img[src$=\".svg\"]'); return [getComputedStyle(picture).colorScheme === 'dark' ? 1 : 0]; })()");
        Assert.Equal(1, paper[0]);
        await window.Picture("site-theme");
        Assert.Empty(window.Errors);
    }
}
