using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Aim;

/// <summary>Writes kicks as JSON, one per line.</summary>
internal static class AimWriter
{
    /// <summary>Returns the line of a kick.</summary>
    public static ReadOnlyMemory<byte> Result(string? name, AimResult result) => ResultWriter.Line(json =>
    {
        json.WriteString("name", name);
        json.WriteString("status", Words.Of(result.Status));
        WriteVector(json, "velocity", result.Velocity);
        WriteVector(json, "spin", result.Spin);
        json.WriteNumber("miss", result.Miss);
        if (result.WaypointMiss is { } throughMiss)
        {
            json.WriteNumber("throughMiss", throughMiss);
        }
        else
        {
            json.WriteNull("throughMiss");
        }

        json.WriteNumber("time", result.Time);
        WriteVector(json, "closest", result.Closest);
        json.WriteNumber("iterations", result.Iterations);
        json.WriteNumber("simulations", result.Simulations);
        json.WriteString("arc", Words.Of(result.Arc));
        json.WriteBoolean("rolls", result.Rolls);
        if (result.BlockedBy is { } blocker)
        {
            json.WriteString("blockedBy", blocker);
        }
    });

    private static void WriteVector(Utf8JsonWriter json, string name, in Vector3d vector)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(vector.X);
        json.WriteNumberValue(vector.Y);
        json.WriteNumberValue(vector.Z);
        json.WriteEndArray();
    }
}
