#nullable enable
using System;
using FootballPhysics.Engines;
using FootballPhysics.Prediction;
using FootballPhysics.Shapes;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A goalkeeper at the position of this node, who dives for shots at the nearest goal. The library's Interception.FindSave plans the dive.</summary>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballKeeper : FootballThing
{
    private MeshInstance3D? _figure;

    /// <summary>The goal to guard; empty: the nearest one.</summary>
    [Export]
    public FootballGoal? Goal { get; set; }

    /// <summary>Reaction time, s.</summary>
    [Export(PropertyHint.Range, "0,2,0.01,suffix:s")]
    public float Reaction { get; set; } = 0.2f;

    /// <summary>Acceleration, m/s².</summary>
    [Export(PropertyHint.Range, "0.5,30,0.1,suffix:m/s²")]
    public float Acceleration { get; set; } = 8;

    /// <summary>Top speed, m/s.</summary>
    [Export(PropertyHint.Range, "0.5,15,0.1,suffix:m/s")]
    public float Speed { get; set; } = 5;

    /// <summary>Reach of a dive, m.</summary>
    [Export(PropertyHint.Range, "0,4,0.01,suffix:m")]
    public float Reach { get; set; } = 1.9f;

    /// <summary>Reach upwards, m.</summary>
    [Export(PropertyHint.Range, "0.5,4,0.01,suffix:m")]
    public float Highest { get; set; } = 2.6f;

    /// <summary>Colour of his shirt.</summary>
    [Export]
    public Color Shirt { get; set; } = new(0.95f, 0.76f, 0.19f);

    /// <summary>The number of shots that he dived for, for the ball that was stepped last.</summary>
    public int Dives { get; private set; }

    internal override int Order => 3;

    internal override void AddTo(FootballScene scene) => scene.Add(this, Goal, GodotFrame.FromGodot(GlobalPosition), new Player
    {
        Reaction = FootballPreset.Typed(Reaction),
        Acceleration = FootballPreset.Typed(Acceleration),
        Speed = FootballPreset.Typed(Speed),
        Reach = FootballPreset.Typed(Reach),
        MaximumHeight = FootballPreset.Typed(Highest),
    });

    internal override int StampOfFields() => HashCode.Combine(HashCode.Combine(Goal, Shirt), Reaction, Acceleration, Speed, Reach, Highest);

    internal override void Draw(FootballDrawing drawing)
    {
        var shape = (CapsuleShape)KeeperDive.Kind.Shape;
        _figure = drawing.Add(ShapeMesh.Of(shape), Shirt);
        _figure.GlobalTransform = new Transform3D(Basis.Identity, GlobalPosition + new Vector3(0, (float)(shape.Radius - shape.From.Y), 0));
    }

    /// <summary>Draws him in the pose of his dive.</summary>
    internal void Follow(KeeperDive dive)
    {
        Dives = dive.Count;
        if (_figure is not null)
        {
            BallPose pose = dive.BodyPose;
            _figure.GlobalTransform = new Transform3D(new Basis(GodotFrame.ToGodot(pose.Orientation)), GodotFrame.ToGodot(pose.Position));
        }
    }
}
