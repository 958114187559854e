namespace FootballPhysics.Tool.Sweep;

/// <summary>Counts of rows for the summary and the manifest. A count is null if the sweep has no such rows.</summary>
/// <param name="HandedOn">The number of rows that the SIMD batch passed to the scalar simulation.</param>
/// <param name="StillMoving">The number of rows without an outcome, because the ball still moved at the end of the longest flight.</param>
/// <param name="TooManyEvents">The number of rows without an outcome, because the flight had more events than are kept.</param>
/// <param name="Overflowed">The number of rows without an outcome, because the motion overflowed or could not be continued after the recorded end.</param>
internal readonly record struct RowCounts(long? HandedOn, long? StillMoving = null, long? TooManyEvents = null, long? Overflowed = null)
{
    /// <summary>The number of rows without an outcome; null if there is no such column.</summary>
    public long? Unknown => StillMoving + TooManyEvents + Overflowed;

    public static RowCounts operator +(RowCounts a, RowCounts b) =>
        new(a.HandedOn + b.HandedOn, a.StillMoving + b.StillMoving, a.TooManyEvents + b.TooManyEvents, a.Overflowed + b.Overflowed);
}
