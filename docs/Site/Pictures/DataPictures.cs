using System.Xml.Linq;
using FootballPhysics.Batch;
using FootballPhysics.Drawing;
using FootballPhysics.Tracks;

namespace FootballPhysics.Site.Pictures;

/// <summary>Tracks from cameras, and how precise and how many balls are computed.</summary>
internal static class DataPictures
{
    /// <summary>The pixels of one camera, and the flight that was found from them.</summary>
    public static XElement Pixels()
    {
        TrackCamera camera = TrackCamera.LookingAt(new Vector3d(60, 25, 0), new Vector3d(0, 2, 0), focalLength: 3000, width: 1920, height: 1080);
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 8), velocity: new Vector3d(2, 7, -21), spin: new Vector3d(0, 40, 0));
        var pixels = new PixelPoint[50];
        for (int i = 0; i < pixels.Length; i++)
        {
            camera.TryProject(ball.Position, out double u, out double v);
            pixels[i] = new PixelPoint(0.02 * i, camera: 0, Math.Round(u), Math.Round(v), noise: 0.3);
            simulator.Run(ref ball, 0.01, 0.02, StopAt.Time, new StepLog());
        }

        TrackFitResult launch = new TrackFit(Scene.Measured).Find([camera], pixels, new TrackFitRequest { FromGround = true });
        var found = new List<PlotPoint>();
        BallState fitted = simulator.Launch(launch.Position, launch.Velocity, launch.Spin);
        for (int i = 0; i < 50; i++)
        {
            camera.TryProject(fitted.Position, out double u, out double v);
            found.Add(new PlotPoint(u, 1080 - v));
            simulator.Run(ref fitted, 0.01, 0.02, StopAt.Time, new StepLog());
        }

        Chart chart = Paths.Plot("The image of the camera", new Axis("u, pixels") { Min = 0, Max = 1920 }, new Axis("1080 − v, pixels") { Min = 0, Max = 1080 }, 232);
        chart.Items.Add(new PolylineItem(found) { Colour = Palette.Orange, Width = 1.5, Label = FormattableString.Invariant($"found: sidespin {launch.Spin.Y:F0} rad/s") });
        chart.Items.Add(new ScatterItem([.. pixels.Where((_, i) => i % 2 == 0).Select(pixel => new PlotPoint(pixel.U, 1080 - pixel.V))]) { Size = 2, Label = "every second pixel of the track" });
        return Paths.Picture("The pixels of a flight in the image of one camera, and the flight that the fit finds from them", chart);
    }

    /// <summary>The pieces of a track: two flights, a bounce and a header.</summary>
    public static XElement Pieces()
    {
        var scene = new Scene { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };
        var simulator = new Simulator(scene with { Air = new Air { Wind = new Vector3d(2, 0, 0) } });
        BallState ball = simulator.Launch(Paths.Start, velocity: new Vector3d(12, 9, -14), spin: new Vector3d(0, 30, 0));
        var track = new TrackPoint[200];
        for (int i = 0; i < track.Length; i++)
        {
            if (i == 110)
            {
                simulator.Kick(ref ball, velocity: new Vector3d(-11, 6, 9), spin: Vector3d.Zero);
            }

            track[i] = new TrackPoint(0.02 * i, ball.Position, noise: 1e-4);
            simulator.Step(ref ball, 0.02, new StepLog());
        }

        MatchFitResult match = new MatchFit(scene).Find(track);
        Chart chart = Paths.Plot("The pieces of a track", new Axis("time, s"), new Axis("height, m") { Min = 0 });
        foreach ((MatchPiece piece, int i) in match.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight).Select((piece, i) => (piece, i)))
        {
            PlotPoint[] fitted = [.. piece.Observed.Zip(piece.Fitted, (point, at) => new PlotPoint(point.Time, at.Y))];
            chart.Items.Add(new PolylineItem(fitted) { Colour = Palette.Series[i], Width = 2.2, Label = FormattableString.Invariant($"flight {i + 1}: {piece.Velocity.Length:F0} m/s") });
        }

        foreach ((MatchPieceKind kind, Mark mark, string colour) in new[] { (MatchPieceKind.Impact, Mark.Triangle, Palette.Red), (MatchPieceKind.Touch, Mark.Diamond, Palette.Purple) })
        {
            chart.Items.Add(new ScatterItem([.. match.Pieces.Where(piece => piece.Kind == kind).Select(piece => new PlotPoint(piece.StartTime, piece.Position.Y))]) { Mark = mark, Colour = colour, Label = $"{kind}" });
        }

        return Paths.Picture("The height of a tracked ball over time, divided into flights, impacts and a touch", chart);
    }

    /// <summary>The error of a landing point against the evaluations of the forces that it takes.</summary>
    public static XElement Work()
    {
        Vector3d truth = Landing(Integrator.Rk4, 0.0005);
        Chart chart = Paths.Plot("Accuracy and work", new Axis("evaluations of the forces per second of flight") { Scale = AxisScale.Logarithmic }, new Axis("error of the landing point, m") { Scale = AxisScale.Logarithmic }, 220);
        foreach ((Integrator integrator, int evaluations, string colour) in new[]
        {
            (Integrator.Euler, 1, Palette.Red), (Integrator.SemiImplicitEuler, 1, Palette.Purple), (Integrator.Rk2, 2, Palette.Green), (Integrator.Rk4, 4, Palette.Blue),
        })
        {
            PlotPoint[] points = [.. new[] { 0.1, 0.08, 0.05, 0.04, 0.02, 0.01, 0.005 }
                .Select(step => new PlotPoint(evaluations / step, Vector3d.Distance(truth, Landing(integrator, step)))).Where(point => point.Y > 1e-9)];
            chart.Items.Add(new PolylineItem(points) { Colour = colour, Width = 1.6, Label = $"{integrator}" });
            chart.Items.Add(new ScatterItem(points) { Colour = colour, Size = 2.5 });
        }

        return Paths.Picture("With the same number of evaluations, RK4 is a thousand times as accurate as RK2, and RK2 a thousand times as accurate as Euler", chart);

        static Vector3d Landing(Integrator integrator, double step)
        {
            var simulator = new Simulator(null, new SolverSettings { Integrator = integrator });
            Vector3d velocity = 27 / Math.Sqrt(1 + (0.3 * 0.3) + (0.28 * 0.28)) * new Vector3d(0.30, 0.28, -1);
            BallState ball = simulator.Launch(Paths.Start, velocity, new Vector3d(10, 60, 3));
            simulator.Run(ref ball, step, 10, StopAt.Impact, new StepLog());
            return ball.Position;
        }
    }

    /// <summary>Where ten thousand balls of one batch land, and how high they fly.</summary>
    public static XElement Batch()
    {
        // One thread and double precision: the picture must not depend on the registers of a machine.
        var batch = new BallBatch(Scene.Default, BatchSettings.For(Accuracy.Millimeter) with { Threads = 1, FindApex = true, Precision = BatchPrecision.Double });
        var launches = new BatchLaunches(10_000);
        var flights = new BatchFlights(10_000);
        for (int i = 0; i < launches.Capacity; i++)
        {
            launches.Set(i, Paths.Start, new Vector3d(0, 5 + (0.0005 * i), -22), new Vector3d(-20, 0.004 * i, 0));
        }

        batch.Fly(launches, flights, launches.Capacity);
        int[] shown = [.. Enumerable.Range(0, 200).Select(i => 50 * i)];
        Chart landing = Paths.Plot("Where 10 000 balls land", new Axis("distance, m"), new Axis("to the left, m"), 110);
        landing.Items.Add(new ScatterItem([.. shown.Select(i => Paths.FromAbove(new Vector3d(flights.Position.X[i], 0, flights.Position.Z[i])))]) { Size = 1.5, Label = "every 50th ball" });
        Chart apex = Paths.Plot("How high they fly", new Axis("upward speed at the kick, m/s"), new Axis("apex, m"), 110);
        apex.Items.Add(new PolylineItem([.. shown.Select(i => new PlotPoint(5 + (0.0005 * i), flights.Apex[i]))]) { Colour = Palette.Green, Width = 2 });
        return Paths.Picture("Landing points and greatest heights of the balls of one batch", landing, apex);
    }
}
