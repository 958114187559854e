#nullable enable
using System;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A wall of players who stand side by side along x and stop a ball.</summary>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballWall : FootballThing
{
    /// <summary>The number of players.</summary>
    [Export(PropertyHint.Range, "1,11,1")]
    public int Players { get; set; } = 5;

    /// <summary>The distance between the centres of two players, m; each is half a metre wide.</summary>
    [Export(PropertyHint.Range, "0.3,3,0.01,suffix:m")]
    public float Spacing { get; set; } = 0.52f;

    /// <summary>The colour of the shirts.</summary>
    [Export]
    public Color Shirts { get; set; } = new(0.78f, 0.16f, 0.2f);

    internal override int Order => 2;

    internal override void AddTo(FootballScene scene)
    {
        for (int i = 0; i < Players; i++)
        {
            scene.Stage.AddPlayer($"{Name} {i + 1}", Feet(i));
        }
    }

    internal override int StampOfFields() => HashCode.Combine(Players, Spacing, Shirts);

    internal override void Draw(FootballDrawing drawing)
    {
        var shape = (CapsuleShape)BodyKind.Player.Shape;
        for (int i = 0; i < Players; i++)
        {
            drawing.Add(ShapeMesh.Of(new CapsuleShape(shape.From + Feet(i), shape.To + Feet(i), shape.Radius)), Shirts);
        }
    }

    private Vector3d Feet(int player) =>
        GodotFrame.FromGodot(GlobalPosition) + Turn.Rotate(new Vector3d((player - (0.5 * (Players - 1))) * Spacing, 0, 0));
}
