namespace FootballPhysics.Web.Tests;

/// <summary>Questions as a new user asks them, typed into the search of the site.</summary>
public sealed class SearchTests(Browser browser, ITestOutputHelper told)
{
    private static readonly (string Question, string Page)[] s_questions =
    [
        ("goal detection", "cookbook.html#is-it-a-goal"),
        ("photon", "cookbook.html#how-do-i-use-it-with-photon"),
        ("ball rolls forever", "cookbook.html#the-ball-rolls-too-far"),
        ("unity netcode", "cookbook.html#how-do-i-use-it-with-photon"),
        ("arcade drag", "cookbook.html#it-curls-too-much"),
        ("curve is too strong", "cookbook.html#it-curls-too-much"),
        ("feet units", "cookbook.html#my-units-are-feet"),
        ("how do I use pixels instead of meters", "cookbook.html#my-units-are-feet"),
        ("top-down", "cookbook.html#how-do-i-make-a-top-down"),
        ("2D game", "cookbook.html#how-do-i-make-a-top-down"),
        ("save game", "cookbook.html#how-do-i-save"),
        ("load a saved match", "cookbook.html#how-do-i-save"),
        ("pause", "cookbook.html#how-do-i-pause"),
        ("slow motion", "cookbook.html#how-do-i-pause"),
        ("make it bounce more", "cookbook.html#how-do-i-make-the-ball-bounce"),
        ("bounciness", "cookbook.html#how-do-i-make-the-ball-bounce"),
        ("foot animation", "cookbook.html#how-do-i-kick-with-a-foot"),
        ("draw trajectory line", "cookbook.html#how-do-i-draw-the-path"),
        ("change ball size", "cookbook.html#how-do-i-change-the-ball"),
        ("AI that misses", "cookbook.html#how-do-i-make-an-ai"),
        ("out of play", "cookbook.html#when-is-the-ball-out"),
        ("ball goes through the post", "cookbook.html#the-ball-flies-through"),
        ("keeper catches and carries the ball", "cookbook.html#how-does-a-keeper-catch"),
        ("dribble", "cookbook.html#how-does-a-keeper-catch"),
        ("own wind", "cookbook.html#how-do-i-add-wind"),
        ("two balls collide", "cookbook.html#can-two-balls"),
        ("offside", "cookbook.html#was-the-pass-offside"),
        ("free kick wall", "cookbook.html#a-wall-that-stands"),
        ("rollback", "networking.html#rollback"),
        ("how fast in km/h", "cookbook.html#how-high"),
        ("multithreading", "concepts.html#threads"),
        ("memory allocation garbage collector", "performance.html#memory"),
        ("ios android il2cpp", "unity.html#ios"),
        ("keeper dive", "cookbook.html#where-does-the-keeper-catch"),
        ("train reinforcement learning", "cookbook.html#train"),
        ("nuget install", "getting-started.html#install"),
        ("unity rigidbody", "unity.html#rigidbody"),
        ("FixedUpdate interpolation jitter", "troubleshooting.html#it-jitters"),
        ("left handed", "unity.html#axes"),
        ("indoor futsal court", "cookbook.html#indoor"),
    ];

    [Fact]
    public async Task Of_forty_questions_the_right_page_is_among_the_first_three_for_thirty_seven()
    {
        await using Window window = await browser.Open(SitePages.File("index.html"));
        int right = 0;
        foreach ((string question, string page) in s_questions)
        {
            await Ask(window, question);
            string[] found = await window.Page.EvaluateAsync<string[]>("() => [...document.querySelectorAll('#found a')].slice(0, 3).map(a => a.getAttribute('href'))");
            bool isRight = found.Any(address => address.StartsWith(page, StringComparison.Ordinal));
            right += isRight ? 1 : 0;
            told.WriteLine($"{(isRight ? "right" : "WRONG")}  {question}: {string.Join(", ", found)}");
        }

        told.WriteLine($"{right} of {s_questions.Length} questions have the right page among the first three");
        Assert.Empty(window.Errors);
        Assert.Equal(40, s_questions.Length);
        Assert.True(right >= 37);
    }

    /// <summary>34 questions of one new user, and ten that another one asked in vain. Some have several right pages.</summary>
    [Fact]
    public async Task Of_forty_four_questions_of_strangers_the_right_page_is_among_the_first_three_for_forty()
    {
        await using Window window = await browser.Open(SitePages.File("index.html"));
        string[][] questions = [.. File.ReadAllLines(Path.Combine(Browser.Repository, "tests", "Web.Tests", "questions.tsv")).Skip(1).Select(line => line.Split('\t'))];
        int right = 0;
        foreach (string[] question in questions)
        {
            await Ask(window, question[0]);
            string[] found = await window.Page.EvaluateAsync<string[]>("() => [...document.querySelectorAll('#found a')].slice(0, 3).map(a => a.getAttribute('href'))");
            bool isRight = found.Any(address => question[1].Split(' ').Any(page => address.StartsWith(page, StringComparison.Ordinal)));
            right += isRight ? 1 : 0;
            told.WriteLine($"{(isRight ? "right" : "WRONG")}  {question[0]}: {string.Join(", ", found)}");
        }

        told.WriteLine($"{right} of {questions.Length} questions have the right page among the first three");
        Assert.Equal(44, questions.Length);
        Assert.True(right >= 40);
    }

    /// <summary>Types a question, and waits for the answer: the first search loads the words of all pages.</summary>
    private static async Task Ask(Window window, string question)
    {
        await window.Page.FillAsync("#search", question);
        await window.Until($"document.body.dataset.searched === {System.Text.Json.JsonSerializer.Serialize(question)}");
    }

    [Theory]
    [InlineData("Ball.LookAhead", "api-ball.html#LookAhead-LookAheadRequest-Trajectory", 1280)]
    [InlineData("ball.lookahead", "api-ball.html#LookAhead-LookAheadRequest-Trajectory", 390)]
    [InlineData("UntilPlane", "api-lookaheadrequest.html#UntilPlane", 1280)]
    [InlineData("Simulator.Validate", "api-simulator.html#Validate-BallState", 390)]
    [InlineData("Vector3d.ToVector3", "api-vector3d.html#ToVector3", 1280)]
    [InlineData("Ball", "api-ball.html", 1280)]
    public async Task The_name_of_a_member_leads_to_its_anchor_in_the_window(string query, string address, int width)
    {
        await using Window window = await browser.Open(SitePages.File("index.html"), width);
        await Ask(window, query);
        await window.Page.PressAsync("#search", "Enter");
        await window.Page.WaitForURLAsync(url => url.EndsWith(address, StringComparison.Ordinal));
        string anchor = address.Contains('#', StringComparison.Ordinal) ? "document.querySelector(':target > .signature b')" : "document.querySelector('h1')";
        Assert.Equal(query.Split('.')[^1], await window.Page.EvaluateAsync<string>($"() => {anchor}.textContent"), ignoreCase: true);
        double[] place = await window.Numbers($"[document.querySelector('header').getBoundingClientRect().bottom, {anchor}.getBoundingClientRect().top, {anchor}.getBoundingClientRect().bottom, innerHeight, document.documentElement.scrollWidth, innerWidth]");
        Assert.True(place[0] <= place[1] && place[2] <= place[3], $"{query} is behind the header or outside the window: {string.Join(", ", place)}");
        Assert.True(place[4] <= place[5], $"the page is {place[4]} pixels wide");
        Assert.Empty(window.Errors);
    }
}
