using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>What Godot's source generator adds: the names of the signals that the node declares.</summary>
public partial class FootballBall
{
    public new class SignalName : Node.SignalName
    {
        public static readonly StringName Impact = new(nameof(Impact));
        public static readonly StringName Slide = new(nameof(Slide));
        public static readonly StringName Roll = new(nameof(Roll));
        public static readonly StringName Rest = new(nameof(Rest));
        public static readonly StringName ContactEnd = new(nameof(ContactEnd));
        public static readonly StringName Net = new(nameof(Net));
        public static readonly StringName Goal = new(nameof(Goal));
        public static readonly StringName Pinned = new(nameof(Pinned));
        public static readonly StringName EnterZone = new(nameof(EnterZone));
        public static readonly StringName ExitZone = new(nameof(ExitZone));
    }
}
