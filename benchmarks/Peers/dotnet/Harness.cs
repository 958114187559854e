using System.Diagnostics;
using System.Globalization;
using System.Text.Json;

namespace FootballPhysics.Peers;

/// <summary>Plays the shots against one engine and prints one line of JSON: node/harness.mjs in C#, experiment by experiment.</summary>
/// <typeparam name="TState">The saved state of a ball.</typeparam>
public sealed class Harness<TState>(Func<PeerOptions, IPeerWorld<TState>> create, string path)
{
    private const double Frame = 1.0 / 60;
    private readonly double[][] _drops = Read(path, "drop");
    private readonly double[][] _posts = Read(path, "post");
    private readonly double[][] _kicks = Read(path, "kick");

    /// <summary>Runs every experiment.</summary>
    public void Run(string name, string version, bool ccd, bool rolls, int bytes, string saved)
    {
        // Compiled code first: the runtime replaces its first code after some thousand calls.
        for (int i = 0; i < 5; i++)
        {
            CostOfOne();
            Thread.Sleep(200);
        }

        var (predictUs, predictOff) = Predict();
        var (saveNs, again) = Restore();
        double[] rebounds = [.. _drops.Select(d => Math.Sqrt((Apex(d[0], Frame) - Harness.Radius) / (d[0] - Harness.Radius)))];
        var row = new Dictionary<string, object?>
        {
            ["name"] = name,
            ["version"] = version,
            ["build"] = "C#, double",
            ["saved"] = saved,
            ["cost1"] = CostOfOne(),
            ["cost10k"] = CostOfMany(),
            ["tops"] = new[] { 0.005, 0.01, Frame, 0.04 }.Select(h => Apex(2, h)).ToArray(),
            ["reboundLow"] = rebounds.Min(),
            ["reboundHigh"] = rebounds.Max(),
            ["post60"] = ccd ? null : Posts(60),
            ["post240"] = ccd ? null : Posts(240),
            ["postCcd"] = ccd ? Posts(60) : null,
            ["roll"] = rolls ? Roll() : null,
            ["predictUs"] = predictUs,
            ["predictOff"] = predictOff,
            ["bytes"] = bytes,
            ["saveNs"] = saveNs,
            ["again"] = again,
            ["same"] = Same(),
        };
        Console.WriteLine(JsonSerializer.Serialize(row));
    }

    private static double[][] Read(string path, string kind) =>
        [.. File.ReadLines(path).Where(l => l.StartsWith(kind, StringComparison.Ordinal)).Select(l => l.Split(' ').Skip(1).Select(n => double.Parse(n, CultureInfo.InvariantCulture)).ToArray())];

    private static void Kick(IPeerWorld<TState> world, double[] k, Vector3d from) => world.Add(from, new Vector3d(k[0], k[1], k[2]), new Vector3d(k[3], k[4], k[5]));

    private static List<(Vector3d Position, ulong Hash)> Path(IPeerWorld<TState> world, int steps)
    {
        var states = new List<(Vector3d, ulong)>(steps);
        for (int i = 0; i < steps; i++)
        {
            world.Step(Frame);
            states.Add((world.Position(0), world.Hash(0)));
        }

        return states;
    }

    private double CostOfOne()
    {
        IPeerWorld<TState> world = create(new PeerOptions { Ground = true });
        Kick(world, _kicks[0], Vector3d.Up);
        TState start = world.Save(0);
        double least = double.PositiveInfinity;
        for (int round = 0; round < 400; round++)
        {
            world.Restore(0, in start);
            long from = Stopwatch.GetTimestamp();
            for (int i = 0; i < 60; i++)
            {
                world.Step(Frame);
            }

            least = Math.Min(least, Stopwatch.GetElapsedTime(from).TotalNanoseconds / 60);
        }

        return least;
    }

    private double CostOfMany()
    {
        const int Count = 10_000;
        IPeerWorld<TState> world = create(new PeerOptions { Ground = true });
        for (int i = 0; i < Count; i++)
        {
            Kick(world, _kicks[i], new Vector3d(3.0 * (i % 100), 1, 3.0 * (i / 100)));
        }

        TState[] starts = [.. Enumerable.Range(0, Count).Select(world.Save)];
        double least = double.PositiveInfinity;
        for (int round = 0; round < 10; round++)
        {
            for (int i = 0; i < Count; i++)
            {
                world.Restore(i, in starts[i]);
            }

            long from = Stopwatch.GetTimestamp();
            for (int i = 0; i < 60; i++)
            {
                world.Step(Frame);
            }

            least = Math.Min(least, Stopwatch.GetElapsedTime(from).TotalNanoseconds / 60 / Count);
        }

        return least;
    }

