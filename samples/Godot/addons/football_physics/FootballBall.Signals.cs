#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

public partial class FootballBall
{
    /// <summary>The ball hit something. The surface is its name: "ground", "left post", the name of a body; the node is the body or the goal, and null for anything else.</summary>
    [Signal]
    public delegate void ImpactEventHandler(Vector3 position, Vector3 velocityBefore, Vector3 velocity, Vector3 spin, double time, string surface, Node3D? node);

    /// <summary>The ball stayed on what carries it, slipping.</summary>
    [Signal]
    public delegate void SlideEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball began to roll without slip.</summary>
    [Signal]
    public delegate void RollEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball came to rest.</summary>
    [Signal]
    public delegate void RestEventHandler(Vector3 position, double time);

    /// <summary>A ball that was carried left what carried it.</summary>
    [Signal]
    public delegate void ContactEndEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball met a net.</summary>
    [Signal]
    public delegate void NetEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The whole ball is over the line of a goal.</summary>
    [Signal]
    public delegate void GoalEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>Things that move leave the ball no room, or it has room again: the ball's motion says which.</summary>
    [Signal]
    public delegate void PinnedEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball entered a zone of the scene.</summary>
    [Signal]
    public delegate void EnterZoneEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball left a zone of the scene.</summary>
    [Signal]
    public delegate void ExitZoneEventHandler(Vector3 position, Vector3 velocity, double time);

    private void Emit(in BallEvent happened)
    {
        Vector3 position = GodotFrame.ToGodot(happened.Position);
        Vector3 velocity = GodotFrame.ToGodot(happened.Velocity);
        switch (happened.Kind)
        {
            case BallEventKind.Impact:
                EmitSignal(
                    SignalName.Impact,
                    position,
                    GodotFrame.ToGodot(happened.VelocityBefore),
                    velocity,
                    GodotFrame.SpinToGodot(happened.Spin),
                    happened.Time,
                    _scene!.NameOf(in happened),
                    _scene.NodeOf(in happened)!);
                break;
            case BallEventKind.Slide:
                EmitSignal(SignalName.Slide, position, velocity, happened.Time);
                break;
            case BallEventKind.Roll:
                EmitSignal(SignalName.Roll, position, velocity, happened.Time);
                break;
            case BallEventKind.Rest:
                EmitSignal(SignalName.Rest, position, happened.Time);
                break;
            case BallEventKind.ContactEnd:
                EmitSignal(SignalName.ContactEnd, position, velocity, happened.Time);
                break;
            case BallEventKind.Pinned:
                EmitSignal(SignalName.Pinned, position, velocity, happened.Time);
                break;
            case BallEventKind.EnterZone:
                EmitSignal(SignalName.EnterZone, position, velocity, happened.Time);
                break;
            case BallEventKind.ExitZone:
                EmitSignal(SignalName.ExitZone, position, velocity, happened.Time);
                break;
            case BallEventKind.Net:
                EmitSignal(SignalName.Net, position, velocity, happened.Time);
                break;
            case BallEventKind.Goal:
                EmitSignal(SignalName.Goal, position, velocity, happened.Time);
                break;
        }
    }
}
