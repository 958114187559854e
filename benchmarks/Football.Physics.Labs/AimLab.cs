using System.CommandLine;
using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs;

/// <summary>football lab aim: runs the thesis' experiments with predictors, and the library's own solver on the same requests.</summary>
internal static class AimLab
{
    private const int Requests = 10_000;
    private const int ScanEvery = 4;

    public static Lab Create()
    {
        var lab = new Lab(
            "aim",
            "Aims of the original thesis (tests 4.1.3, 4.2.3 and 4.3.2), and 10 000 random requests compared with a dense scan. The CSV lists every kick.",
            ["football lab aim --quick --csv kicks.csv", "football lab aim --profiles --quick"],
            isDrawn: true);
        Option<bool> quick = lab.Quick();
        Option<bool> full = lab.Flag("--full", "Compare every random request that was not hit with the dense scan, not one in four.");
        Option<bool> profiles = lab.Flag("--profiles", "Only the random requests, in both profiles, with weather, wind by height and gusts.");
        return lab.Plays(run =>
        {
            int count = run.Get(quick) ? Requests / 20 : Requests;
            if (run.Get(profiles))
            {
                ProfileAims.Run(run, count);
                return;
            }

            new AimExperiments(run, run.Get(quick)).Run();
            run.Progress.Report(() => "random requests");
            int seed = unchecked((int)run.Seed);
            LabCounts verdicts = AimVerdicts.Of(
                run, "Random requests (5 to 40 m/s, spins, winds, laws, 1 to 70 m, heights, elevation bounds; 1 mm), direct, held against a dense scan",
                index => AimAnything.Scene(seed, index), count, run.Get(full) ? 1 : ScanEvery);
            run.Failed |= !AimVerdicts.Hold(verdicts);
        });
    }
}

/// <summary>The thesis' experiments with its predictors (4.1.3, 4.2.3, 4.3.2), next to the library's own solver.</summary>
internal sealed class AimExperiments(LabRun run, bool quick)
{
    private readonly int _seed = unchecked((int)run.Seed);
    private readonly List<XElement> _tiles = [];
    private readonly AimBench _fine = AimBench.Rk2(0.01);
    private readonly AimBench _coarse = AimBench.Rk2(0.04);

    private int Count => quick ? 100 : 1000;

    /// <summary>Runs all experiments. Each adds a table, its kicks, its findings and its charts.</summary>
    public void Run()
    {
        run.Rows = new LabTable(
            "kick", "section", "method", "distance", "speed", "status", "miss", "throughMiss", "elevation", "top", "side", "iterations", "simulations", "microseconds");
        run.Picture = () => Figure.Stack("Aiming", [.. _tiles]);
        foreach (Action experiment in (Action[])[MethodA, HighElevations, Studio, MethodB, TwoPoints, Targets])
        {
            run.Progress.Report(() => experiment.Method.Name);
            experiment();
        }
    }

    /// <summary>4.1.3: Method A at 10 and 40 ms.</summary>
    private void MethodA()
    {
        AimRequest[] requests = AimSets.Thesis(_seed, Count);
        AimRow[] rows =
        [
            new("A, 10 ms", _fine.Run(requests, AimMethod.Angle)) { Thesis = "4.0 mm, worst 12; 1750 µs" },
            new("A, 40 ms", _coarse.Run(requests, AimMethod.Angle)) { Thesis = "5.1 mm, worst 14; 490 µs" },
            Direct("direct", _fine.Run(requests, AimMethod.Direct), 2.5),
        ];
        Add(
            "4.1.3, Method A: 25 m/s, spin (20, 10), 15 to 25 m, at most 30°, 1 cm, RK2", rows,
            Charts(rows),
            "True misses: the thesis measured its own at 10 ms.");
    }

    /// <summary>4.1.3, limits: method A beyond 30°, and the other methods there.</summary>
    private void HighElevations()
    {
        AimRequest[] requests = AimSets.Farther(15, 60, quick ? 46 : 181);
        AimRow[] rows =
        [
            new("A", _fine.Run(requests, AimMethod.Angle)) { Thesis = "diverges beyond 30°" },
            new("B", _fine.Run(requests, AimMethod.Bisection)) { Thesis = "about 10 iterations, at most 11" },
            new("direct", _fine.Run(requests, AimMethod.Direct)),
        ];
        Add(
            "4.1.3 and 4.2.3, limits: the same kick from 15 to 60 m, at most 45°, RK2 at 10 ms", rows,
            [
                Iterations(rows),
                AimCharts.Over("Elevation against distance", "distance, m", "elevation, °", shot => shot.Distance, shot => shot.Elevation, rows),
                AimCharts.Over("Time against distance", "distance, m", "µs", shot => shot.Distance, shot => shot.Microseconds, rows, AxisScale.Logarithmic),
                AimCharts.Over("True miss against distance", "distance, m", "m", shot => shot.Distance, shot => Math.Max(1e-6, shot.Miss), rows, AxisScale.Logarithmic),
            ]);
    }

