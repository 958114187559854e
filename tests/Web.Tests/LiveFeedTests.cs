extern alias live;

using System.Text.Json;
using live::FootballPhysics.Live;

namespace FootballPhysics.Web.Tests;

/// <summary>The page of samples/Live, in a real browser, served by its program.</summary>
public sealed class LiveFeedTests(Browser browser, ITestOutputHelper told)
{
    public static TheoryData<int, bool> Windows => new() { { 1280, false }, { 1280, true }, { 390, false }, { 390, true } };

    [Theory]
    [MemberData(nameof(Windows))]
    public async Task A_feed_of_pixels_is_followed_and_drawn(int width, bool dark)
    {
        await using LiveServer server = await LiveServer.Start(0);
        await using Window window = await browser.Visit(server.Address + "?speed=20", width, dark);

        // Stops at a picture in which the ball, its path and a tube wide enough to see are in view.
        await window.Until("(frame && frame.kicks >= 8 && frame.path.every(p => Math.abs(p.x) < 18 && Math.abs(p.z) < 12 && p.y < 7) && frame.path.at(-1).deviation > 0.3) && (source.close(), true)");
        await window.Until("document.body.dataset.drawn && JSON.parse(document.body.dataset.drawn).time === frame.time");
        string name = $"live-{width}-{(dark ? "dark" : "light")}";
        await window.Picture(name);
        JsonElement drawn = JsonDocument.Parse((await window.Said("drawn"))!).RootElement;
        double time = drawn.GetProperty("time").GetDouble();

        // Each picture of the feed arrives once, in order.
        Assert.Equal(drawn.GetProperty("frames").GetInt32(), (int)Math.Round(time / Feed.Interval) + 1);
        Assert.Equal(drawn.GetProperty("path").GetInt32(), drawn.GetProperty("line").GetInt32());
        Assert.Equal((int)Math.Round(Follower.Duration / Follower.Every) + 1, drawn.GetProperty("path").GetInt32());
        Assert.True(drawn.GetProperty("tube").GetDouble() > 0);
        double error = drawn.GetProperty("error").GetDouble();
        double line = drawn.GetProperty("lineError").GetDouble();
        Assert.InRange(error, 0.001, 0.75 * line);

        // Both estimates, and the tube as a mix of its colour and the ground's.
        double[] pixels = await window.Numbers("""
            (() => {
              const d = draw.getImageData(0, 0, stage.width, stage.height).data, hex = name => { const n = parseInt(colour(name).slice(1), 16); return [n >> 16, n >> 8 & 255, n & 255]; };
              const count = c => { let n = 0; for (let i = 0; i < d.length; i += 4) if (Math.abs(d[i] - c[0]) + Math.abs(d[i + 1] - c[1]) + Math.abs(d[i + 2] - c[2]) < 16) n++; return n; };
              const grass = hex("grass").slice(0, 3), blue = hex("blue");
              return [count(blue), count(hex("orange")), count(grass), count(grass.map((g, i) => 0.75 * g + 0.25 * blue[i]))];
            })()
            """);
        Assert.All(pixels, count => Assert.True(count > 0));
        Assert.Equal(width, await window.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth"));
        Assert.Empty(window.Errors);
        told.WriteLine(FormattableString.Invariant($"{name}: {time:F1} s of the feed, {drawn.GetProperty("kicks").GetInt32()} kicks; 0.5 s ahead: {error} m, constant velocity {line} m; pixels {string.Join(' ', pixels)}"));
    }

    [Theory]
    [InlineData("speed=0")]
    [InlineData("speed=1e9")]
    [InlineData("speed=NaN")]
    public async Task A_speed_out_of_range_is_named(string query)
    {
        await using LiveServer server = await LiveServer.Start(0);
        using var client = new HttpClient();
        using HttpResponseMessage response = await client.GetAsync(new Uri($"{server.Address}frames?{query}"), TestContext.Current.CancellationToken);
        Assert.Equal(System.Net.HttpStatusCode.BadRequest, response.StatusCode);
        Assert.Contains("speed", await response.Content.ReadAsStringAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
    }

    [Fact]
    public void The_filter_finds_the_kicks_of_the_feed_and_predicts_better()
    {
        var feed = new Feed(3);
        var follower = new Follower();
        var kicks = new HashSet<double>();
        Frame frame;
        do
        {
            Picture picture = feed.Next();
            frame = follower.Follow(picture);
            kicks.Add(picture.Kicked);
        }
        while (frame.Time < 60);

        int real = kicks.Count(double.IsFinite);
        Assert.InRange(frame.Kicks, real - 3, real + 3);
        Assert.InRange(frame.Error, 0.001, 0.75 * frame.LineError);
        told.WriteLine(FormattableString.Invariant($"{real} kicks, {frame.Kicks} found; {frame.Error} m, {frame.LineError} m"));
    }
}
