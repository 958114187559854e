using System.Text.Json;

namespace FootballPhysics.Tests.Reference;

/// <summary>An event of a reference case.</summary>
internal sealed class ReferenceEvent
{
    public ReferenceEvent(JsonElement item)
    {
        Kind = ReferenceCase.Choice<BallEventKind>(item, "kind");
        Time = ReferenceCase.Number(item, "time");
        Position = ReferenceCase.Vector(item.GetProperty("position"));
        Velocity = ReferenceCase.Vector(item.GetProperty("velocity"));
        Spin = ReferenceCase.Vector(item.GetProperty("spin"));
    }

    public BallEventKind Kind { get; }

    public double Time { get; }

    public Vector3d Position { get; }

    public Vector3d Velocity { get; }

    public Vector3d Spin { get; }
}
