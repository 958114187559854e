using System.Reflection;
using FootballPhysics.Tests.Support;
using Microsoft.Playwright;

namespace FootballPhysics.Web.Tests;

/// <summary>A real browser, and the pages on disk as a visitor has them.</summary>
public sealed class Browser : IAsyncLifetime
{
    private static readonly string[] s_names = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];
    private IPlaywright? _playwright;
    private IBrowser? _browser;
    private Window? _playing;
    private int _scenes;

    /// <summary>The folder of the repository.</summary>
    public static string Repository { get; } = Path.GetFullPath(typeof(Browser).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().First(item => item.Key == "Repository").Value!);

    /// <summary>Where the pictures go that the tests make.</summary>
    public static string Pictures { get; } = Directory.CreateDirectory(Path.Combine(Repository, "out", "web")).FullName;

    /// <summary>The page to play with, written as football play writes it.</summary>
    public string Play { get; } = Path.Combine(Pictures, Tool.Playground.File);

    public async ValueTask InitializeAsync()
    {
        await File.WriteAllTextAsync(Play, Tool.Playground.Html);
        if (NeededPrograms.Find(s_names) is not { } path)
        {
            return;
        }

        _playwright = await Playwright.CreateAsync();
        _browser = await _playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions { ExecutablePath = path, Args = ["--no-sandbox"] });
    }

    public async ValueTask DisposeAsync()
    {
        if (_browser is not null)
        {
            await _browser.DisposeAsync();
        }

        _playwright?.Dispose();
    }

    /// <summary>Skips the test if there is no browser.</summary>
    private void NeedBrowser() => Assert.SkipWhen(_browser is null, "No Chromium is in PATH. Install it, on Debian: apt-get install chromium-headless-shell");

    /// <summary>The page to play with in a window that tests share one after the other, set by an address anew: to start the library for each would take seconds.</summary>
    public async Task<Window> Playing(string hash = "")
    {
        NeedBrowser();
        _playing ??= await (await Open(Play)).Ready();
        _playing.Errors.Clear();
        string before = (await _playing.Said("scene"))!;
        // Without what tests wait for; the number makes each address another one.
        await _playing.Page.EvaluateAsync(
            "hash => { document.activeElement.blur(); for (const name of ['aim', 'arrows', 'copied', 'frames', 'flown', 'golden', 'heard', 'turned']) delete document.body.dataset[name]; location.hash = hash; }", $"#{hash.TrimStart('#')}&scene={++_scenes}");
        await _playing.Until($"document.body.dataset.scene !== '{before}'");
        return _playing;
    }

    /// <summary>A window of a width with a page in it.</summary>
    public Task<Window> Open(string file, int width = 1280, bool dark = false, string hash = "") => Show(new Uri(file).AbsoluteUri + hash, width, dark, offline: true);

    /// <summary>A window of a width with a page that this machine serves.</summary>
    public Task<Window> Visit(string address, int width = 1280, bool dark = false) => Show(address, width, dark, offline: false);

    private async Task<Window> Show(string address, int width, bool dark, bool offline)
    {
        NeedBrowser();
        IBrowserContext context = await _browser!.NewContextAsync(new BrowserNewContextOptions
        {
            ViewportSize = new ViewportSize { Width = width, Height = width > 600 ? 800 : 844 },
            ColorScheme = dark ? ColorScheme.Dark : ColorScheme.Light,
            HasTouch = width < 600,
            Offline = offline,
        });
        var window = new Window(await context.NewPageAsync());
        await window.Page.GotoAsync(address);
        return window;
    }
}
