#nullable enable
using System;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A pitch: the ground of every football, at the height of this node, with lines, and with boards if their height is not 0. Goals are separate nodes.</summary>
/// <remarks>Its position is the centre of the pitch, whose length is along z. It may be rotated about y. Its scale is ignored.</remarks>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballPitch : FootballThing
{
    /// <summary>Length between the goal lines, m; 105 in football, 40 in futsal.</summary>
    [Export(PropertyHint.Range, "10,200,0.1,suffix:m")]
    public float Length { get; set; } = 105;

    /// <summary>Width between the touchlines, m; 68 in football, 20 in futsal.</summary>
    [Export(PropertyHint.Range, "5,150,0.1,suffix:m")]
    public float Width { get; set; } = 68;

    /// <summary>True for the goals and areas of futsal.</summary>
    [Export]
    public bool Futsal { get; set; }

    /// <summary>The ground. OfProfile: the ground of the ball's preset.</summary>
    [Export]
    public FootballPreset.GroundChoice Surface { get; set; } = FootballPreset.GroundChoice.OfProfile;

    /// <summary>Height of the boards around the pitch, m; 0 for none.</summary>
    [Export(PropertyHint.Range, "0,10,0.01,suffix:m")]
    public float BoardHeight { get; set; }

    /// <summary>Distance of the boards from the lines, m; at 0 they have a gap for each goal.</summary>
    [Export(PropertyHint.Range, "0,50,0.1,suffix:m")]
    public float BoardDistance { get; set; } = 4;

    /// <summary>Colour of the ground.</summary>
    [Export]
    public Color Grass { get; set; } = new(0.27f, 0.48f, 0.24f);

    internal override int Order => 0;

    /// <summary>Converts the pitch to the library's type, centred at the origin.</summary>
    public Pitch ToPitch() => (Futsal ? Pitch.Futsal : Pitch.Standard) with
    {
        Length = FootballPreset.Typed(Length),
        Width = FootballPreset.Typed(Width),
        BoardHeight = FootballPreset.Typed(BoardHeight),
        BoardDistance = FootballPreset.Typed(BoardDistance),
    };

    internal override void AddTo(FootballScene scene)
    {
        Scene own = scene.Stage.Scene;
        Ground ground = Surface == FootballPreset.GroundChoice.OfProfile ? own.Ground : FootballPreset.GroundOf(Surface, own.Ground);
        scene.Stage.Scene = own with { Ground = FootballPreset.AtHeight(ground, FootballPreset.Typed(GlobalPosition.Y)) };
        foreach (Obstacle board in ToPitch().Boards)
        {
            scene.Stage.Add(board with { Shape = Placed((BoxShape)board.Shape) });
        }
    }

    internal override int StampOfFields() => HashCode.Combine(HashCode.Combine(Length, Width, Futsal, (int)Surface), BoardHeight, BoardDistance, Grass);

    internal override void Draw(FootballDrawing drawing)
    {
        // At the same height, the lines would flicker in the grass, so draw the grass a little lower.
        Pitch pitch = ToPitch();
        Lay(drawing.Add(ShapeMesh.GroundOf(pitch), Grass), -0.012f);
        Lay(drawing.Add(ShapeMesh.LinesOf(pitch), new Color(1, 1, 1)), -0.004f);
        foreach (Obstacle board in pitch.Boards)
        {
            drawing.Add(ShapeMesh.Of(Placed((BoxShape)board.Shape)), new Color(0.16f, 0.24f, 0.45f));
        }
    }

    private void Lay(Node3D drawn, float raised) =>
        drawn.GlobalTransform = new Transform3D(new Basis(GlobalTransform.Basis.GetRotationQuaternion()), GlobalPosition + new Vector3(0, raised, 0));

    /// <summary>Moves a board of the pitch to the position of the pitch, which can be rotated about y.</summary>
    private BoxShape Placed(BoxShape board) => new(GodotFrame.FromGodot(GlobalPosition) + Turn.Rotate(board.Center), board.HalfSize, Turn);
}
