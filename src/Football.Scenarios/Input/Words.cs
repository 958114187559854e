using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>The values of an enumeration as the formats write them.</summary>
public static class Words
{
    /// <summary>The word for a value: its name in camel case. Files keep the words of members that have been renamed.</summary>
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
