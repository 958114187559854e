#nullable enable
using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A goal: posts and a crossbar that stop the ball, a net that bulges, and signals for goals. It opens towards +z, so a player who looks along −z shoots at it.</summary>
/// <remarks>Its position is the centre of the goal line on the ground. Its scale is ignored.</remarks>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballGoal : FootballThing
{
    private readonly List<(NetMesh Net, MeshInstance3D Drawn)> _nets = new();

    /// <summary>A goal: the whole ball has crossed the line.</summary>
    [Signal]
    public delegate void ScoredEventHandler(FootballBall ball, Vector3 position, Vector3 velocity, double time);

    /// <summary>A ball hit the net.</summary>
    [Signal]
    public delegate void NetMetEventHandler(FootballBall ball, Vector3 position, Vector3 velocity, double time);

    /// <summary>A ball hit a post or the crossbar.</summary>
    [Signal]
    public delegate void FrameHitEventHandler(FootballBall ball, Vector3 position, Vector3 velocity, double time);

    /// <summary>Width of the opening, m; 7.32 by Law 1, 3 in futsal.</summary>
    [Export(PropertyHint.Range, "0.5,20,0.01,suffix:m")]
    public float Width { get; set; } = 7.32f;

    /// <summary>Height of the opening, m; 2.44 by Law 1, 2 in futsal.</summary>
    [Export(PropertyHint.Range, "0.5,10,0.01,suffix:m")]
    public float Height { get; set; } = 2.44f;

    /// <summary>Radius of posts and bar, m; at most 0.06 by Law 1.</summary>
    [Export(PropertyHint.Range, "0.01,0.2,0.001,suffix:m")]
    public float PostRadius { get; set; } = 0.06f;

    /// <summary>Depth of the net at the height of the crossbar, m.</summary>
    [Export(PropertyHint.Range, "0.1,5,0.01,suffix:m")]
    public float DepthAtBar { get; set; } = 0.8f;

    /// <summary>Depth of the net on the ground, m.</summary>
    [Export(PropertyHint.Range, "0.1,5,0.01,suffix:m")]
    public float DepthOnGround { get; set; } = 2;

    /// <summary>True if the goal has nets. Without nets, the ball flies through.</summary>
    [Export]
    public bool HasNet { get; set; } = true;

    /// <summary>The number of goals since the scene started.</summary>
    public int Count { get; private set; }

    internal override int Order => 1;

    /// <summary>Converts the goal to the library's type.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The goal is not upright: its opening faces up or down.</exception>
    public Goal ToGoal()
    {
        Vector3d opening = Turn.Rotate(new Vector3d(0, 0, 1)).Horizontal;
        if (opening.Length < 0.1)
        {
            throw new ArgumentOutOfRangeException(Name.ToString(), "The opening of the goal faces up or down. Rotate the goal so that it stands upright.");
        }

        return new Goal
        {
            Center = GodotFrame.FromGodot(GlobalPosition),
            Facing = opening,
            Width = FootballPreset.Typed(Width),
            Height = FootballPreset.Typed(Height),
            PostRadius = FootballPreset.Typed(PostRadius),
            DepthAtBar = FootballPreset.Typed(DepthAtBar),
            DepthOnGround = FootballPreset.Typed(DepthOnGround),
            HasNet = HasNet,
        };
    }

    internal override void AddTo(FootballScene scene) => scene.Add(this, ToGoal());

    internal override int StampOfFields() => HashCode.Combine(Width, Height, PostRadius, DepthAtBar, DepthOnGround, HasNet);

    internal override void Draw(FootballDrawing drawing)
    {
        Goal goal = ToGoal();
        foreach (Obstacle part in goal.Frame(ForceSet.Measured))
        {
            drawing.Add(ShapeMesh.Of((CapsuleShape)part.Shape), new Color(1, 1, 1));
        }

        _nets.Clear();
        foreach (Net net in goal.Nets())
        {
            var threads = new NetMesh(net);
            _nets.Add((threads, drawing.Add(threads, new Color(0.92f, 0.93f, 0.95f))));
        }
    }

    /// <summary>Draws the bulges of the nets.</summary>
    internal void Follow(NetBulges bulges, int first)
    {
        for (int i = 0; i < _nets.Count; i++)
        {
            if (_nets[i].Net.Follow(bulges[first + i]))
            {
                FootballDrawing.Move(_nets[i].Drawn, _nets[i].Net);
            }
        }
    }

    /// <summary>Emits the signals of the goal for an event.</summary>
    internal void EmitFor(FootballBall ball, in BallEvent happened)
    {
        StringName? signal = happened.Kind switch
        {
            BallEventKind.Goal => SignalName.Scored,
            BallEventKind.Net => SignalName.NetMet,
            BallEventKind.Impact => SignalName.FrameHit,
            _ => null,
        };
        Count += happened.Kind == BallEventKind.Goal ? 1 : 0;
        if (signal is not null)
        {
            EmitSignal(signal, ball, GodotFrame.ToGodot(happened.Position), GodotFrame.ToGodot(happened.Velocity), happened.Time);
        }
    }
}