    /// <summary>4.1.3: the setting of the studio's comparison.</summary>
    private void Studio()
    {
        AimRequest[] requests = AimSets.Studio(_seed + 1, quick ? 500 : 5000);
        var own = new AimBench(AimSets.StudioScene, AimSets.StudioSettings, AimSets.StudioStep, judgeOwn: true);
        var truth = new AimBench(AimSets.StudioScene, AimSets.StudioSettings, AimSets.StudioStep);
        AimShot[] shots = own.Run(requests, AimMethod.Angle);
        AimRow a = new("A, miss in its own integrator", shots)
        {
            Thesis = "3.7 mm; 261 µs; at most 5 iterations (studio: 200–300 µs)",
            Reach = ("at most 5 iterations", shots.Max(shot => shot.Result.Iterations) <= 5),
        };
        AimRow[] rows = [a, new("the same kicks, true miss", [.. shots.Select(shot => shot with { Miss = shot.Result.Miss })]), Direct("direct", truth.Run(requests, AimMethod.Direct), 2.5)];
        Add(
            "4.1.3, the studio's setting: constant coefficients, semi-implicit Euler at 60 Hz, 20 to 30 m/s, spins within ±20", rows,
            [AimCharts.Times(a, [a]), AimCharts.Misses(a, [a]), AimCharts.IterationCounts(a)],
            "The method hits in its own integrator, which is itself centimetres off the reference.");
    }

    /// <summary>4.2.3: Method B in the experiment of 4.1.3.</summary>
    private void MethodB()
    {
        AimRequest[] requests = AimSets.Thesis(_seed, Count);
        AimRow[] rows =
        [
            new("B, 10 ms", _fine.Run(requests, AimMethod.Bisection)) { Thesis = "4.5 mm; 3450 µs; at most 11 iterations" },
            new("B, 40 ms", _coarse.Run(requests, AimMethod.Bisection)) { Thesis = "5 mm; 950 µs" },
        ];
        Add("4.2.3, Method B in the experiment of 4.1.3", rows, Charts(rows));
    }

    /// <summary>4.3.2: both free kicks.</summary>
    private void TwoPoints()
    {
        int speeds = quick ? 41 : 161;
        FreeKick("4.3.2, first: around the wall into the top left corner, 25 m, 20 to 40 m/s, RK2 at 40 ms", AimSets.AroundTheWall(speeds), "4.5 mm, worst 12; 4900 µs");
        FreeKick("4.3.2, second: over the wall into the bottom left corner", AimSets.OverTheWall(speeds), "4.7 mm; 4900 µs");
    }

    /// <summary>The targets of the library's own solver, next to the thesis' experiments.</summary>
    private void Targets()
    {
        AimShot[] points = _fine.Run(AimSets.TwoPoint(_seed + 2, Count), AimMethod.Direct);
        AimShot[] far = _fine.Run(AimSets.TooFar(_seed + 3, Count), AimMethod.Direct);
        AimShot[] thesis = _coarse.Run([.. points.Select(shot => shot.Request)], AimMethod.TwoPoint);
        var two = new AimRow("direct, two points within the spins' limits", points);
        AimRow[] rows =
        [
            two with
            {
                Thesis = "nobody",
                Reach = ("≤ 1 mm, ≤ 1 cm at the point, ≤ 4 simulations", two.Miss.Worst <= 1e-3 && two.ThroughMiss!.Worst <= 1e-2 && two.Simulations.Mean <= 4),
            },
            new("the thesis' two-point method on them, 40 ms", thesis),
            new("direct, too far by 4 to 15 % of the speed", far) { Reach = ("no hit but a true one", far.All(shot => shot.Result.Status == AimStatus.OutOfReach || shot.Result.Miss <= 1e-3)) },
        ];
        Add("The library's own solver: two points that can be passed, and targets that cannot be reached", rows, []);
    }

    private static XElement[] Charts(AimRow[] rows) =>
    [
        AimCharts.Misses(rows[0], rows), AimCharts.Times(rows[0], rows), AimCharts.Misses(rows[1], rows), AimCharts.Times(rows[1], rows), Iterations(rows),
    ];

    private static XElement Iterations(AimRow[] rows) =>
        AimCharts.Over("Iterations against distance", "distance, m", "iterations", shot => shot.Distance, shot => shot.Result.Iterations, rows);

    private static AimRow Direct(string name, AimShot[] shots, double simulations)
    {
        var row = new AimRow(name, shots);
        return row with { Reach = (FormattableString.Invariant($"≤ 1 mm always, ≤ {simulations} simulations"), row.Miss.Worst <= 1e-3 && row.Simulations.Mean <= simulations) };
    }

