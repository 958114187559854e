#if TOOLS
#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Adds the drag curve of a preset and the sources of its ball and ground to the preset's inspector.</summary>
[Tool]
public partial class FootballInspector : EditorInspectorPlugin
{
    /// <inheritdoc/>
    public override bool _CanHandle(GodotObject @object) => @object is FootballPreset;

    /// <inheritdoc/>
    public override void _ParseBegin(GodotObject @object) => AddCustomControl(new FootballCurve { Preset = (FootballPreset)@object });
}
#endif
