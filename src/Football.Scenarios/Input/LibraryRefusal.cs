using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>
/// Translates the library's argument exceptions. They name the field as a scenario does. The translation adds the value as written in the input, and
/// the words of the JSON formats.
/// </summary>
public static class LibraryRefusal
{
    private const string Marker = "; allowed: ";

    /// <summary>The suffixes that the runtime adds to the message of an argument exception: with its resource strings, and trimmed without them.</summary>
    private static readonly string[] s_suffixes = [" (Parameter '", " Arg_ParamName_Name, "];

    /// <summary>Returns the message of an exception without the suffix of the runtime.</summary>
    /// <param name="exception">The exception.</param>
    public static string Sentence(Exception exception)
    {
        string message = exception.Message;
        int suffix = s_suffixes.Max(text => message.LastIndexOf(text, StringComparison.Ordinal));
        return suffix < 0 ? message : message[..suffix];
    }

    /// <summary>Returns the error for the user; null if the exception is not about a field of the input.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="input">The input.</param>
    /// <param name="path">The path in the input of the object being created; empty for the root.</param>
    public static RefusedException? Of(ArgumentException exception, InputFields input, string path = "")
    {
        string message = Sentence(exception);
        int end = message.Length - 1;
        if (exception.ParamName is not { } name || message.Length == exception.Message.Length || !message.EndsWith('.'))
        {
            return null;
        }

        string field = name switch
        {
            "timeStep" or "lookAhead.timeStep" => "solver.timeStep",
            "duration" or "lookAhead.duration" => "stop.time",
            _ => (path.Length > 0 ? path + "." : "") + name.Replace("batch.", "solver.").Replace("aim.waypoint", "aim.through").Replace("goalChance.", ""),
        };
        int marker = message.IndexOf(Marker, StringComparison.Ordinal);
        if (marker < 0)
        {
            // A conflict between fields: a sentence that starts with the name of one. Other exceptions are bugs of the program.
            return message.StartsWith(name + " ", StringComparison.Ordinal)
                ? new RefusedException(field + message[name.Length..(end + 1)].Replace("aim.waypoint", "aim.through"))
                : null;
        }

        int value = message.IndexOf(" is ", StringComparison.Ordinal) + 4;
        string[] allowed = message[(marker + Marker.Length)..end].Replace("Regularized", "Regularised").Split(" | ");
        return new RefusedException(
            field,
            input.Text(field) ?? message[value..marker],
            string.Join(" | ", allowed.Length > 1 ? allowed.Select(JsonNamingPolicy.CamelCase.ConvertName) : allowed));
    }
}
