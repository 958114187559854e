#if TOOLS
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>What the project's settings switch on. The node and the resource are global classes: Godot registers them itself, and once.</summary>
[Tool]
public partial class FootballPlugin : EditorPlugin
{
}
#endif
