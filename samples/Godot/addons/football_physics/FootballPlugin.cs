#if TOOLS
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>Registers the node and the resource with the editor.</summary>
[Tool]
public partial class FootballPlugin : EditorPlugin
{
    private const string Folder = "res://addons/football_physics/";

    public override void _EnterTree()
    {
        AddCustomType(nameof(FootballBall), nameof(Node3D), GD.Load<Script>(Folder + "FootballBall.cs"), null);
        AddCustomType(nameof(FootballPreset), nameof(Resource), GD.Load<Script>(Folder + "FootballPreset.cs"), null);
    }

    public override void _ExitTree()
    {
        RemoveCustomType(nameof(FootballPreset));
        RemoveCustomType(nameof(FootballBall));
    }
}
#endif
