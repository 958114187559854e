using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>
/// The ranges stand in the library, whose refusals name the field as a scenario does: this says them again with the value as it was
/// written, and with the words of the formats.
/// </summary>
public static class LibraryRefusal
{
    private const string Marker = "; allowed: ";

    /// <summary>The refusal; null where the exception is none of the library's about a range.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="input">The input.</param>
    /// <param name="path">Where in the input the thing is that the library refuses; empty for the whole.</param>
    public static RefusedException? Of(ArgumentException exception, InputFields input, string path = "")
    {
        string message = exception.Message;
        int marker = message.IndexOf(Marker, StringComparison.Ordinal);
        int end = message.LastIndexOf(". (Parameter", StringComparison.Ordinal);
        if (exception.ParamName is not { } name || marker < 0 || end < marker)
        {
            return null;
        }

        string field = name switch
        {
            "timeStep" or "lookAhead.timeStep" => "solver.timeStep",
            "duration" or "lookAhead.duration" => "stop.time",
            _ => (path.Length > 0 ? path + "." : "") + name.Replace("batch.", "solver.").Replace("aim.waypoint", "aim.through"),
        };
        int value = message.IndexOf(" is ", StringComparison.Ordinal) + 4;
        string[] allowed = message[(marker + Marker.Length)..end].Replace("Regularized", "Regularised").Split(" | ");
        return new RefusedException(
            field,
            input.Text(field) ?? message[value..marker],
            string.Join(" | ", allowed.Length > 1 ? allowed.Select(JsonNamingPolicy.CamelCase.ConvertName) : allowed));
    }
}
