namespace FootballPhysics.Labs.Stability;

/// <summary>Simulates a scene, and checks each frame.</summary>
internal static class StressRun
{
    private static readonly FrameCheck[] s_checks = [EventCheck.Events, EventCheck.Hops, StateCheck.Energy, StateCheck.Reversal];

    /// <summary>Simulates a scene of the stress matrix.</summary>
    public static StressOutcome Play(StressScene scene) => Play(scene, scene.Kind.ToString(), frame => Holds(frame, s_checks));

    /// <summary>Simulates a hostile scene, then again from its start and from a snapshot.</summary>
    public static StressOutcome PlayHostile(StressScene scene)
    {
        FrameCheck[] checks =
            [StateCheck.Work, EventCheck.Events, EventCheck.Kinds, EventCheck.Ways, StateCheck.EnergyInStillAir, StateCheck.Reversal, new Replay(scene).Check];
        return Play(scene, "", frame => Holds(frame, checks));
    }

    /// <summary>Simulates a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="kind">Its kind, for the results.</param>
    /// <param name="goesOn">Checks a frame; false ends the scene.</param>
    /// <param name="begin">Prepares a frame: receives it, and the time, s.</param>
    /// <param name="mayBeRefused">True if the library may reject the scene.</param>
    public static StressOutcome Play(StressScene scene, string kind, Func<StressFrame, bool> goesOn, Action<StressFrame, double>? begin = null, bool mayBeRefused = true)
    {
        double absurdity = Absurdity.Of(scene);
        var findings = new List<Finding>();
        StressFrame? frame = null;
        Finding? refusal = null;
        try
        {
            frame = new StressFrame(scene, new Simulator(scene.Scene, scene.Settings), absurdity, findings);
            BallState state = frame.Simulator.Launch(scene.Position, scene.Velocity, scene.Spin);
            for (int i = 0; scene.RestsBy is { } end ? state.Motion != MotionState.Rest && state.Time < end : i < scene.Frames.Length; i++)
            {
                begin?.Invoke(frame, state.Time);
                frame.Play(ref state, scene.Frames[Math.Min(i, scene.Frames.Length - 1)]);
                if (!goesOn(frame))
                {
                    break;
                }
            }

            if (scene.RestsBy is { } by && state.Motion != MotionState.Rest)
            {
                frame.Find("rest", 1, $"{state.Motion} at {by} s, v {state.Velocity}, spin {state.Spin}");
            }
        }
        catch (ArgumentOutOfRangeException e) when (frame is null && mayBeRefused)
        {
            refusal = new Finding(e.ParamName ?? "", e.Message, 1, absurdity);
        }
        catch (Exception e) when ((scene.HasOwnForces && e is FormatException) || e.Message.StartsWith("forces.customForces", StringComparison.Ordinal))
        {
            // Custom forces may do anything, but the library rejects numbers that no field can hold by name.
            refusal = new Finding("forces.customForces", e.Message, 1, absurdity);
        }
        catch (Exception e)
        {
            string message = e.Message.Split('\n')[0];
            findings.Add(new Finding($"{e.GetType().Name}: {message[..Math.Min(60, message.Length)]}", e.StackTrace?.Split('\n')[0].Trim() ?? "", 1, absurdity));
        }

        return new StressOutcome(kind, scene.Integrator, (frame?.Tally ?? default) with { Scenes = 1, Failed = findings.Count > 0 ? 1 : 0 }, findings, refusal);
    }

    /// <summary>Checks a frame over level ground; false if its state is not finite.</summary>
    private static bool Holds(StressFrame frame, FrameCheck[] checks)
    {
        bool holds = StateCheck.Holds(frame);
        foreach (FrameCheck check in holds ? checks : [])
        {
            check(frame);
        }

        return holds;
    }
}

/// <summary>Simulates a scene again after its last frame, from the start and from a snapshot: each frame must be bit-identical.</summary>
internal sealed class Replay(StressScene scene)
{
    private readonly ulong[] _hashes = new ulong[scene.Frames.Length];
    private readonly int _savedAt = new HostileRandom((ulong)scene.Number ^ 0xABCDEF).Below(scene.Frames.Length);
    private BallState _saved;

    /// <summary>Stores the hash of a frame; after the last frame, simulates all frames again.</summary>
    public void Check(StressFrame frame)
    {
        if (_savedAt == 0 && frame.Index == 0)
        {
            Save(frame, in frame.Before);
        }
        else if (frame.Index + 1 == _savedAt)
        {
            Save(frame, in frame.After);
        }

        _hashes[frame.Index] = Snapshot.Hash(frame.After);
        if (frame.Index == _hashes.Length - 1)
        {
            var again = new Simulator(scene.Scene, scene.Settings);
            Repeat(frame, again, again.Launch(scene.Position, scene.Velocity, scene.Spin), 0, "not repeatable");
            Repeat(frame, frame.Simulator, _saved, _savedAt, "a snapshot diverges");
        }
    }

    private void Save(StressFrame frame, in BallState state)
    {
        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        _saved = Snapshot.Read(bytes);
        if (!Snapshot.Same(in _saved, in state))
        {
            frame.Find("a snapshot is another state", 1, $"{state.Position} to {_saved.Position}");
        }
    }

    private void Repeat(StressFrame frame, Simulator simulator, BallState state, int from, string check)
    {
        var log = new StepLog(1);
        for (int i = from; i < _hashes.Length; i++)
        {
            log.Clear();
            simulator.Step(ref state, scene.Frames[i], log);
            if (Snapshot.Hash(state) != _hashes[i])
            {
                frame.Find(check, 1, $"from frame {from} in frame {i}");
                return;
            }
        }
    }
}
