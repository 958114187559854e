using System.Diagnostics;
using System.Reflection;
using System.Runtime.CompilerServices;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;

namespace FootballPhysics.Live;

/// <summary>Serves the page, and a stream of server-sent events with a feed of its own for each visitor.</summary>
internal sealed class LiveServer : IAsyncDisposable
{
    /// <summary>The highest speed of a feed; 1 is real time.</summary>
    private const double Fastest = 1000;

    private readonly WebApplication _app;

    private LiveServer(WebApplication app) => _app = app;

    /// <summary>The address of the page.</summary>
    public string Address => _app.Urls.First() + "/";

    /// <summary>Starts the server.</summary>
    /// <param name="port">The port on this machine; 0 for a free one.</param>
    public static async Task<LiveServer> Start(int port)
    {
        WebApplicationBuilder builder = WebApplication.CreateSlimBuilder();
        builder.Logging.ClearProviders();
        WebApplication app = builder.Build();
        app.Urls.Add($"http://127.0.0.1:{port}");
        string page = Page();
        app.MapGet("/", () => Results.Content(page, "text/html; charset=utf-8"));
        app.MapGet("/frames", (HttpContext context, int seed = 1, double speed = 1) => speed is > 0 and <= Fastest
            ? Results.ServerSentEvents(Frames(seed, speed, context.RequestAborted))
            : Results.BadRequest(FormattableString.Invariant($"speed is {speed}; allowed: above 0, at most {Fastest}.")));
        await app.StartAsync();
        return new LiveServer(app);
    }

    /// <summary>Waits until the program is interrupted.</summary>
    public Task Wait() => _app.WaitForShutdownAsync();

    public ValueTask DisposeAsync() => _app.DisposeAsync();

    /// <summary>Simulates a feed, and follows it as fast as a camera takes pictures.</summary>
    private static async IAsyncEnumerable<Frame> Frames(int seed, double speed, [EnumeratorCancellation] CancellationToken stop)
    {
        var feed = new Feed(seed);
        var follower = new Follower();
        long start = Stopwatch.GetTimestamp();
        while (!stop.IsCancellationRequested)
        {
            Frame frame = follower.Follow(feed.Next());
            TimeSpan wait = TimeSpan.FromSeconds(frame.Time / speed) - Stopwatch.GetElapsedTime(start);
            if (wait > TimeSpan.Zero)
            {
                await Task.Delay(wait, stop);
            }

            yield return frame;
        }
    }

    private static string Page()
    {
        using Stream page = Assembly.GetExecutingAssembly().GetManifestResourceStream("index.html")!;
        return new StreamReader(page).ReadToEnd();
    }
}
