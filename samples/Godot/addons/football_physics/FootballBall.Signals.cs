#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

public partial class FootballBall
{
    /// <summary>The ball hit an object. The surface is its name: "ground", "left post", the name of a body. The node is the body or the goal; null for other objects.</summary>
    [Signal]
    public delegate void ImpactEventHandler(Vector3 position, Vector3 velocityBefore, Vector3 velocity, Vector3 spin, double time, string surface, Node3D? node);

    /// <summary>The ball began to slide on a surface.</summary>
    [Signal]
    public delegate void SlideEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball began to roll without slip.</summary>
    [Signal]
    public delegate void RollEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball came to rest.</summary>
    [Signal]
    public delegate void RestEventHandler(Vector3 position, double time);

    /// <summary>The ball lost contact with the surface it slid or rolled on.</summary>
    [Signal]
    public delegate void ContactEndEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball hit a net.</summary>
    [Signal]
    public delegate void NetEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>A goal: the whole ball has crossed the line.</summary>
    [Signal]
    public delegate void GoalEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>Moving objects pinned the ball or released it; see the ball's motion.</summary>
    [Signal]
    public delegate void PinnedEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball entered a zone of the scene.</summary>
    [Signal]
    public delegate void EnterZoneEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball left a zone of the scene.</summary>
    [Signal]
    public delegate void ExitZoneEventHandler(Vector3 position, Vector3 velocity, double time);

    private BallEvent _impact;

    /// <summary>The outputs of the last impact, for sound, haptics and looks. All are 0 before the first impact.</summary>
    /// <remarks>The value is computed on each access; a game that does not read it pays nothing.</remarks>
    public Impact LastImpact => _scene?.ImpactOf(in _impact) ?? default;

    /// <summary>Returns the largest normal force of the last impact, in N: the loudness of a sound.</summary>
    public double ImpactPeakForce() => LastImpact.PeakForce;

    /// <summary>Returns the duration of the last impact, in s: a short one sounds bright.</summary>
    public double ImpactContactTime() => LastImpact.ContactTime;

    /// <summary>Returns the product of friction impulse and slip of the last impact, in J: the brush of a sound.</summary>
    public double ImpactBrush()
    {
        Impact last = LastImpact;
        return last.TangentialImpulse * last.SlipBefore;
    }

    /// <summary>Returns the largest compression of the ball in the last impact, in m.</summary>
    public double ImpactCompression() => LastImpact.Compression;

    private void Emit(in BallEvent happened)
    {
        Vector3 position = GodotFrame.ToGodot(happened.Position);
        Vector3 velocity = GodotFrame.ToGodot(happened.Velocity);
        switch (happened.Kind)
        {
            case BallEventKind.Impact:
                _impact = happened;
                if (Struck is { } struck)
                {
                    struck(LastImpact);
                }

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
