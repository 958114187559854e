#if TOOLS
#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Adds a dock that plays recordings, and the drag curve in the inspector of a preset. The nodes and the resource are global classes, which Godot registers itself.</summary>
[Tool]
public partial class FootballPlugin : EditorPlugin
{
    private FootballReplayDock? _dock;
    private FootballInspector? _inspector;

    /// <inheritdoc/>
    public override void _EnterTree()
    {
        _dock = new FootballReplayDock { Name = "Football Replay" };
        _inspector = new FootballInspector();
        AddControlToDock(DockSlot.RightUl, _dock);
        AddInspectorPlugin(_inspector);
    }

    /// <inheritdoc/>
    public override void _ExitTree()
    {
        RemoveInspectorPlugin(_inspector);
        RemoveControlFromDocks(_dock);
        _dock?.QueueFree();
        _dock = null;
        _inspector = null;
    }
}
#endif
