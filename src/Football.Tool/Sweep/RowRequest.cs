using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep;

/// <summary>The requested columns of a row.</summary>
/// <param name="Columns">The names of the columns, in order; empty for the default columns.</param>
/// <param name="Events">The number of events per flight.</param>
/// <param name="Samples">The times of the samples, in s.</param>
/// <param name="Hits">The names of the colliders whose hits are counted.</param>
internal sealed record RowRequest(IReadOnlyList<string> Columns, int Events, IReadOnlyList<double> Samples, IReadOnlyList<string> Hits)
{
    private const int MostEvents = 64;
    private const int MostSamples = 100_000;

    /// <summary>True if the columns need the events or the path of a flight, not only its end.</summary>
    public bool WatchesFlight => Events > 0 || Samples.Count > 0 || Hits.Count > 0;

    /// <summary>Reads the request. Call <see cref="InputFields.Check"/> afterwards.</summary>
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
