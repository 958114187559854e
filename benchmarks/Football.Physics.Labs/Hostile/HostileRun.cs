using System.Diagnostics;

namespace FootballPhysics.Labs.Hostile;

/// <summary>Plays hostile scenes and looks for what must not be.</summary>
internal sealed class HostileRun
{
    /// <summary>Evaluations of a frame at most: some milliseconds of them.</summary>
    private const long MostEvaluations = 100_000;

    /// <summary>How often a frame that seems the slowest is played again.</summary>
    private const int Again = 20;

    private readonly Lock _lock = new();

    public HostileFindings Findings { get; } = new();

    public long Frames { get; private set; }

    public long Events { get; private set; }

    /// <summary>Frames that came to their last piece.</summary>
    public long Stalled { get; private set; }

    public long Rests { get; private set; }

    /// <summary>The frame that took longest, ms, the least of a few times, and its scene.</summary>
    public (double Milliseconds, ulong Scene) Slowest { get; private set; }

    /// <summary>Plays a scene to its end, and to the same end once more, and from a snapshot.</summary>
    public void Play(ulong number)
    {
        HostileScene scene = HostileGenerator.Make(number);
        double absurdity = Absurdity.Of(scene);
        try
        {
            Play(scene, absurdity);
        }
        catch (Exception e) when ((scene.HasOwnForces && e is FormatException) || e.Message.StartsWith("forces.customForces", StringComparison.Ordinal))
        {
            // A game's own forces may do anything, but what no number can hold is refused by name.
            Findings.AddRefusal("forces.customForces", new HostileSighting(number, 1, absurdity, e.Message));
        }
        catch (Exception e)
        {
            string message = e.Message.Split('\n')[0];
            Findings.Add($"{e.GetType().Name}: {message[..Math.Min(60, message.Length)]}", new HostileSighting(number, 1, absurdity, e.StackTrace?.Split('\n')[0].Trim() ?? ""));
        }
    }

    private void Play(HostileScene scene, double absurdity)
    {
        Simulator simulator;
        try
        {
            simulator = new Simulator(scene.Scene, scene.Settings);
        }
        catch (ArgumentOutOfRangeException e)
        {
            Findings.AddRefusal(e.ParamName ?? "", new HostileSighting(scene.Number, 1, absurdity, e.Message));
            return;
        }

        var frame = new HostileFrame(scene, simulator, absurdity, Findings);
        BallState state = simulator.Launch(scene.Position, scene.Velocity, scene.Spin);
        var hashes = new ulong[scene.Frames.Length];
        int savedAt = new HostileRandom(scene.Number ^ 0xABCDEF).Below(scene.Frames.Length);
        BallState saved = default;
        for (int i = 0; i < scene.Frames.Length; i++)
        {
            if (i == savedAt)
            {
                saved = Saved(frame, in state);
            }

            double milliseconds = Timed(() => frame.Play(i, ref state, scene.Frames[i]));
            Clock(frame, milliseconds);
            Count(frame);
            hashes[i] = Snapshot.Hash(state);
            if (!HostileStateCheck.Holds(frame))
            {
                return;
            }

            HostileEventCheck.Events(frame);
            HostileStateCheck.Energy(frame);
            HostileStateCheck.Reversal(frame);
        }

        var again = new Simulator(scene.Scene, scene.Settings);
        Repeat(frame, again, again.Launch(scene.Position, scene.Velocity, scene.Spin), 0, hashes, "not repeatable");
        Repeat(frame, simulator, saved, savedAt, hashes, "a snapshot diverges");
    }

    private static BallState Saved(HostileFrame frame, in BallState state)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(state, bytes);
        BallState read = Snapshot.Read(bytes);
        if (!Snapshot.Same(read, state))
        {
            frame.Find("a snapshot is another state", 1, $"{state.Position} to {read.Position}");
        }

        return read;
    }

    private static void Repeat(HostileFrame frame, Simulator simulator, BallState state, int from, ulong[] hashes, string kind)
    {
        var log = new StepLog(1);
        for (int i = from; i < hashes.Length; i++)
        {
            log.Clear();
            simulator.Step(ref state, frame.Scene.Frames[i], log);
            if (Snapshot.Hash(state) != hashes[i])
            {
                frame.Find(kind, 1, $"from frame {from} in frame {i}");
                return;
            }
        }
    }

    /// <summary>The work of a frame is judged by what was evaluated: a clock is other programs' too. The slowest frame is told.</summary>
    private void Clock(HostileFrame frame, double milliseconds)
    {
        if (frame.Log.Evaluations > MostEvaluations)
        {
            frame.FindMild($"long frame of {(frame.Length >= 1 ? "a second or more" : "less than a second")}", frame.Log.Evaluations, $"{frame.Log.Steps} pieces, {frame.Log.Events.Count} events");
        }

        // What another program took is not the frame's.
        for (int i = 0; i < Again && milliseconds > Slowest.Milliseconds; i++)
        {
            milliseconds = Math.Min(milliseconds, Timed(frame.Again));
        }

        lock (_lock)
        {
            Slowest = milliseconds > Slowest.Milliseconds ? (milliseconds, frame.Scene.Number) : Slowest;
        }
    }

    private void Count(HostileFrame frame)
    {
        long rests = 0;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            rests += item.Kind == BallEventKind.Rest ? 1 : 0;
        }

        lock (_lock)
        {
            Frames++;
            Events += frame.Log.Events.Count;
            Stalled += frame.Log.StalledSteps > 0 ? 1 : 0;
            Rests += rests;
        }
    }

    private static double Timed(Action what)
    {
        long start = Stopwatch.GetTimestamp();
        what();
        return Stopwatch.GetElapsedTime(start).TotalMilliseconds;
    }
}
