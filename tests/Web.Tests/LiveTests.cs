using System.Diagnostics;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using FootballPhysics.Site.Live;
using FootballPhysics.Tests.Support;
using Microsoft.Playwright;

namespace FootballPhysics.Web.Tests;

/// <summary>The live examples of the site: their numbers are those of C#, and a page loads the library only when somebody uses one.</summary>
public sealed class LiveTests(Browser browser, ITestOutputHelper told)
{
    private const int LargestFirstPage = 150_000;

    /// <summary>Each slider at three positions, the others at their defaults.</summary>
    private static IEnumerable<(LiveExample Example, int Slider, double Value)> Positions =>
        from example in LiveExample.All
        from slider in Enumerable.Range(0, example.Sliders.Count)
        let range = example.Sliders[slider]
        from value in (double[])[range.Min, OnGrid(range, 0.5), range.Max]
        select (example, slider, value);

    [Fact]
    public async Task Moving_a_slider_gives_the_numbers_of_csharp()
    {
        NeededPrograms.Need("apt-get install nodejs", "node");
        (LiveExample Example, int Slider, double Value)[] positions = [.. Positions];
        string input = string.Join('\n', positions.Select(position => $"{{\"example\":{position.Example.Json},\"values\":[{string.Join(',', Values(position))}]}}"));
        string[] printed = await Node(Path.Combine(Browser.Repository, "docs", "Site", "Assets", "live.js"), input);
        Assert.Equal(positions.Length, printed.Length);
        var different = new HashSet<string>();
        for (int i = 0; i < positions.Length; i++)
        {
            (LiveExample example, int slider, double value) = positions[i];
            string name = $"{example.Id}, {example.Sliders[slider].Path} = {value}";
            var expected = new LiveRun(example.With(example.Sliders[slider], value));
            using var answer = JsonDocument.Parse(printed[i]);
            double[] rows = answer.RootElement.GetProperty("rows").Deserialize<double[]>()!;
            double[] wanted = [.. expected.Times.SelectMany((time, k) => (double[])[time, expected.Points[k].X, expected.Points[k].Y, expected.Points[k].Z])];
            Assert.True(wanted.SequenceEqual(rows), $"{name}: the path differs");
            Assert.True(expected.Shown.Select(pair => $"{pair.Name} {pair.Value ?? "null"}").SequenceEqual(
                answer.RootElement.GetProperty("shown").EnumerateArray().Select(pair => $"{pair[0].GetString()} {(pair[1].ValueKind == JsonValueKind.Null ? "null" : pair[1].ValueKind == JsonValueKind.String ? pair[1].GetString() : pair[1].GetDouble())}")), $"{name}: {printed[i][printed[i].IndexOf("\"shown\"", StringComparison.Ordinal)..]} instead of {string.Join(", ", expected.Shown)}");
            different.Add(example.Id + string.Join(',', wanted));
        }

        // A slider that changes nothing would pass too.
        Assert.True(different.Count > 0.9 * positions.Length, $"only {different.Count} of {positions.Length} paths differ");
        told.WriteLine($"{LiveExample.All.Count} examples, {positions.Length} positions of their sliders, {different.Count} different paths: all bits equal");
    }

    [Fact]
    public void The_default_of_a_slider_is_a_position_of_the_slider() => Assert.All(LiveExample.All, example => Assert.All(example.Sliders, slider =>
    {
        double steps = (LiveFigure.Value(example, slider) - slider.Min) / slider.Step;
        Assert.True(Math.Abs(steps - Math.Round(steps)) < 1e-6, $"{example.Id}: {slider.Path} is {LiveFigure.Value(example, slider)}, which is no step of its slider.");
    }));

    [Theory]
    [InlineData(1280)]
    [InlineData(390)]
    public async Task The_first_page_is_small_until_somebody_moves_a_slider(int width)
    {
        await using Window window = await browser.Open(SitePages.File("index.html"), width);
        List<string> loaded = window.Loaded;
        await window.Page.ReloadAsync();
        await window.Until("Number(document.querySelector('figure.live').dataset.time) > 0.2");
        string[] files = [.. loaded.Select(url => Path.GetFileName(new Uri(url).LocalPath)).Distinct()];
        long bytes = files.Sum(file => new FileInfo(SitePages.File(file)).Length);
        Assert.True(bytes <= LargestFirstPage, $"{bytes} bytes: {string.Join(", ", files)}");
        Assert.DoesNotContain("live-runtime.js", files);
        Assert.DoesNotContain("search-index.js", files);
        Assert.DoesNotContain("play.html", files);

        LiveExample example = LiveExample.All.Single(one => one.Page == "index.html");
        await window.Page.EvaluateAsync("() => { const slider = document.querySelector('figure.live input'); slider.value = -20; slider.dispatchEvent(new Event('input', { bubbles: true })); }");
        await window.Until("document.querySelector('figure.live').dataset.shown");
        string shown = await window.Page.EvaluateAsync<string>("() => document.querySelector('figure.live').dataset.shown");
        var expected = new LiveRun(example.With(example.Sliders[0], -20));
        using var answer = JsonDocument.Parse(shown);
        Assert.Equal(expected.Shown.Select(pair => $"{pair.Name} {pair.Value}"), answer.RootElement.EnumerateArray().Select(pair => $"{pair[0].GetString()} {(pair[1].ValueKind == JsonValueKind.String ? pair[1].GetString() : pair[1].GetDouble())}"));
        Assert.Contains(loaded, url => url.EndsWith("live-runtime.js", StringComparison.Ordinal));
        Assert.Empty(window.Errors);
        told.WriteLine($"{width} pixels: {bytes} bytes of {string.Join(", ", files)} before the first click; {shown} after it");
    }

    private static double OnGrid(LiveSlider slider, double share) => slider.Min + (Math.Round((slider.Max - slider.Min) * share / slider.Step) * slider.Step);

    private static IEnumerable<string> Values((LiveExample Example, int Slider, double Value) position) =>
        position.Example.Sliders.Select((_, i) => i == position.Slider ? JsonSerializer.Serialize(position.Value) : "null");

    private static async Task<string[]> Node(string script, string input)
    {
        var start = new ProcessStartInfo("node", [Path.Combine(Browser.Repository, "tests", "Web.Tests", "live.mjs"), script, Path.Combine(Browser.Repository, "src", "Football.Physics.Web", "bin", "package")])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            StandardOutputEncoding = Encoding.UTF8,
            StandardInputEncoding = new UTF8Encoding(false),
        };
        using Process node = Process.Start(start)!;
        Task<string> error = node.StandardError.ReadToEndAsync();
        Task<string> output = node.StandardOutput.ReadToEndAsync();
        await node.StandardInput.WriteAsync(input);
        node.StandardInput.Close();
        await node.WaitForExitAsync();
        Assert.True(node.ExitCode == 0, await error);
        return (await output).TrimEnd('\n').Split('\n');
    }
}
