#nullable enable
using System;
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Plays a generated sound at each impact of the ball above it: loud by the peak force, bright by a short contact, with a brush by the slip. It needs no recording.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballSound : Node3D
{
    private const int Rate = 44100;

    /// <summary>The length of the generator's buffer, s: the largest delay of a sound.</summary>
    private const float Buffer = 0.05f;

    private readonly float[] _wave = new float[ImpactSound.SamplesAt(Rate)];

    // A ring as long as a sound: overlapping sounds are added.
    private readonly float[] _mix = new float[ImpactSound.SamplesAt(Rate)];
    private FootballBall? _ball;
    private AudioStreamGeneratorPlayback? _playback;
    private int _at;
    private int _left;

    /// <summary>The volume of the loudest impact.</summary>
    [Export(PropertyHint.Range, "0,1,0.01")]
    public float Volume { get; set; } = 1;

    /// <summary>The loudness of the last impact, 0 to 1.</summary>
    public double Loudness { get; private set; }

    /// <inheritdoc/>
    public override void _EnterTree()
    {
        _ball = GetParent() as FootballBall;
        if (_ball is null)
        {
            GD.PushWarning($"The sound \"{Name}\" is not below a football. Move it below a FootballBall.");
            return;
        }

        _ball.Struck += Add;
    }

    /// <inheritdoc/>
    public override void _Ready()
    {
        var player = new AudioStreamPlayer3D { Stream = new AudioStreamGenerator { MixRate = Rate, BufferLength = Buffer } };
        AddChild(player, false, InternalMode.Back);
        player.Play();
        _playback = player.GetStreamPlayback() as AudioStreamGeneratorPlayback;
    }

    /// <inheritdoc/>
    public override void _ExitTree()
    {
        if (_ball is not null)
        {
            _ball.Struck -= Add;
            _ball = null;
        }
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        int count = _playback is null ? 0 : Math.Min(_left, _playback.GetFramesAvailable());
        if (count == 0)
        {
            return;
        }

        var frames = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            float sample = Math.Clamp(_mix[_at], -1, 1);
            frames[i] = new Vector2(sample, sample);
            _mix[_at] = 0;
            _at = (_at + 1) % _mix.Length;
        }

        _left -= count;
        _playback!.PushBuffer(frames);
    }

    private void Add(Impact impact)
    {
        var sound = new ImpactSound(in impact);
        Loudness = sound.Loudness;
        if (!sound.IsAudible)
        {
            return;
        }

        sound.Write(_wave, Rate);
        for (int i = 0; i < _wave.Length; i++)
        {
            _mix[(_at + i) % _mix.Length] += Volume * _wave[i];
        }

        _left = _mix.Length;
    }
}
