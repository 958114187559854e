using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Network;

// demo runs both processes and the relay between them. relay, server, client and peer each run one of them, to start by hand in separate terminals. README.md has the lines.
CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
try
{
    return Modes.Run(args.Length > 0 ? args[0] : "demo", new Options(args.Skip(1)));
}
catch (ArgumentException wrong)
{
    Console.Error.WriteLine(wrong.Message);
    return 2;
}

/// <summary>The modes of a process.</summary>
internal static class Modes
{
    public static int Run(string mode, Options options)
    {
        switch (mode)
        {
            case "demo":
                return Demo.Run(options);
            case "relay":
                using (var relay = Demo.NewRelay(options))
                {
                    Console.WriteLine($"--port {relay.Port}");
                    relay.Await(0);
                    relay.Await(1);
                    relay.Run((long)(60 * options.Number("--minutes", 1) / Match.Step), options.Number("--speed", 1));
                    relay.Stop(0);
                    relay.Stop(1);
                }

                return 0;
            case "server":
                using (var hashes = new HashLog(options.Text("--hashes")))
                {
                    var server = new Server((int)options.Number("--seed", 1), hashes);
                    Link.Run((int)options.Number("--port", 0), 0, server.Tick);
                    Console.WriteLine(server.Score);
                    Console.WriteLine($"inputs late {server.Late}, kicks out of reach {server.Strips}; the ball in 24 bytes {server.Short} times, in 228 {server.Whole}");
                }

                return 0;
            case "client":
                using (var hashes = new HashLog(options.Text("--hashes")))
                {
                    var client = new Client((int)options.Number("--seed", 2), hashes, options.Text("--other-version"));
                    Link.Run((int)options.Number("--port", 0), 1, client.Tick);
                    Corrections all = client.Corrections;
                    Console.WriteLine(client.Refused ?? $"""
                        divergences {all.Divergences} of {all.Checked} balls that came {all.FirstDivergence}
                        played again {all.Replays} times, {all.Ticks / Math.Max(1.0, all.Replays):F0} ticks each; of these changed the ball {all.Count}
                        corrections of the ball: half up to {all.Size(0.5):F2} m, 95 of 100 up to {all.Size(0.95):F2} m, largest {all.Size(1):F2} m; larger than told {all.TooLarge}
                        largest jump in a frame {client.View.RawJump:F2} m, as it is drawn {client.View.DrawnJump:F2} m
                        """);
                    return all.Divergences + all.TooLarge == 0 ? 0 : 1;
                }

            case "peer":
                using (var hashes = new HashLog(options.Text("--hashes")))
                {
                    int side = (int)options.Number("--side", 0);
                    var peer = new Peer(side, (int)options.Number("--seed", 1), hashes);
                    Link.Run((int)options.Number("--port", 0), side, peer.Tick);
                    Console.WriteLine(peer.Score);
                    Console.WriteLine($"rolled back {peer.Rollbacks} times, {peer.Ticks / Math.Max(1.0, peer.Rollbacks):F0} ticks each; waited {peer.Waits} ticks");
                }

                return 0;
            default:
                Console.Error.WriteLine($"The mode is {mode}; allowed: demo | relay | server | client | peer.");
                return 2;
        }
    }
}

/// <summary>Options of the command line: --name value.</summary>
internal sealed class Options
{
    private static readonly string[] s_known =
        ["--minutes", "--delay", "--jitter", "--loss", "--seed", "--speed", "--away", "--style", "--port", "--side", "--hashes", "--other-version"];

    private readonly Dictionary<string, string> _values = [];

    public Options(IEnumerable<string> args)
    {
        foreach (string[] pair in args.Chunk(2))
        {
            if (pair.Length < 2 || !s_known.Contains(pair[0]))
            {
                throw new ArgumentException($"{pair[0]} is unknown or has no value. Options: {string.Join(" | ", s_known)}.");
            }

            _values[pair[0]] = pair[1];
        }
    }

    public string? Text(string name) => _values.GetValueOrDefault(name);

    public double Number(string name, double fallback) => Text(name) is not { } text ? fallback
        : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value >= 0 && value <= 1e9 ? value
        : throw new ArgumentException($"{name} is {text}; allowed: a number from 0 to 1e9.");
}

