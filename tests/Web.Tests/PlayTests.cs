using System.Globalization;
using Microsoft.Playwright;

namespace FootballPhysics.Web.Tests;

/// <summary>The page to play with, in a real browser, opened from disk.</summary>
public sealed class PlayTests(Browser browser, ITestOutputHelper told)
{
    private const string Alone = "#wall=0&keeper=0";
    private const string DefaultBall = "modern";

    public static TheoryData<int, bool> Windows => new() { { 1280, false }, { 1280, true }, { 390, false }, { 390, true } };

    [Theory]
    [MemberData(nameof(Windows))]
    public async Task A_pull_kicks_by_mouse_and_by_touch(int width, bool dark)
    {
        await using Window window = await (await browser.Open(browser.Play, width, dark)).Ready();
        string name = $"play-{width}-{(dark ? "dark" : "light")}";
        Assert.Equal(width, await window.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth"));
        Assert.Equal(dark, await window.Page.EvaluateAsync<bool>("() => playground.stage.dark"));
        await window.Picture(name + "-before");
        Assert.Equal($"Pull back from the ball and let go, or {(width > 600 ? "click in" : "tap")} the goal.", await window.Page.TextContentAsync("#hint"));
        (float x, float y) = await window.OnScreen(0, 0.11, 0);
        await (width > 600 ? Drag(window, x, y, x + 20, y + 110) : Swipe(window, x, y, x + 20, y + 110));
        await window.Flown();
        double[] kick = await window.Numbers("playground.flights[0].kick");
        Assert.InRange(kick[0], 12, 38);                      // m/s, from the length of the pull
        Assert.InRange(kick[2], 0.5, 25);                     // to the left: it was pulled to the right
        Assert.True(await window.Page.EvaluateAsync<int>("() => playground.flights[0].events.length") > 0);
        await window.Until("playground.time > 0.8");
        await window.Picture(name + "-flight");

        // The stage has the focus, but a pointer leaves no frame around it.
        Assert.Equal("stage none", await window.Page.EvaluateAsync<string>("() => document.activeElement.id + ' ' + getComputedStyle(document.activeElement).outlineStyle"));
        Assert.Contains("\"figures\":5", await window.Page.Locator("#stage").GetAttributeAsync("data-drawn"));
        Assert.Empty(window.Errors);
        told.WriteLine($"{name}: library ready after {await window.Said("ready")} ms; pulled to {kick[0]} m/s, {kick[2]}° to the left; {await window.Said("frames")} frames in a second; no error");
    }

    [Fact]
    public async Task Five_cameras_look_from_above_the_grass()
    {
        Window window = await browser.Playing();
        await window.Page.ClickAsync("#kick");
        foreach (string view in new[] { "behind", "side", "above", "goal", "ball" })
        {
            await window.Page.ClickAsync($"[data-view={view}]");
            await window.Picture("camera-" + view);
            for (int i = 0; i < 4; i++)
            {
                await Drag(window, 400, 300, 420, 60);
                Assert.True(await window.Page.EvaluateAsync<double>("() => playground.stage.camera.eye[1]") > 0.2);
            }
        }
    }

    [Fact]
    public async Task The_path_ahead_is_the_flight()
    {
        Window window = await browser.Playing("#keeper=0");
        double[] way = await window.Numbers("Array.from(playground.way)");
        await window.Page.Keyboard.PressAsync(" ");
        await window.Flown();
        double[] keys = await window.Numbers("playground.flights[0].keys.flatMap(k => [k.t, ...k.p])");
        var flown = Enumerable.Range(0, keys.Length / 4).DistinctBy(i => Math.Round(keys[4 * i], 6)).ToDictionary(i => Math.Round(keys[4 * i], 6), i => i);
        int compared = 0;
        double worst = 0;
        for (int i = 0; i < way.Length; i += 4)
        {
            if (flown.TryGetValue(Math.Round(way[i], 6), out int key))
            {
                compared++;
                worst = Math.Max(worst, Enumerable.Range(1, 3).Max(j => Math.Abs(way[i + j] - keys[(4 * key) + j])));
            }
        }

        told.WriteLine($"{compared} places of the path ahead, over the wall and off what it meets: at most {worst:R} m from the flight");
        Assert.True(compared > 60);
        Assert.True(worst < 1e-9);
    }

    [Theory]
    [InlineData(-3.2, 2.0)]
    [InlineData(3.2, 0.4)]
    [InlineData(0.4, 1.2)]
    public async Task A_click_into_the_goal_finds_the_kick_that_goes_there(double x, double y)
    {
        Window window = await browser.Playing("#keeper=0");
        (float atX, float atY) = await window.OnScreen(x, y, -22);
        await window.Page.Mouse.ClickAsync(atX, atY);
        await window.Until("document.body.dataset.aim");
        string found = (await window.Said("aim"))!;
        Assert.StartsWith("Hit|", found);
        await window.Page.ClickAsync("#kick");
        await window.Flown();
        double[] off = await window.Numbers(FormattableString.Invariant($"[Math.min(...Array.from({{ length: 2000 }}, (_, i) => playground.flights[0].track.at(i / 1000).p).map(p => Math.hypot(p[0] - {x}, p[1] - {y}, p[2] + 22)))]"));
        told.WriteLine(FormattableString.Invariant($"clicked ({x}, {y}): {found}; the ball passes {1000 * off[0]:F0} mm from it (a pixel is {1000 / 36.0:F0} mm there)"));
        Assert.True(off[0] < 0.1);
        Assert.Equal("goal", await window.Page.EvaluateAsync<string>("() => playground.flights[0].first('goal').kind"));
    }

    [Fact]
    public async Task Where_no_kick_goes_it_says_why()
    {
        Window window = await browser.Playing("#speed=9&distance=40&wall=0");
        (float x, float y) = await window.OnScreen(0, 1.5, -40);
        await window.Page.Mouse.ClickAsync(x, y);
        await window.Until("document.body.dataset.aim");
        Assert.StartsWith("OutOfReach|", await window.Said("aim"));
        Assert.StartsWith("Out of reach at 32 km/h", await window.Page.TextContentAsync("#hint"));
    }

    [Fact]
    public async Task A_link_restores_the_kick_and_its_flight()
    {
        await using Window window = await (await browser.Open(browser.Play)).Ready();
        await window.Page.Keyboard.PressAsync("ArrowLeft");
        await window.Page.SelectOptionAsync("select[name=ball]", "Jabulani");
        await window.Page.Keyboard.PressAsync("Escape");
        await window.Page.ClickAsync("#link");
        await window.Until("document.body.dataset.copied");
        await window.Page.ClickAsync("#kick");
        await window.Flown();
        string link = (await window.Said("copied"))!;
        await using Window other = await (await browser.Open(browser.Play, hash: "#" + link.Split('#')[1])).Ready();
        Assert.Equal(await window.Said("kick"), await other.Said("kick"));
        await other.Page.ClickAsync("#kick");
        await other.Flown();
        Assert.Equal(await window.Events(), await other.Events());
        told.WriteLine($"#{link.Split('#')[1]}: the same {(await other.Events()).Split('\n').Length} events");
    }

    [Fact]
    public async Task A_link_with_anything_in_it_sets_only_what_the_controls_allow()
    {
        const string Script = "%22%3E%3Cimg%20src%3Dx%20onerror%3Ddocument.title%3D1%3E";
        await using Window window = await (await browser.Open(browser.Play)).Ready();
        string kick = (await window.Said("kick"))!;
        string title = await window.Page.TitleAsync();
        await using Window other = await (await browser.Open(
            browser.Play, hash: $"#speed=1e9&elevation=NaN&azimuth={Script}&wall=-3&keeper=1e300&distance=Infinity&ball={Script}&ground={Script}&beside={Script}&view={Script}&theme={Script}&__proto__=1")).Ready();
        Assert.Equal(kick, await other.Said("kick"));
        Assert.Equal(title, await other.Page.TitleAsync());
        Assert.Equal(0, await other.Page.Locator("img").CountAsync());
        Assert.Equal(DefaultBall, await other.Page.InputValueAsync("select[name=ball]"));
        Assert.Empty(other.Errors);
    }

    [Theory]
    [InlineData("")]
    [InlineData(Alone)]
    [InlineData("#keeper=3&wall=5&aside=8&windAcross=4&ball=brazuca&ground=wetTurf&altitude=2200&profile=published")]
    [InlineData("#keeper=0&wall=2&wetness=0.5&mud=0.2&wear=0.3&pressure=0.65")]
    [InlineData("#keeper=2&wall=0&wetness=0.5&pressure=0.65&profile=published")]
    public async Task The_copied_program_plays_what_is_seen(string hash)
    {
        Window window = await browser.Playing(hash);
        await window.Page.ClickAsync("#copy");
        await window.Until("document.body.dataset.copied");
        await window.Page.ClickAsync("#kick");
        await window.Flown();
        string seen = await window.Events();
        string printed = Programs.Run((await window.Said("copied"))!);
        Assert.Equal(seen, printed.TrimEnd().Replace("-0.000000", "0.000000", StringComparison.Ordinal));
        told.WriteLine($"{hash}: {seen.Split('\n').Length} events, the same to the last of six digits");
    }

    [Fact]
    public async Task The_golden_kicks_have_the_same_bits_in_the_browser()
    {
        Window window = await browser.Playing();
        int every = SitePageTests.IsFull ? 1 : 5;
        await window.Page.EvaluateAsync("every => { const bits = document.getElementById('bits'); bits.dataset.every = every; bits.click(); }", every);
        // On a busy machine, all golden lines take minutes.
        await window.Until("document.body.dataset.golden", patience: 900_000);
        string[] golden = await File.ReadAllLinesAsync(Path.Combine(Browser.Repository, "tests", "Golden", "golden.txt"));
        string[] seen = (await window.Said("golden"))!.Trim().Split('\n');
        Assert.Equal(golden.Where(new HashSet<string>(seen).Contains), seen);
        Assert.True(seen.Length >= golden.Length / every);
        told.WriteLine($"{seen.Length} of {golden.Length} lines: browser and tests/Golden/golden.txt are equal");
    }

    /// <summary>As every other way to the library has it, up to the longest kick that the page shows.</summary>
    [Fact]
    public async Task The_kick_of_the_default_is_the_one_in_the_table()
    {
        Window window = await browser.Playing(Alone + "&speed=27&elevation=15&azimuth=-16.7&top=-10&side=60&distance=45&aside=-15");
        await window.Page.ClickAsync("#kick");
        await window.Flown();
        double[] keys = await window.Numbers("playground.flights[0].keys.flatMap(k => [k.t, ...k.p, ...k.v, ...k.spin])");
        Dictionary<double, double[]> seen = keys.Chunk(10).ToDictionary(row => row[0]);
        double[][] table = [.. (await File.ReadAllLinesAsync(Path.Combine(Browser.Repository, "tests", "Golden", "one-default.csv")))
            .Skip(1).Select(row => row.Split(',').Select(number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray())];
        double[][] common = [.. table.Where(row => row[0] <= keys[^10])];
        Assert.True(common.Length > 500);
        Assert.All(common, row => Assert.Equal(row, seen[row[0]]));
    }

    [Theory]
    [InlineData("")]
    [InlineData("Penalty")]
    [InlineData("Free kick")]
    [InlineData("Wing")]
    [InlineData("Far")]
    public async Task A_ready_made_kick_beats_the_good_keeper(string spot)
    {
        Window window = await browser.Playing();
        if (spot.Length > 0)
        {
            string before = (await window.Said("scene"))!;
            await window.Page.EvaluateAsync("spot => [...document.querySelectorAll('#spots button')].find(button => button.textContent === spot).click()", spot);
            await window.Until($"document.body.dataset.scene !== '{before}'");
        }

        await window.Page.ClickAsync("#kick");
        await window.Until("document.body.dataset.verdict && !playground.playing");
        Assert.Equal("GOAL!", await window.Said("verdict"));
        Assert.Empty(window.Errors);
    }

    [Fact]
    public async Task Twenty_balls_fly_at_once()
    {
        Window window = await browser.Playing();
        int goals = int.Parse((await window.Page.TextContentAsync("#goals"))!, CultureInfo.InvariantCulture);
        await window.Page.ClickAsync("#many");
        await window.Until("playground.time > 0.5");
        await window.Picture("twenty-balls");
        await window.Until("playground.flights.some(f => f.scored)");
        int[] counted = await window.Page.EvaluateAsync<int[]>("() => [Number(document.getElementById('goals').textContent), playground.flights.filter(f => f.scored).length, playground.playing ? 1 : 0]");
        Assert.Equal([goals + counted[1], counted[1], 1], counted);
        await window.Until("playground.time > 1.5");
        string frames = (await window.Said("frames"))!;
        await window.Flown();
        Assert.Equal(20, await window.Page.EvaluateAsync<int>("() => playground.flights.length"));
        Assert.Contains("\"shots\":20", await window.Page.Locator("#stage").GetAttributeAsync("data-drawn"));
        Assert.Empty(window.Errors);
        told.WriteLine($"20 balls: {frames} frames in the best second, on {Environment.ProcessorCount} cores without a graphics card");
    }

    /// <summary>An impact sounds and flattens the drawn ball; the sound can be switched off.</summary>
    [Fact]
    public async Task An_impact_is_heard_and_flattens_the_drawn_ball()
    {
        Window window = await browser.Playing("#keeper=0&wall=0&elevation=30&speed=20");
        await window.Page.ClickAsync("#kick");
        await window.Until("document.body.dataset.heard");
        double[] heard = await window.Numbers("(h => [h.sounds, h.loudness, h.brightness, h.samples])(JSON.parse(document.body.dataset.heard))");
        Assert.True(heard[0] >= 1);
        Assert.InRange(heard[1], 0.1, 1);                     // a fall of five metres
        Assert.InRange(heard[2], 80, 110);                    // Hz, 1/T
        Assert.Equal(6000, heard[3]);
        await window.Flown();
        double[] flattest = await window.Numbers("(s => [s.t, s.along, s.along * s.across ** 2])(playground.flights[0].squashes.reduce((a, b) => b.along < a.along ? b : a))");
        Assert.InRange(flattest[1], 0.6, 0.95);
        Assert.Equal(1, flattest[2], 1e-9);
        double[] drawn = await window.Numbers(FormattableString.Invariant($"(t => {{ playground.stage.draw(playground.flights, t, null); return [playground.stage.drawn.squash]; }})({flattest[0]:R})"));
        Assert.Equal(flattest[1], drawn[0], 1e-3);
        double[] before = await window.Numbers("(t => { playground.stage.draw(playground.flights, t, null); return [playground.stage.drawn.squash ?? 1]; })(0.1)");
        Assert.Equal(1, before[0]);

        await window.Page.ClickAsync("#sound");
        Assert.Equal("false", await window.Page.Locator("#sound").GetAttributeAsync("aria-pressed"));
        await window.Page.EvaluateAsync("() => delete document.body.dataset.heard");
        await window.Page.ClickAsync("#kick");
        await window.Until("playground.time > 2.5");
        Assert.Null(await window.Said("heard"));
        await window.Page.ClickAsync("#sound");
        Assert.Empty(window.Errors);
    }

    [Fact]
    public async Task Two_profiles_fly_side_by_side_and_a_replay_is_slow()
    {
        Window window = await browser.Playing("#beside=published%3A&keeper=0");
        await window.Page.ClickAsync("#kick");
        await window.Flown();
        Assert.Equal(2, await window.Page.EvaluateAsync<int>("() => playground.flights.length"));
        double[] apart = await window.Numbers("[0, 1].map(i => playground.flights[i].track.at(1).p[0])");
        Assert.NotEqual(apart[0], apart[1]);
        await window.Until("playground.time > 1");
        await window.Picture("two-profiles");
        await window.Page.ClickAsync("#replay");
        await window.Until("playground.time < 0.5 && playground.time > 0.1");
        Assert.Contains("slow", await window.Page.TextContentAsync("#numbers"));
        await window.Picture("replay-in-slow-motion");
    }

    // As somebody who has never seen it: the hint says pull or click; a click into a corner, the button, and look at the score.
    [Fact]
    public async Task A_goal_is_scored_by_hand()
    {
        Window window = await browser.Playing();
        var watch = System.Diagnostics.Stopwatch.StartNew();
        int tries = 0;
        int kicks = int.Parse((await window.Page.TextContentAsync("#kicks"))!, System.Globalization.CultureInfo.InvariantCulture);
        string goals = (await window.Page.TextContentAsync("#goals"))!;
        foreach ((double x, double y) in new[] { (3.3, 2.1), (-3.4, 2.1), (-3.4, 0.3), (3.4, 0.4) })
        {
            tries++;
            (float atX, float atY) = await window.OnScreen(x, y, -22);
            await window.Page.EvaluateAsync("() => delete document.body.dataset.aim");
            await window.Page.Mouse.ClickAsync(atX, atY);
            await window.Until("document.body.dataset.aim");
            await window.Page.ClickAsync("#kick");
            await window.Until("document.body.dataset.verdict && !playground.playing");
            Assert.Equal(kicks + tries, int.Parse((await window.Page.TextContentAsync("#kicks"))!, System.Globalization.CultureInfo.InvariantCulture));
            if (await window.Page.TextContentAsync("#goals") != goals)
            {
                break;
            }

            await window.Page.Keyboard.PressAsync("Escape");
        }

        await window.Picture("goal");
        string said = (await window.Said("verdict"))!;
        told.WriteLine($"a goal past the good keeper at try {tries}, {(int)watch.Elapsed.TotalSeconds} s after the page was open: {said}");
        Assert.NotEqual(goals, await window.Page.TextContentAsync("#goals"));
    }

    private static async Task Drag(Window window, float fromX, float fromY, float toX, float toY)
    {
        await window.Page.Mouse.MoveAsync(fromX, fromY);
        await window.Page.Mouse.DownAsync();
        await window.Page.Mouse.MoveAsync(toX, toY, new MouseMoveOptions { Steps = 6 });
        await window.Page.Mouse.UpAsync();
    }

    /// <summary>A finger, as the browser's own protocol moves one.</summary>
    private static async Task Swipe(Window window, float fromX, float fromY, float toX, float toY)
    {
        ICDPSession touch = await window.Page.Context.NewCDPSessionAsync(window.Page);
        Task Send(string type, params float[] at) => touch.SendAsync(
            "Input.dispatchTouchEvent",
            new Dictionary<string, object> { ["type"] = type, ["touchPoints"] = at.Length == 0 ? Array.Empty<object>() : new object[] { new Dictionary<string, object> { ["x"] = at[0], ["y"] = at[1] } } });
        await Send("touchStart", fromX, fromY);
        for (int i = 1; i <= 6; i++)
        {
            await Send("touchMove", fromX + (i / 6f * (toX - fromX)), fromY + (i / 6f * (toY - fromY)));
        }

        await Send("touchEnd");
    }
}