    // The greatest height between the first bounce and the second.
    private double Apex(double from, double h)
    {
        IPeerWorld<TState> world = create(new PeerOptions { Ground = true, Vacuum = true });
        world.Add(new Vector3d(0, from, 0), Vector3d.Zero, Vector3d.Zero);
        (double top, bool rises) = (0, false);
        for (int i = 0; i * h < 3; i++)
        {
            world.Step(h);
            rises |= world.Velocity(0).Y > 0;
            top = rises ? Math.Max(top, world.Position(0).Y) : 0;
            if (rises && world.Velocity(0).Y < 0)
            {
                break;
            }
        }

        return top;
    }

    // A hit turns the ball by more than 2 degrees, or back.
    private int Posts(int rate)
    {
        int hits = 0;
        foreach (double[] shot in _posts)
        {
            IPeerWorld<TState> world = create(new PeerOptions { Post = true });
            world.Add(new Vector3d(shot[0], 1, shot[1]), new Vector3d(0, 3, -40), Vector3d.Zero);
            for (int i = 0; i < 0.75 * rate; i++)
            {
                world.Step(1.0 / rate);
            }

            Vector3d v = world.Velocity(0);
            hits += -v.Z < Math.Cos(Math.PI / 90) * Math.Sqrt((v.X * v.X) + (v.Z * v.Z)) ? 1 : 0;
        }

        return hits;
    }

    private double Roll()
    {
        IPeerWorld<TState> world = create(new PeerOptions { Ground = true, Rolling = true, Vacuum = true });
        world.Add(new Vector3d(0, Harness.Radius, 0), new Vector3d(0, 0, -5), new Vector3d(-5 / Harness.Radius, 0, 0));
        for (int i = 0; i < 1800; i++)
        {
            world.Step(Frame);
        }

        return -world.Position(0).Z;
    }

    // A second world starts from the state of the ball 40 steps after the kick and runs 3 s ahead. How far is it from the first?
    private (double Us, double Off) Predict()
    {
        (double least, double off) = (double.PositiveInfinity, 0);
        IPeerWorld<TState> second = create(new PeerOptions { Ground = true });
        second.Add(Vector3d.Up, Vector3d.Zero, Vector3d.Zero);
        var path = new Vector3d[180];
        foreach (double[] kick in _kicks.Take(20))
        {
            IPeerWorld<TState> world = create(new PeerOptions { Ground = true });
            Kick(world, kick, Vector3d.Up);
            for (int i = 0; i < 40; i++)
            {
                world.Step(Frame);
            }

            TState state = world.Save(0);
            for (int round = 0; round < 5; round++)
            {
                long from = Stopwatch.GetTimestamp();
                second.Restore(0, in state);
                for (int i = 0; i < path.Length; i++)
                {
                    second.Step(Frame);
                    path[i] = second.Position(0);
                }

                least = Math.Min(least, Stopwatch.GetElapsedTime(from).TotalMicroseconds);
            }

            foreach (Vector3d position in path)
            {
                world.Step(Frame);
                off = Math.Max(off, (position - world.Position(0)).Length);
            }
        }

        return (least, off);
    }

    // Saves 40 steps after the kick, plays 120 steps, goes back and plays them again.
    private (double Ns, int Again) Restore()
    {
        (double least, int again) = (double.PositiveInfinity, 0);
        foreach (double[] kick in _kicks.Take(20))
        {
            IPeerWorld<TState> world = create(new PeerOptions { Ground = true });
            Kick(world, kick, Vector3d.Up);
            Path(world, 40);
            TState saved = world.Save(0);
            for (int round = 0; round < 20; round++)
            {
                long from = Stopwatch.GetTimestamp();
                for (int i = 0; i < 50; i++)
                {
                    saved = world.Save(0);
                    world.Restore(0, in saved);
                }

                least = Math.Min(least, Stopwatch.GetElapsedTime(from).TotalNanoseconds / 50);
            }

            List<(Vector3d, ulong)> first = Path(world, 120);
            world.Restore(0, in saved);
            again += first.SequenceEqual(Path(world, 120)) ? 1 : 0;
        }

        return (least, again);
    }

    private int Same() => _kicks.Take(20).Count(kick =>
    {
        IPeerWorld<TState>[] worlds = [create(new PeerOptions { Ground = true, Post = true }), create(new PeerOptions { Ground = true, Post = true })];
        foreach (IPeerWorld<TState> world in worlds)
        {
            Kick(world, kick, Vector3d.Up);
        }

        return Path(worlds[0], 180).SequenceEqual(Path(worlds[1], 180));
    });
}

/// <summary>The ball, the surfaces and the post of every experiment.</summary>
public static class Harness
{
    public const double Radius = 0.11;
    public const double Gravity = 9.81;
    public const double Restitution = 0.6;
    public const double Friction = 0.5;
    public const double PostZ = -20;
    public const double PostRadius = 0.06;
    public const double PostHeight = 2.5;
}
