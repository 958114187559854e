using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Intercept;

/// <summary>Writes the interceptions as JSON, one line per scenario.</summary>
internal static class InterceptWriter
{
    /// <summary>Returns the line of a scenario.</summary>
    public static ReadOnlyMemory<byte> Result(string? name, InterceptOutcome outcome) => ResultWriter.Line(json =>
    {
        json.WriteString("name", name);
        json.WriteStartArray("runners");
        for (int i = 0; i < outcome.Windows.Count; i++)
        {
            json.WriteStartObject();
            json.WriteString("name", outcome.Scenario.Names[i]);
            json.WriteStartArray("windows");
            foreach (InterceptWindow window in outcome.Windows[i])
            {
                json.WriteStartObject();
                json.WriteNumber("from", window.From);
                json.WriteNumber("to", window.To);
                ResultWriter.WriteVector(json, "position", window.Position);
                ResultWriter.WriteVector(json, "velocity", window.Velocity);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteString("first", outcome.First < 0 ? null : outcome.Scenario.Names[outcome.First]);
        json.WriteFinite("lead", outcome.Lead); // There may be no second player.
        json.WriteStartArray("shares");
        foreach (PossessionInterval share in outcome.Shares)
        {
            json.WriteStartObject();
            json.WriteString("name", outcome.Scenario.Names[share.Player]);
            json.WriteNumber("from", share.From);
            json.WriteNumber("to", share.To);
            json.WriteFinite("lead", share.TimeMargin);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    });
}
