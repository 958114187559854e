using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>What Godot's source generator adds: the names of the signals that the node declares.</summary>
public partial class FootballGoal
{
    public new class SignalName : Node.SignalName
    {
        public static readonly StringName Scored = new(nameof(Scored));
        public static readonly StringName NetMet = new(nameof(NetMet));
        public static readonly StringName FrameHit = new(nameof(FrameHit));
    }
}
