using System.Diagnostics;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>A row of a table: the results of a method for a set of requests.</summary>
internal sealed record AimRow(string Name, IReadOnlyList<AimShot> Shots)
{
    public static readonly string[] Columns =
    [
        "method", "kicks", "hit", "out of reach", "miss mm: mean", "miss: p95", "miss: worst", "point mm: mean", "point: worst",
        "iterations", "most", "simulations", "median µs", "mean µs", "thesis", "to reach",
    ];

    /// <summary>Misses of the kicks that were not out of reach, m.</summary>
    public Spread Miss => new(Counted.Select(shot => shot.Miss));

    /// <summary>Misses at the waypoint; null without a waypoint.</summary>
    public Spread? ThroughMiss => Shots.Any(shot => shot.Result.WaypointMiss is not null && shot.Request.Waypoint is not null)
        ? new Spread(Counted.Select(shot => shot.Result.WaypointMiss ?? 0))
        : null;

    public Spread Simulations => new(Shots.Select(shot => (double)shot.Result.Simulations));

    /// <summary>The thesis' result.</summary>
    public string Thesis { get; init; } = "";

    /// <summary>The target, and whether it was reached; null without a target.</summary>
    public (string Text, bool Reached)? Reach { get; init; }

    public object?[] Cells
    {
        get
        {
            (Spread miss, Spread? through) = (Miss, ThroughMiss);
            var iterations = new Spread(Shots.Select(shot => (double)shot.Result.Iterations));
            var microseconds = new Spread(Shots.Select(shot => shot.Microseconds));
            return
            [
                Name, Shots.Count, Hits, Shots.Count(IsOutOfReach), 1e3 * miss.Mean, 1e3 * miss.P95, 1e3 * miss.Worst, 1e3 * through?.Mean, 1e3 * through?.Worst,
                iterations.Mean, (int)iterations.Worst, Simulations.Mean, microseconds.Median, microseconds.Mean,
                Thesis, Reach is { } reach ? reach.Text + (reach.Reached ? ": yes" : ": NO") : "",
            ];
        }
    }

    private int Hits => Shots.Count(shot => shot.Miss <= shot.Request.Tolerance);

    private IEnumerable<AimShot> Counted => Hits > 0 ? Shots.Where(shot => !IsOutOfReach(shot)) : Shots;

    private static bool IsOutOfReach(AimShot shot) => shot.Result.Status == AimStatus.OutOfReach;
}

/// <summary>A request, the kick that a method found for it, and its measured miss.</summary>
/// <param name="Request">The request.</param>
/// <param name="Result">The result; its misses are measured.</param>
/// <param name="Miss">The miss that the experiment counts, m: in the reference simulation, or in the game's own integrator.</param>
/// <param name="Microseconds">The time of the search, µs.</param>
internal sealed record AimShot(AimRequest Request, AimResult Result, double Miss, double Microseconds)
{
    /// <summary>Horizontal distance of the target, m.</summary>
    public double Distance => (Request.Target - Request.From).Horizontal.Length;

    /// <summary>Elevation of the kick, degrees.</summary>
    public double Elevation => Math.Atan2(Result.Velocity.Y, Result.Velocity.Horizontal.Length) * 180 / Math.PI;

    /// <summary>Sidespin of the kick, rad/s.</summary>
    public double SideSpin => Result.Spin.Y;

    /// <summary>Topspin of the kick, rad/s.</summary>
    public double TopSpin
    {
        get
        {
            Vector3d d = Result.Velocity.Horizontal;
            double length = d.Length;
            return length > 0 ? ((Result.Spin.X * d.Z) - (Result.Spin.Z * d.X)) / length : 0;
        }
    }
}

/// <summary>Runs a method on requests, times it, and measures the misses of its kicks.</summary>
/// <param name="scene">The scene.</param>
/// <param name="settings">The thesis methods' integrator.</param>
/// <param name="timeStep">The time step of the thesis methods, s.</param>
/// <param name="judgeOwn">True if misses are measured in that integrator, not in the reference simulation.</param>
internal sealed class AimBench(Scene scene, SolverSettings settings, double timeStep, bool judgeOwn = false)
{
    private readonly ThesisAimer _aimer = new(scene, settings, timeStep);
    private readonly Simulator _own = new(scene, settings);
    private readonly LookAheadRequest _ownSteps = new() { TimeStep = timeStep, Duration = 30, StopAt = StopAt.Impact };
    private readonly Trajectory _path = new(8192);

    /// <summary>The default scene with RK2.</summary>
    public static AimBench Rk2(double timeStep) => new(Scene.Published, new SolverSettings { Integrator = Integrator.Rk2 }, timeStep);

