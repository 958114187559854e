using System.Text.Json;
using Microsoft.Playwright;

namespace FootballPhysics.Web.Tests;

/// <summary>A page in a window, and what went wrong in it.</summary>
public sealed class Window : IAsyncDisposable
{
    private const int Patience = 120_000;

    public Window(IPage page)
    {
        Page = page;
        page.Request += (_, request) => Loaded.Add(request.Url);
        page.PageError += (_, error) => Errors.Add(error);
        page.Console += (_, message) =>
        {
            if (message.Type is "error" or "warning")
            {
                Errors.Add(message.Text);
            }
        };
    }

    public IPage Page { get; }

    /// <summary>Errors and warnings of its programs.</summary>
    public List<string> Errors { get; } = [];

    /// <summary>The addresses that the page has asked for, since it was opened.</summary>
    public List<string> Loaded { get; } = [];

    /// <summary>Waits until the library runs in the page.</summary>
    public async Task<Window> Ready()
    {
        await Until("document.body.dataset.ready || document.body.dataset.failed");
        Assert.Null(await Said("failed"));
        return this;
    }

    public Task Until(string condition, float patience = Patience) => Page.WaitForFunctionAsync($"() => {condition}", null, new PageWaitForFunctionOptions { Timeout = patience });

    /// <summary>What the page says of itself under a name; null for nothing.</summary>
    public Task<string?> Said(string name) => Page.EvaluateAsync<string?>($"() => document.body.dataset.{name} ?? null");

    public async Task<double[]> Numbers(string expression) =>
        JsonSerializer.Deserialize<double[]>(await Page.EvaluateAsync<string>($"() => JSON.stringify({expression})"))!;

    /// <summary>Waits until all balls that fly have come to their end in the library.</summary>
    public Task Flown() => Until("playground.flights.length > 0 && playground.flights.every(f => f.isOver)");

    /// <summary>The events of the first ball as lines, to a micrometre and a microsecond.</summary>
    public async Task<string> Events() => (await Page.EvaluateAsync<string>(
        "() => playground.flights[0].events.map(e => `${e.time.toFixed(6)} ${e.kind[0].toUpperCase() + e.kind.slice(1)} ${e.surface} ${e.position.map(x => (Math.abs(x) < 5e-7 ? 0 : x).toFixed(6)).join(' ')}`).join('\\n')"))
        .Replace(" Leave ", " ContactEnd ", StringComparison.Ordinal).Replace(" Squeezed ", " Pinned ", StringComparison.Ordinal);

    /// <summary>A picture of it in the folder of pictures.</summary>
    public Task Picture(string name) => Page.ScreenshotAsync(new PageScreenshotOptions { Path = Path.Combine(Browser.Pictures, name + ".png") });

    /// <summary>Where a place of the pitch is on the screen.</summary>
    public async Task<(float X, float Y)> OnScreen(double x, double y, double z)
    {
        double[] at = await Numbers(FormattableString.Invariant($"playground.stage.camera.project([{x}, {y}, {z}])"));
        return ((float)at[0], (float)at[1]);
    }

    public async ValueTask DisposeAsync() => await Page.Context.DisposeAsync();
}
