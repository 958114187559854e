using System.Text.Json;

namespace FootballPhysics.Tests.Reference;

/// <summary>What a reference case must lead to.</summary>
internal sealed class ReferenceResult
{
    public ReferenceResult(JsonElement expected)
    {
        Time = ReferenceCase.Number(expected, "time");
        Position = ReferenceCase.Vector(expected.GetProperty("position"));
        Velocity = ReferenceCase.Vector(expected.GetProperty("velocity"));
        Spin = ReferenceCase.Vector(expected.GetProperty("spin"));
        Orientation = ReferenceCase.Rotation(expected.GetProperty("orientation"));
        Bounces = expected.GetProperty("bounces").GetInt32();
        Apex = ReferenceCase.Number(expected, "apex");
        Events = [.. expected.GetProperty("events").EnumerateArray().Select(item => new ReferenceEvent(item))];
        VelocityBefore = expected.TryGetProperty("velocityBefore", out JsonElement velocity) ? ReferenceCase.Vector(velocity) : null;
        SpinBefore = expected.TryGetProperty("spinBefore", out JsonElement spin) ? ReferenceCase.Vector(spin) : null;
    }

    public double Time { get; }

    public Vector3d Position { get; }

    public Vector3d Velocity { get; }

    public Vector3d Spin { get; }

    public Quaterniond Orientation { get; }

    public int Bounces { get; }

    public double Apex { get; }

    public IReadOnlyList<ReferenceEvent> Events { get; }

    public Vector3d? VelocityBefore { get; }

    public Vector3d? SpinBefore { get; }
}