    /// <summary>Adds an experiment: its rows, its kicks, its charts and its finding.</summary>
    private void Add(string title, AimRow[] rows, XElement[] charts, string remark = "")
    {
        LabTable table = run.Table(title, AimRow.Columns);
        foreach (AimRow row in rows)
        {
            run.Failed |= row.Reach is { Reached: false };
            table.Add(row.Cells);
            run.Rows!.Rows.AddRange(row.Shots.Select(shot => new object?[]
            {
                title, row.Name, shot.Distance, shot.Request.Speed, Words.Of(shot.Result.Status), shot.Miss, shot.Result.WaypointMiss,
                shot.Elevation, shot.TopSpin, shot.SideSpin, shot.Result.Iterations, shot.Result.Simulations, shot.Microseconds,
            }));
        }

        if (charts.Length > 0)
        {
            _tiles.Add(Figure.Tile(title, charts));
        }

        if (remark.Length > 0)
        {
            run.Notes.Add($"{title}: {remark}");
        }
    }

    private void FreeKick(string title, AimRequest[] requests, string thesis)
    {
        AimRow[] rows =
        [
            new("two-point, 40 ms", _coarse.Run(requests, AimMethod.TwoPoint)) { Thesis = thesis },
            new("direct", _coarse.Run(requests, AimMethod.Direct)),
        ];
        Add(
            title, rows,
            [
                AimCharts.Over("Miss at the target against speed", "speed, m/s", "mm", shot => shot.Request.Speed, shot => Math.Max(1e-3, 1e3 * shot.Miss), rows, AxisScale.Logarithmic),
                AimCharts.Over("Miss at the point against speed", "speed, m/s", "m", shot => shot.Request.Speed, shot => shot.Result.WaypointMiss ?? 0, rows),
                AimCharts.Over("Sidespin against speed", "speed, m/s", "rad/s", shot => shot.Request.Speed, shot => shot.SideSpin, rows),
                AimCharts.Over("Topspin against speed", "speed, m/s", "rad/s", shot => shot.Request.Speed, shot => shot.TopSpin, rows),
                AimCharts.Over("Time against speed", "speed, m/s", "µs", shot => shot.Request.Speed, shot => shot.Microseconds, rows, AxisScale.Logarithmic),
            ],
            string.Join(' ', rows.Select(row => $"{row.Name}: sidespin at its limit {Saturated(row, shot => shot.SideSpin)}, topspin {Saturated(row, shot => shot.TopSpin)}.")));
    }

    private static string Saturated(AimRow row, Func<AimShot, double> spin)
    {
        AimShot[] at = [.. row.Shots.Where(shot => Math.Abs(spin(shot)) > 39.999)];
        return at.Length == 0 ? "nowhere" : FormattableString.Invariant($"in {at.Length} of {row.Shots.Count} ({at.Min(shot => shot.Request.Speed):0.0} to {at.Max(shot => shot.Request.Speed):0.0} m/s)");
    }
}

/// <summary>Solves the same requests in scenes of both profiles, and counts the kicks found, the flights and the errors.</summary>
internal static class ProfileAims
{
    private const double Tolerance = 1e-3;

    private static readonly Vector3d s_wind = new(4, 0, -6);

    /// <summary>The scenes; the published profile first.</summary>
    public static IReadOnlyList<(string Name, Scene Scene)> Scenes { get; } =
    [
        ("published", Scene.Published),
        ("published, wind of 7 m/s", Scene.Published with { Air = new Air { Wind = s_wind } }),
        ("measured", Scene.Measured),
        ("measured, wind of 7 m/s", Scene.Measured with { Air = new Air { Wind = s_wind } }),
        ("measured, Jabulani at 2240 m", Scene.Measured with { Ball = BallProperties.Jabulani, Air = Weather.AtAltitude(2240).ToAir() }),
        ("measured, wind by height of 8 m/s", Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, -2) } }),
        ("measured, gusts of 8 m/s", Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, -2, gusts: new Gusts { Seed = 7 }) } }),
    ];

    /// <summary>Aims kicks of 20 to 30 m/s with spin at points in the goal, to a millimetre.</summary>
    public static (int Hits, double Simulations, int Most, double Worst) Of(Scene scene, int seed, int count)
    {
        var aimer = new Aimer(scene);
        int hits = 0;
        long simulations = 0;
        int most = 0;
        double worst = 0;
        foreach (AimRequest request in AimSets.Studio(seed, count))
        {
            AimResult result = aimer.Find(request with { Tolerance = Tolerance });
            simulations += result.Simulations;
            most = Math.Max(most, result.Simulations);
            if (result.Status == AimStatus.Hit)
            {
                hits++;
                worst = Math.Max(worst, result.Miss);
            }
        }

        return (hits, (double)simulations / count, most, worst);
    }

    public static void Run(LabRun run, int count)
    {
        LabTable table = run.Table("Kicks of 20 to 30 m/s from 14 to 20 m, to 1 mm, direct", "scene", "requests", "hits", "flights a request", "at most", "worst true miss, mm");
        foreach ((string name, Scene scene) in Scenes)
        {
            run.Progress.Report(() => name);
            (int hits, double simulations, int most, double worst) = Of(scene, unchecked((int)run.Seed), count);
            table.Add(name, count, hits, simulations, most, 1e3 * worst);
            run.Failed |= hits < count || worst > Tolerance;
        }
    }
}
