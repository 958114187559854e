#if TOOLS
#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Adds a dock that plays recordings (an EditorDock from Godot 4.6 on), and the drag curve in the inspector of a preset. The nodes and the resource are global classes, which Godot registers itself.</summary>
[Tool]
public partial class FootballPlugin : EditorPlugin
{
    private FootballReplayDock? _replay;
#if GODOT4_6_OR_GREATER
    private EditorDock? _dock;
#endif
    private FootballInspector? _inspector;

    /// <inheritdoc/>
    public override void _EnterTree()
    {
        _replay = new FootballReplayDock { Name = "Football Replay" };
        _inspector = new FootballInspector();
#if GODOT4_6_OR_GREATER
        _dock = new EditorDock { Title = "Football Replay", DefaultSlot = EditorDock.DockSlot.RightUl };
        _dock.AddChild(_replay);
        AddDock(_dock);
#else
        AddControlToDock(DockSlot.RightUl, _replay);
#endif
        AddInspectorPlugin(_inspector);
    }

    /// <inheritdoc/>
    public override void _ExitTree()
    {
        RemoveInspectorPlugin(_inspector);
#if GODOT4_6_OR_GREATER
        RemoveDock(_dock);
        _dock?.QueueFree();     // and with it the replay, its child
        _dock = null;
#else
        RemoveControlFromDocks(_replay);
        _replay?.QueueFree();
#endif
        _replay = null;
        _inspector = null;
    }
}
#endif
