namespace FootballPhysics.Labs.Stability;

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
