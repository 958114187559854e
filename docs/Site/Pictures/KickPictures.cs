using System.Xml.Linq;
using FootballPhysics.Aiming;
using FootballPhysics.Drawing;
using FootballPhysics.Prediction;
using FootballPhysics.Shapes;

namespace FootballPhysics.Site.Pictures;

/// <summary>First kicks, a wall, predictions and kicks that were found: each is the program beside it.</summary>
internal static class KickPictures
{
    /// <summary>The first kick of the guide: its bounces, and where it slides, rolls and rests.</summary>
    public static XElement FirstKick()
    {
        var ball = new Ball();
        ball.Kick(speed: 25, direction: new Vector3d(0.1, 0.3, -1), topSpin: 0, sideSpin: 40);
        Trajectory path = Paths.Of(ball);
        double rolls = Paths.TimeOf(path, BallEventKind.Roll);
        Chart[] charts = [Paths.Side("From the side"), Paths.Above("From above")];
        Func<Vector3d, PlotPoint>[] views = [Paths.FromSide, Paths.FromAbove];
        for (int i = 0; i < 2; i++)
        {
            charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i], 0, rolls)) { Width = 2, Label = "flies and bounces" });
            charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i], rolls)) { Colour = Palette.Green, Width = 2, Label = "rolls" });
            charts[i].Items.Add(new ScatterItem(Paths.Events(path, views[i], BallEventKind.Impact)) { Colour = Palette.Orange, Size = 2.5, Label = "Impact" });
            charts[i].Items.Add(new ScatterItem(Paths.Events(path, views[i], BallEventKind.Rest)) { Mark = Mark.Diamond, Colour = Palette.Red, Label = "Rest" });
        }

        Chart.SameScale(charts);
        return Paths.Picture("The first kick bends to the left, bounces 15 times, rolls and comes to rest", charts);
    }

    /// <summary>The kick around a wall in the wind, on wet grass.</summary>
    public static XElement Wall()
    {
        var middle = new Vector3d(1.5, 0.92, -9.35);
        var half = new Vector3d(1.6, 0.92, 0.2);
        var scene = new Scene
        {
            Ground = Ground.Of(SurfaceMaterial.WetTurf),
            Air = new Air { Wind = new Vector3d(2, 0, 0) },
            Goals = [new Goal { Center = new Vector3d(0, 0, -22), Facing = new Vector3d(0, 0, 1) }],
            Obstacles = [new Obstacle { Name = "wall", Shape = new BoxShape(middle, half) }],
        };
        var ball = new Ball(scene);
        ball.Kick(speed: 25.5, direction: new Vector3d(0.26, 0.33, -0.91), topSpin: 12, sideSpin: 60);
        Trajectory path = Paths.Of(ball, 4, StopAt.Time);
        double net = Paths.TimeOf(path, BallEventKind.Net);
        Chart[] charts = [Paths.Side("From the side"), Paths.Above("From above", 130)];
        Func<Vector3d, PlotPoint>[] views = [Paths.FromSide, Paths.FromAbove];
        PlotPoint[][] walls =
        [
            [new(-middle.Z - half.Z, 0), new(-middle.Z + half.Z, 0), new(-middle.Z + half.Z, 2 * half.Y), new(-middle.Z - half.Z, 2 * half.Y)],
            [new(-middle.Z - half.Z, -middle.X - half.X), new(-middle.Z + half.Z, -middle.X - half.X), new(-middle.Z + half.Z, -middle.X + half.X), new(-middle.Z - half.Z, -middle.X + half.X)],
        ];
        PlotPoint[][] frames = [[new(22, 0), new(22, 2.44)], [new(22, -3.66), new(22, 3.66)]];
        for (int i = 0; i < 2; i++)
        {
            charts[i].Items.Add(new PolygonItem([walls[i]]) { Colour = Palette.Frame, Caption = "wall" });
            charts[i].Items.Add(new LinesItem([frames[i]]) { Colour = Palette.Posts, Width = 3, Caption = "goal" });
            charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i], 0, net)) { Width = 2 });
            charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i], net)) { Colour = Palette.Green, Width = 1.2, Label = "in the net, then on the ground" });
            charts[i].Items.Add(new ScatterItem(Paths.Events(path, views[i], BallEventKind.Goal)) { Colour = Palette.Orange, Label = "Goal" });
        }

        Chart.SameScale(charts);
        return Paths.Picture("The kick bends around the wall in a crosswind, and the net stops it behind the line", charts);
    }

    /// <summary>The queries of a look-ahead: apex, crossing of the goal line, first bounce and rest.</summary>
    public static XElement Ahead()
    {
        var goalLine = new Plane3d(new Vector3d(0, 0, -20), new Vector3d(0, 0, 1));
        Trajectory path = Paths.Of(new Scene(), new Vector3d(3, 7, -23), new Vector3d(10, 30, 0));
        path.TryGetCrossing(goalLine, out PathPoint crossing);
        path.TryGetRest(out BallEvent rest);
        Chart chart = Paths.Side("What a look-ahead answers", 110);
        chart.Items.Add(new LinesItem([[new(20, 0), new(20, 5)]]) { Colour = Palette.Frame, Width = 1.5, Label = "the plane" });
        chart.Items.Add(new PolylineItem(Paths.Points(path, Paths.FromSide)) { Width = 2, Label = "the path" });
        chart.Items.Add(Paths.Marked(Paths.FromSide(path.ApexPoint().Position), "ApexPoint", Palette.Green));
        chart.Items.Add(Paths.Marked(Paths.FromSide(crossing.Position), "TryGetCrossing", Palette.Orange, Mark.Diamond));
        chart.Items.Add(Paths.Marked(new PlotPoint(path.Carry, 0.11), "Carry", Palette.Red, Mark.Triangle));
        chart.Items.Add(Paths.Marked(Paths.FromSide(rest.Position), "TryGetRest", Palette.Purple, Mark.Square));
        return Paths.Picture("Apex, crossing of the goal line, first bounce and rest on one predicted path", chart);
    }

    /// <summary>Two predictions of a cache: the first one, and the one after a header.</summary>
    public static XElement Header()
    {
        var ball = new Ball();
        var prediction = new TrajectoryCache(ball.Simulator, new LookAheadRequest { Duration = 3 }, tolerance: 1e-3);
        ball.Kick(speed: 20, direction: new Vector3d(0, 0.3, -1), sideSpin: 25);
        var flown = new List<PlotPoint>();
        var predicted = new List<PlotPoint[]>();
        var at = new List<PlotPoint>();
        for (int tick = 1; tick <= 300; tick++)
        {
            flown.Add(Paths.FromAbove(ball.Position));
            ball.Step(0.01);
            if (tick == 120)
            {
                ball.Kick(velocity: new Vector3d(12, 5, 3), spin: default);
            }

            if (prediction.Update(ball.State))
            {
                at.Add(Paths.FromAbove(ball.Position));
                Trajectory path = prediction.Path;
                predicted.Add([.. Enumerable.Range(0, 60).Select(i => Paths.FromAbove(path.PositionAt(ball.Time + (0.05 * i))))]);
            }
        }

        Chart chart = Paths.Above("Predicted twice", 200);
        chart.Items.Add(new PolylineItem(predicted[0]) { Colour = Palette.Orange, Width = 5, Label = "predicted at the kick" });
        chart.Items.Add(new PolylineItem(predicted[1]) { Colour = Palette.Green, Width = 5, Label = "predicted at the header" });
        chart.Items.Add(new PolylineItem(flown) { Width = 1.6, Label = "the ball" });
        chart.Items.Add(new ScatterItem(at) { Colour = Palette.Red, Mark = Mark.Diamond, Captions = ["0.01 s", "1.20 s: a header"] });
        return Paths.Picture("The cached prediction holds until a header; then a second one replaces it", chart);
    }

    /// <summary>Three kicks that hit one target: low, high and slowest.</summary>
    public static XElement Arcs()
    {
        var aimer = new Aimer();
        var pass = new AimRequest { From = Paths.Start, Target = new Vector3d(2, 0.9, -24), Speed = 20, TopSpin = -15, MaximumElevationDegrees = 80 };
        Chart chart = Paths.Side("Three kicks to one target", 150);
        foreach ((string name, AimResult kick, string colour) in new[]
        {
            ("low", aimer.Find(pass), Palette.Blue), ("high", aimer.Find(pass with { Arc = AimArc.High }), Palette.Green), ("slowest", aimer.FindSlowest(pass), Palette.Orange),
        })
        {
            Trajectory path = Paths.Of(new Scene(), kick.Velocity, kick.Spin, kick.Time, StopAt.Time);
            chart.Items.Add(new PolylineItem(Paths.Points(path, Paths.FromSide)) { Colour = colour, Width = 2, Label = FormattableString.Invariant($"{name}: {kick.Speed:F1} m/s, {kick.Time:F2} s") });
        }

        chart.Items.Add(Paths.Marked(Paths.FromSide(pass.Target), "target", Palette.Red, Mark.Cross));
        return Paths.Picture("A low, a high and the slowest kick hit the same target", chart);
    }

    /// <summary>Three free kicks over the wall through one waypoint.</summary>
    public static XElement Waypoint()
    {
        var aimer = new Aimer();
        var freeKick = new AimRequest { From = Paths.Start, Waypoint = new Vector3d(-0.9, 2.2, -9.15), Target = new Vector3d(-3.3, 0.6, -25) };
        Chart chart = Paths.Plot("Over the wall at three speeds", new Axis("time, s"), new Axis("height, m") { Min = 0 });
        foreach ((double speed, string colour) in new[] { (24.0, Palette.Blue), (28.0, Palette.Green), (32.0, Palette.Orange) })
        {
            AimResult kick = aimer.Find(freeKick with { Speed = speed });
            Trajectory path = Paths.Of(new Scene(), kick.Velocity, kick.Spin, kick.Time, StopAt.Time);
            path.TryGetCrossing(new Plane3d(freeKick.Waypoint!.Value, new Vector3d(0, 0, 1)), out PathPoint wall);
            chart.Items.Add(new PolylineItem([.. Enumerable.Range(0, 101).Select(i => 0.01 * i * path.EndTime).Select(time => new PlotPoint(time, path.PositionAt(time).Y))]) { Colour = colour, Width = 2, Label = FormattableString.Invariant($"{speed:F0} m/s, topspin {kick.TopSpin:F0} rad/s") });
            chart.Items.Add(new ScatterItem([new(wall.Time, wall.Position.Y)]) { Colour = Palette.Red, Mark = Mark.Diamond, Label = "Waypoint" });
            chart.Items.Add(new ScatterItem([new(path.EndTime, path.PositionAt(path.EndTime).Y)]) { Colour = Palette.Red, Mark = Mark.Cross, Label = "Target" });
        }

        return Paths.Picture("The height over time of three kicks through one waypoint over the wall to one target; the faster one needs more topspin", chart);
    }

    /// <summary>A ball that is dropped onto three surfaces, over time.</summary>
    public static XElement Drop()
    {
        Chart chart = Paths.Plot("Dropped from 2 m", new Axis("time, s"), new Axis("height, m") { Min = 0 });
        foreach ((double share, string colour) in new[] { (0.5, Palette.Orange), (SurfaceMaterial.DryTurf.NormalRestitution, Palette.Blue), (0.85, Palette.Green) })
        {
            var ball = new Ball(new Scene { Ground = Ground.Of(SurfaceMaterial.DryTurf with { NormalRestitution = share }) });
            ball.Place(new Vector3d(0, 2, 0));
            Trajectory path = Paths.Of(ball, 3, StopAt.Time);
            chart.Items.Add(new PolylineItem([.. Enumerable.Range(0, 151).Select(i => new PlotPoint(0.02 * i, path.PositionAt(0.02 * i).Y))]) { Colour = colour, Width = 2, Label = FormattableString.Invariant($"{share:F2}") });
        }

        return Paths.Picture("The height of a dropped ball over time for three values of NormalRestitution", chart);
    }

    /// <summary>The two shots that the page about the command line replays.</summary>
    public static XElement TwoShots()
    {
        Chart[] charts = [Paths.Side("From the side"), Paths.Above("From above")];
        Func<Vector3d, PlotPoint>[] views = [Paths.FromSide, Paths.FromAbove];
        foreach ((string file, Vector3d velocity, double sideSpin, string colour) in new[]
        {
            ("shot.json", new Vector3d(5, 7, -24), 60.0, Palette.Blue), ("other.json", new Vector3d(0, 7, -24), 0.0, Palette.Orange),
        })
        {
            Trajectory path = Paths.Of(new Scene(), velocity, new Vector3d(0, sideSpin, 0), 5, StopAt.Time);
            for (int i = 0; i < 2; i++)
            {
                charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i])) { Colour = colour, Width = 2, Label = file });
                charts[i].Items.Add(new ScatterItem(Paths.Events(path, views[i], BallEventKind.Impact)) { Colour = colour, Size = 2.5 });
            }
        }

        Chart.SameScale(charts);
        return Paths.Picture("A shot with sidespin and one without, from the side and from above", charts);
    }

    /// <summary>A ball hits a leg that comes towards it: the program of the C page.</summary>
    public static XElement Leg()
    {
        var bodies = new KinematicBodies();
        KinematicBody leg = bodies.Add("leg", new CapsuleShape(new Vector3d(0, -0.4, 0), new Vector3d(0, 0.4, 0), 0.1), SurfaceMaterial.Boot, mass: 5);
        var runner = new FixedStepRunner(new Simulator(Scene.Default with { Bodies = bodies }), timeStep: 1.0 / 60);
        runner.MoveBodies = time => leg.MoveTo(new Vector3d(0, 0.5, -6 + time), new Vector3d(0, 0, 1), time);
        runner.QueueKick(new Vector3d(0, 1, -12), Vector3d.Zero);
        var ball = new List<PlotPoint>();
        double hit = 0;
        for (int tick = 0; tick < 120; tick++)
        {
            ball.Add(new PlotPoint(runner.State.Time, -runner.State.Position.Z));
            runner.Step();
            foreach (BallEvent happened in runner.Events)
            {
                hit = happened.ColliderIndex > 0 && hit == 0 ? happened.Time : hit;
            }
        }

        Chart chart = Paths.Plot("A ball and a leg", new Axis("time, s"), new Axis("distance, m"), 150);
        chart.Items.Add(new PolylineItem([new(0, 6), new(2, 4)]) { Colour = Palette.Orange, Width = 4, Label = "the leg, moved by the game" });
        chart.Items.Add(new PolylineItem(ball) { Width = 2, Label = "the ball" });
        chart.Items.Add(Paths.Marked(new PlotPoint(hit, 6 - hit - 0.1), FormattableString.Invariant($"impact after {hit:F3} s"), Palette.Red, Mark.Diamond));
        return Paths.Picture("The distance of a ball and of a leg over time: the ball flies at the leg, hits it and comes back", chart);
    }
}
