namespace Football.Physics.Headless.Schema;

/// <summary>The fields that say when a run ends, and what it keeps.</summary>
internal static class StopFields
{
    public static readonly ChoiceField<StopAt> At = new("stop.at", StopAt.Impact, ("impact", StopAt.Impact), ("rest", StopAt.Rest), ("time", StopAt.Time));
    public static readonly NumberField Time = new("stop.time", 20, NumberRange.Positive, "s");
    public static readonly FlagField Samples = new("samples", false);

    /// <summary>All of them.</summary>
    public static IReadOnlyList<Field> All { get; } = [At, Time, Samples];
}