/// <summary>Runs two processes with a bad network between them. One is killed in the middle, and joins again.</summary>
internal static class Demo
{
    public static Relay NewRelay(Options options) =>
        new(new Weather(options.Number("--delay", 150), options.Number("--jitter", 40), options.Number("--loss", 0.05)), (int)options.Number("--seed", 1));

    public static int Run(Options options)
    {
        string style = options.Text("--style") ?? "server";
        if (style is not ("server" or "ggpo"))
        {
            throw new ArgumentException($"--style is {style}; allowed: server | ggpo.");
        }

        long ticks = (long)(60 * options.Number("--minutes", 10) / Match.Step);
        long away = (long)(options.Number("--away", 3) / Match.Step);
        double speed = options.Number("--speed", 0);
        string folder = Directory.CreateTempSubdirectory("football-network-").FullName;
        var watch = Stopwatch.StartNew();
        using Relay relay = NewRelay(options);
        Process Start(int side, string with = "") => Launch(
            $"{(style == "ggpo" ? $"peer --side {side}" : side == 0 ? "server" : "client")} --port {relay.Port} --seed {options.Number("--seed", 1) + side} --hashes {Path.Combine(folder, side.ToString(CultureInfo.InvariantCulture))} {with}");

        using Process first = Start(0);
        relay.Await(0);
        string refused = "";
        if (style == "server")
        {
            // The server rejects a client with another version of the game before it plays.
            using Process stranger = Start(1, "--other-version yes");
            relay.Await(1);
            relay.Run(90, speed);
            relay.Stop(1);
            refused = stranger.StandardOutput.ReadToEnd().Trim();
        }

        Process second = Start(1);
        relay.Await(1);
        relay.Run(ticks / 2, speed);
        if (away > 0)
        {
            second.Kill();
            second.WaitForExit();
            second.Dispose();
            relay.Forget(1);
            relay.Run((ticks / 2) + away, speed);
            second = Start(1);
            relay.Await(1);
        }

        relay.Run(ticks, speed);
        relay.Stop(0);
        relay.Stop(1);
        string one = first.StandardOutput.ReadToEnd();
        string two = second.StandardOutput.ReadToEnd();
        first.WaitForExit();
        second.WaitForExit();
        bool asTold = second.ExitCode == 0 && (style == "ggpo" || refused.Length > 0);
        second.Dispose();

        Dictionary<long, (ulong Hash, long First, long Second)> here = HashLog.Read(Path.Combine(folder, "0"));
        Dictionary<long, (ulong Hash, long First, long Second)> there = HashLog.Read(Path.Combine(folder, "1"));
        Directory.Delete(folder, recursive: true);
        long[] both = [.. here.Keys.Where(there.ContainsKey)];
        int apart = both.Count(tick => here[tick].Hash != there[tick].Hash);
        int scoresApart = both.Count(tick => (here[tick].First, here[tick].Second) != (there[tick].First, there[tick].Second));
        long end = both.Max();
        double seconds = ticks * Match.Step;
        Console.WriteLine($"""
            {style}: {ticks} ticks ({seconds / 60:F1} min) of {Match.Players} players and a ball in {watch.Elapsed.TotalSeconds:F1} s; second process killed after half, back {away * Match.Step:F1} s later
            {(style == "ggpo" ? "no server" : $"before it one of another version came: {refused}")}
            network: {relay.Sent} packets, {100.0 * relay.Lost / relay.Sent:F1} % lost, {100.0 * relay.Overtaken / relay.Sent:F1} % overtaken; first sends {relay.Bytes[0] / seconds:F0} bytes/s, second {relay.Bytes[1] / seconds:F0}
            first: {one.Trim()}
            second: {two.Trim()}
            ball compared at {both.Length} ticks: {apart} apart
            score of both at tick {end}: {here[end].First}:{here[end].Second} and {there[end].First}:{there[end].Second}, compared at {both.Length} ticks: {scoresApart} apart
            """);
        return apart + scoresApart == 0 && asTold && both.Length > (0.9 * (ticks - away)) - 300 ? 0 : 1;
    }

    private static Process Launch(string arguments)
    {
        string program = Environment.ProcessPath!;
        bool isDotnet = Path.GetFileNameWithoutExtension(program) == "dotnet";
        return Process.Start(new ProcessStartInfo(program, (isDotnet ? $"\"{typeof(Demo).Assembly.Location}\" " : "") + arguments) { RedirectStandardOutput = true })
            ?? throw new InvalidOperationException($"{program} did not start.");
    }
}
