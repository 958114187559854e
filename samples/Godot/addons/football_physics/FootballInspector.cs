#if TOOLS
#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Adds to the inspector of a preset the drag curve that its numbers make, and where those of its ball and ground come from.</summary>
[Tool]
public partial class FootballInspector : EditorInspectorPlugin
{
    /// <inheritdoc/>
    public override bool _CanHandle(GodotObject @object) => @object is FootballPreset;

    /// <inheritdoc/>
    public override void _ParseBegin(GodotObject @object) => AddCustomControl(new FootballCurve { Preset = (FootballPreset)@object });
}
#endif
