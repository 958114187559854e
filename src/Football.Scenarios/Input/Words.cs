using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Formats the values of an enumeration.</summary>
public static class Words
{
    /// <summary>Returns the word for a value: its name in camel case. Renamed members keep their old words, so that files stay valid.</summary>
    public static string Of<T>(T value)
        where T : struct, Enum => (Enum)value switch
        {
            BallEventKind.ContactEnd => "leave",
            BallEventKind.Pinned or MotionState.Pinned => "squeezed",
            MotionState.Rest => "stopped",
            AimStatus.WaypointMissed => "targetOnly",
            AerodynamicModel.Regularized => "regularised",
            _ => JsonNamingPolicy.CamelCase.ConvertName(value.ToString()),
        };
}
