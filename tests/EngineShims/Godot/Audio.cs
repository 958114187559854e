namespace Godot;

public class AudioStream : Resource
{
}

public class AudioStreamGenerator : AudioStream
{
    public float MixRate { get; set; } = 44100;

    public float BufferLength { get; set; } = 0.5f;
}

public class AudioStreamPlayback : GodotObject
{
}

public class AudioStreamGeneratorPlayback : AudioStreamPlayback
{
    /// <summary>What was pushed, in order.</summary>
    public List<Vector2> Pushed { get; } = [];

    /// <summary>The room of the buffer; in the shim it is empty again at once.</summary>
    public int Room { get; set; }

    public int GetFramesAvailable() => Room;

    public bool PushBuffer(Vector2[] frames)
    {
        if (frames.Length > Room)
        {
            return false;
        }

        Pushed.AddRange(frames);
        return true;
    }
}

public class AudioStreamPlayer3D : Node3D
{
    private AudioStreamGeneratorPlayback? _playback;

    public AudioStream? Stream { get; set; }

    public void Play() =>
        _playback = Stream is AudioStreamGenerator generator ? new AudioStreamGeneratorPlayback { Room = (int)(generator.MixRate * generator.BufferLength) } : null;

    /// <summary>As the engine does: there is none before the player plays.</summary>
    public AudioStreamPlayback? GetStreamPlayback() => _playback;
}
