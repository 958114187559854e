using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Aim;

/// <summary>Writes kicks as JSON, one per line.</summary>
internal static class AimWriter
{
    /// <summary>Returns the line of a kick.</summary>
    public static ReadOnlyMemory<byte> Result(string? name, AimAnswer answer) => ResultWriter.Line(json =>
    {
        AimResult result = answer.Kick;
        json.WriteString("name", name);
        json.WriteString("status", Words.Of(result.Status));
        ResultWriter.WriteVector(json, "velocity", result.Velocity);
        ResultWriter.WriteVector(json, "spin", result.Spin);
        if (answer.Orientation is { } turned)
        {
            ResultWriter.WriteRotation(json, "orientation", in turned);
        }

        json.WriteNumber("miss", result.Miss);
        json.WriteFinite("throughMiss", result.WaypointMiss);
        json.WriteNumber("time", result.Time);
        ResultWriter.WriteVector(json, "closest", result.Closest);
        json.WriteNumber("iterations", result.Iterations);
        json.WriteNumber("simulations", result.Simulations);
        json.WriteString("arc", Words.Of(result.Arc));
        json.WriteBoolean("rolls", result.Rolls);
        if (result.Reason is { } reason)
        {
            json.WriteString("reason", reason);
        }

        if (result.BlockedBy is { } blocker)
        {
            json.WriteString("blockedBy", blocker);
        }
    });
}
