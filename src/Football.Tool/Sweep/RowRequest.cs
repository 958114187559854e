using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep;

/// <summary>The requested columns of a row.</summary>
/// <param name="Columns">The columns, in their order; none for those that there are by default.</param>
/// <param name="Events">How many events of each flight.</param>
/// <param name="Samples">Times of samples, s.</param>
/// <param name="Hits">The names of the colliders whose hits are counted.</param>
internal sealed record RowRequest(IReadOnlyList<string> Columns, int Events, IReadOnlyList<double> Samples, IReadOnlyList<string> Hits)
{
    private const int MostEvents = 64;
    private const int MostSamples = 100_000;

    /// <summary>Whether only a flight that is watched can tell.</summary>
    public bool WatchesFlight => Events > 0 || Samples.Count > 0 || Hits.Count > 0;

    /// <summary>Reads it; the fields are still to be checked.</summary>
    public static RowRequest Take(InputObject root)
    {
        InputObject row = root.Object("row");
        var request = new RowRequest(row.Texts("columns") ?? [], row.Whole("events", 0), row.Ascending("samples"), row.Texts("hits") ?? []);
        return request.Events is < 0 or > MostEvents
            ? throw new RefusedException("row.events", FormattableString.Invariant($"{request.Events}"), FormattableString.Invariant($"a whole number from 0 to {MostEvents}"))
            : request.Samples.Count <= MostSamples ? request
            : throw new RefusedException("row.samples", FormattableString.Invariant($"a list of {request.Samples.Count}"), FormattableString.Invariant($"at most {MostSamples} times"));
    }
}
