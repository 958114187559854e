using System.Globalization;
using System.Text.Json;

namespace Football.Physics.Headless.Lab;

/// <summary>A line of a table: what a method did with a set of requests.</summary>
internal sealed class AimRow
{
    public AimRow(string name, IReadOnlyList<AimShot> shots)
    {
        Name = name;
        Shots = shots;
        Hits = shots.Count(shot => shot.Miss <= shot.Request.Tolerance);
        OutOfReach = shots.Count(shot => shot.Result.Status == AimStatus.OutOfReach);
        IReadOnlyList<AimShot> counted = Hits > 0 ? [.. shots.Where(shot => shot.Result.Status != AimStatus.OutOfReach)] : shots;
        Miss = Spread.Of(counted.Select(shot => shot.Miss));
        ThroughMiss = shots.Any(shot => shot.Result.ThroughMiss is not null && shot.Request.Through is not null)
            ? Spread.Of(counted.Select(shot => shot.Result.ThroughMiss ?? 0))
            : null;
        Iterations = Spread.Of(shots.Select(shot => (double)shot.Result.Iterations));
        Simulations = Spread.Of(shots.Select(shot => (double)shot.Result.Simulations));
        Microseconds = Spread.Of(shots.Select(shot => shot.Microseconds));
    }

    public string Name { get; }

    public IReadOnlyList<AimShot> Shots { get; }

    public int Hits { get; }

    public int OutOfReach { get; }

    /// <summary>Misses of the kicks that were not out of reach, m.</summary>
    public Spread Miss { get; }

    /// <summary>The same at the point on the way; null without one.</summary>
    public Spread? ThroughMiss { get; }

    public Spread Iterations { get; }

    public Spread Simulations { get; }

    public Spread Microseconds { get; }

    /// <summary>What the thesis has for it.</summary>
    public string Thesis { get; init; } = "";

    /// <summary>What was to be reached, and whether it was; null where nothing was.</summary>
    public (string Text, bool Reached)? Reach { get; init; }

    public static IReadOnlyList<string> Columns { get; } =
        ["", "kicks", "hit", "out of reach", "miss mm: mean", "p95", "worst", "point mm: mean", "worst", "iterations", "most", "simulations", "median µs", "mean", "thesis", "to reach"];

    public IReadOnlyList<string> Cells =>
    [
        Name, Text(Shots.Count, "0"), Text(Hits, "0"), Text(OutOfReach, "0"),
        Text(1e3 * Miss.Mean, "0.000"), Text(1e3 * Miss.P95, "0.000"), Text(1e3 * Miss.Worst, "0.000"),
        ThroughMiss is null ? "" : Text(1e3 * ThroughMiss.Mean, "0.00"), ThroughMiss is null ? "" : Text(1e3 * ThroughMiss.Worst, "0.00"),
        Text(Iterations.Mean, "0.0"), Text(Iterations.Worst, "0"), Text(Simulations.Mean, "0.00"),
        Text(Microseconds.Median, "0.0"), Text(Microseconds.Mean, "0.0"), Thesis,
        Reach is { } reach ? reach.Text + (reach.Reached ? ": yes" : ": NO") : "",
    ];

    public void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteString("name", Name);
        json.WriteNumber("kicks", Shots.Count);
        json.WriteNumber("hits", Hits);
        json.WriteNumber("outOfReach", OutOfReach);
        Miss.Write(json, "miss");
        ThroughMiss?.Write(json, "throughMiss");
        Iterations.Write(json, "iterations");
        Simulations.Write(json, "simulations");
        Microseconds.Write(json, "microseconds");
        json.WriteString("thesis", Thesis);
        if (Reach is { } reach)
        {
            json.WriteString("reach", reach.Text);
            json.WriteBoolean("reached", reach.Reached);
        }

        json.WriteEndObject();
    }

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