    /// <summary>Runs a method on every request.</summary>
    public AimShot[] Run(IReadOnlyList<AimRequest> requests, AimMethod method)
    {
        WarmUp(requests, method);
        return [.. requests.Select(request => Run(request, method))];
    }

    /// <summary>Runs the method until the runtime has compiled its final code.</summary>
    private void WarmUp(IReadOnlyList<AimRequest> requests, AimMethod method)
    {
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < 100 || Stopwatch.GetElapsedTime(start).TotalMilliseconds < 250; i++)
        {
            _aimer.Find(requests[i % requests.Count], method, measure: false);
        }
    }

    private AimShot Run(AimRequest request, AimMethod method)
    {
        long start = Stopwatch.GetTimestamp();
        _aimer.Find(request, method, measure: false);
        double microseconds = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
        AimResult result = _aimer.Find(request, method);
        return new AimShot(request, result, judgeOwn ? OwnMiss(request, in result) : result.Miss, microseconds);
    }

    private double OwnMiss(AimRequest request, in AimResult result)
    {
        BallState ball = _own.Launch(request.From, result.Velocity, result.Spin);
        _own.LookAhead(in ball, _ownSteps, _path);
        return _path.ClosestApproach(request.Target).Distance;
    }
}

/// <summary>Charts of experiments with predictors.</summary>
internal static class AimCharts
{
    private const int Bars = 40;

    /// <summary>Draws a histogram of misses.</summary>
    /// <param name="row">The row to draw.</param>
    /// <param name="all">The rows that share the same axes.</param>
    public static XElement Misses(AimRow row, IEnumerable<AimRow> all)
    {
        static double[] Values(AimRow of) => [.. of.Shots.Where(shot => shot.Miss <= 0.1).Select(shot => 1e3 * shot.Miss)];
        return Histogram(row, "miss, mm", Values(row), Palette.Blue, all.SelectMany(Values));
    }

    /// <summary>Draws a histogram of times, without the slowest hundredth: the machine slowed those down, not the method.</summary>
    /// <param name="row">The row to draw.</param>
    /// <param name="all">The rows that share the same axes.</param>
    public static XElement Times(AimRow row, IEnumerable<AimRow> all)
    {
        static double[] Values(AimRow of) => [.. of.Shots.Select(shot => shot.Microseconds).Order().Take((of.Shots.Count * 99) / 100)];
        return Histogram(row, "time, µs", Values(row), Palette.Orange, all.SelectMany(Values));
    }

    /// <summary>Draws the number of kicks per number of iterations.</summary>
    public static XElement IterationCounts(AimRow row)
    {
        int most = row.Shots.Max(shot => shot.Result.Iterations);
        double[] counts = [.. Enumerable.Range(0, most + 1).Select(i => (double)row.Shots.Count(shot => shot.Result.Iterations == i))];
        var chart = new Chart(new Axis("iterations"), new Axis("kicks") { Min = 0 }) { Title = row.Name, PlotHeight = 130 };
        chart.Items.Add(new BarsItem([.. Enumerable.Range(0, most + 2).Select(i => i - 0.5)], counts) { Colour = Palette.Green });
        return chart.Draw();
    }

    /// <summary>Draws one quantity of every kick over another one, with one series per row.</summary>
    public static XElement Over(
        string title, string xTitle, string yTitle, Func<AimShot, double> x, Func<AimShot, double> y, IEnumerable<AimRow> rows, AxisScale scale = AxisScale.Linear)
    {
        var chart = new Chart(new Axis(xTitle), new Axis(yTitle) { Scale = scale }) { Title = title, PlotHeight = 180 };
        int series = 0;
        foreach (AimRow row in rows)
        {
            chart.Items.Add(new ScatterItem([.. row.Shots.Select(shot => new PlotPoint(x(shot), y(shot)))])
            {
                Label = row.Name,
                Colour = Palette.Series[series],
                Mark = series == 0 ? Mark.Ring : series == 1 ? Mark.Triangle : Mark.Dot,
                Size = 2.2,
            });
            series++;
        }

        return chart.Draw();
    }

    private static XElement Histogram(AimRow row, string axis, double[] values, string colour, IEnumerable<double> all)
    {
        var chart = new Chart(new Axis(axis) { Min = 0, Max = all.DefaultIfEmpty(1).Max() }, new Axis("kicks") { Min = 0 }) { Title = row.Name, PlotHeight = 130 };
        if (values.Length > 0)
        {
            chart.Items.Add(BarsItem.Histogram(values, Bars, colour));
        }

        return chart.Draw();
    }
}
