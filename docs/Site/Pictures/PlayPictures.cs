using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Batch;
using FootballPhysics.Prediction;

namespace FootballPhysics.Site.Pictures;

/// <summary>Who gets to a ball, which pass is open, and where a player's kicks go.</summary>
internal static class PlayPictures
{
    private static readonly Vector3d s_start = new(0, 0.11, 0);

    /// <summary>Two runners, how far each can be by some times, and where they first meet the ball.</summary>
    public static XElement Reach()
    {
        var simulator = new Simulator();
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(s_start, new Vector3d(3, 6, -20), new Vector3d(0, 40, 0)), new LookAheadRequest { Duration = 3, StopAt = StopAt.Time }, path);
        Player[] runners = [new Player { Position = new Vector3d(2, 0, -24) }, new Player { Position = new Vector3d(-6, 0, -35), Velocity = new Vector3d(3, 0, 4), Speed = 8.5 }];
        var query = new Interception();
        query.Find(path, runners);
        var chart = Above("Who gets to the ball first", 220);
        double[] times = [0.5, 1, 1.5, 2];
        for (int i = 0; i < runners.Length; i++)
        {
            Player runner = runners[i];
            string colour = i == 0 ? Palette.Red : Palette.Purple;
            chart.Items.Add(new LinesItem([.. times.Select(time => Ring(At(runner, Math.Min(time, runner.Reaction)), Covers(runner, time)))]) { Colour = colour, Width = 1, Label = $"runner {i} can be there after ½, 1, 1½, 2 s" });
        }

        chart.Items.Add(new PolylineItem([.. Every(path, 0.02)]) { Width = 2, Label = "the ball" });
        chart.Items.Add(new ScatterItem([.. times.Select(time => Seen(path.PositionAt(time)))]) { Size = 3, Captions = ["½ s", "1 s", "1½ s", "2 s"] });
        for (int i = 0; i < runners.Length; i++)
        {
            string colour = i == 0 ? Palette.Red : Palette.Purple;
            InterceptWindow first = query.WindowsOf(i)[0];
            chart.Items.Add(new ScatterItem([Seen(runners[i].Position)]) { Colour = colour, Size = 5, Captions = [$"runner {i}"] });
            chart.Items.Add(new ScatterItem([Seen(first.Position)]) { Colour = colour, Mark = Mark.Diamond, Size = 4.5, Label = "where he first meets it", Captions = [FormattableString.Invariant($"{first.From:F2} s")] });
        }

        return Svg.Standing("Two runners, how far each can be by some times, and where they meet the ball", Figure.Stack("", chart.Draw()));
    }

    /// <summary>Passes of one speed along the ground in all directions of a fan, which of them are open, and the best of the whole fan.</summary>
    public static XElement Fan()
    {
        Player[] mates = [new Player { Position = new Vector3d(5, 0, -30), Velocity = new Vector3d(1, 0, -4) }, new Player { Position = new Vector3d(-12, 0, -25) }];
        Player[] opponents = [new Player { Position = new Vector3d(2, 0, -22) }, new Player { Position = new Vector3d(8, 0, -24) }, new Player { Position = new Vector3d(-8, 0, -18) }];
        var fan = new PassFan(Scene.Measured);
        var request = new PassFanRequest { From = s_start, Direction = new Vector3d(0, 0, -1), MinimumElevationDegrees = 0, MaximumElevationDegrees = 0, Elevations = 1, MinimumSpeed = 26, MaximumSpeed = 26, Speeds = 1, FanDegrees = 80 };
        PassResult best = fan.Find(request with { Directions = 81 }, mates, opponents);
        var shut = new List<PlotPoint[]>();
        var open = new List<PlotPoint[]>();
        for (int i = 0; i < 41; i++)
        {
            (double left, double forward) = Math.SinCos(((2 * i) - 40) * Math.PI / 180);
            var direction = new Vector3d(-left, 0, -forward);
            PassResult pass = fan.Find(request with { Direction = direction, Directions = 1, FanDegrees = 0 }, mates, opponents);
            bool isOpen = pass.IsFound;
            (isOpen ? open : shut).Add(Pass(26 * direction, isOpen ? pass.Meeting.Time : 2.2));
        }

        var chart = Above("Passes along the ground at 26 m/s", 260);
        chart.Items.Add(new LinesItem(shut) { Colour = Palette.Frame, Width = 1, Label = "an opponent can be there first" });
        chart.Items.Add(new LinesItem(open) { Colour = Palette.Green, Width = 1.6, Label = "a team mate is first" });
        chart.Items.Add(new PolylineItem(Pass(best.Velocity, best.Meeting.Time)) { Colour = Palette.Blue, Width = 3, Label = "the earliest" });
        chart.Items.Add(new ScatterItem([.. mates.Select(mate => Seen(mate.Position))]) { Colour = Palette.Green, Size = 5, Label = "team mates", Captions = ["0", "1"] });
        chart.Items.Add(new ScatterItem([.. opponents.Select(opponent => Seen(opponent.Position))]) { Colour = Palette.Red, Size = 5, Mark = Mark.Cross, Label = "opponents" });
        chart.Items.Add(new ScatterItem([Seen(best.Meeting.Position)]) { Mark = Mark.Diamond, Size = 4.5, Captions = [FormattableString.Invariant($"met after {best.Meeting.Time:F2} s")] });
        return Svg.Standing("A fan of passes along the ground: which of them a team mate meets first, and the earliest of them", Figure.Stack("", chart.Draw()));
    }

    /// <summary>Two hundred penalties of one player, and the ellipses in which they go.</summary>
    public static XElement Misses()
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };
        var velocity = new Vector3d(-6.4, 4.4, -23);
        var spread = new KickSpread { SpeedPercent = 3, ElevationDegrees = 1.2, AzimuthDegrees = 1.5 };
        GoalChanceResult chance = new GoalChance(Scene.Measured).Find(s_start, velocity, Vector3d.Zero, spread, goal);
        var simulator = new Simulator();
        var random = new Random(11);
        var hits = new List<PlotPoint>();
        var path = new Trajectory();
        for (int i = 0; i < 200; i++)
        {
            (Vector3d kicked, Vector3d spin) = spread.Draw(random, velocity, Vector3d.Zero);
            simulator.LookAhead(simulator.Launch(s_start, kicked, spin), new LookAheadRequest { Duration = 0.8 }, path);
            double before = 0;
            double after = path.EndTime;
            for (int k = 0; k < 40; k++)
            {
                double middle = 0.5 * (before + after);
                (before, after) = path.PositionAt(middle).Z > goal.Center.Z ? (middle, after) : (before, middle);
            }

            Vector3d at = path.PositionAt(after);
            hits.Add(new PlotPoint(at.X, at.Y));
        }

        var chart = new Chart(new Axis("to the right of the middle, m") { Min = -4.6, Max = 0.4 }, new Axis("height, m") { Min = 0, Max = 3.2 }) { Title = "200 penalties of one player", Width = DocPictures.Width, EqualScales = true, PlotHeight = 120, MaximumPlotHeight = 300 };
        const double half = 3.72;
        chart.Items.Add(new LinesItem([.. Enumerable.Range(0, 25).Select(i => -3.66 + (i * 0.305)).Select(x => (PlotPoint[])[new(x, 0), new(x, 2.44)]), .. Enumerable.Range(0, 9).Select(i => i * 0.305).Select(y => (PlotPoint[])[new(-3.66, y), new(3.66, y)])]) { Colour = Palette.Grid, Width = 0.6 });
        chart.Items.Add(new LinesItem([[new(-half, 0), new(-half, 2.5), new(half, 2.5), new(half, 0)]]) { Colour = Palette.Posts, Width = 2, Thickness = 0.12 });
        chart.Items.Add(new ScatterItem([.. hits.Where(IsIn)]) { Colour = Palette.Green, Size = 2, Label = "in" });
        chart.Items.Add(new ScatterItem([.. hits.Where(at => !IsIn(at))]) { Colour = Palette.Red, Size = 2, Label = "not in" });
        chart.Items.Add(new LinesItem([Ellipse(chance, 1), Ellipse(chance, 2)]) { Colour = Palette.Orange, Width = 2, Label = FormattableString.Invariant($"1 and 2 standard deviations: in with {100 * chance.OnTarget:F0} %") });
        return Svg.Standing("Where 200 penalties of a player go who errs by 3 % of the speed and 1.5 degrees, and the ellipses of one and two standard deviations", Figure.Stack("", chart.Draw()));

        static bool IsIn(PlotPoint at) => Math.Abs(at.X) < 3.55 && at.Y < 2.33;
    }

    private static PlotPoint[] Ellipse(GoalChanceResult chance, double deviations)
    {
        (double sin, double cos) = Math.SinCos(chance.AxisDegrees * Math.PI / 180);
        return [.. Enumerable.Range(0, 49).Select(i => Math.SinCos(i * Math.PI / 24)).Select(t =>
        {
            (double along, double across) = (deviations * chance.LongAxis * t.Cos, deviations * chance.ShortAxis * t.Sin);
            return new PlotPoint(-(chance.Aside + (along * cos) - (across * sin)), chance.Height + (along * sin) + (across * cos));
        })];
    }

    private static Chart Above(string title, double height) => new(new Axis("along, m"), new Axis("to the left, m"))
    {
        Title = title,
        Width = DocPictures.Width,
        EqualScales = true,
        PlotHeight = height,
        Background = Palette.Grass,
    };

    private static PlotPoint Seen(Vector3d at) => new(-at.Z, -at.X);

    private static IEnumerable<PlotPoint> Every(Trajectory path, double step) => Enumerable.Range(0, (int)(path.EndTime / step) + 1).Select(i => Seen(path.PositionAt(i * step)));

    private static PlotPoint[] Pass(Vector3d velocity, double seconds)
    {
        var simulator = new Simulator();
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(s_start, velocity, Vector3d.Zero), new LookAheadRequest { Duration = seconds, StopAt = StopAt.Time }, path);
        return [.. Every(path, 0.1), Seen(path.PositionAt(path.EndTime))];
    }

    private static Vector3d At(Player runner, double seconds) => runner.Position + (seconds * runner.Velocity);

    /// <summary>How far from there he can be, his reach included: as <see cref="Player"/> says.</summary>
    private static double Covers(Player runner, double time)
    {
        double s = Math.Max(0, time - runner.Reaction);
        double toTop = runner.Speed / runner.Acceleration;
        return runner.Reach + (s <= toTop ? 0.5 * runner.Acceleration * s * s : runner.Speed * (s - (0.5 * toTop)));
    }

    private static PlotPoint[] Ring(Vector3d middle, double radius) =>
        [.. Enumerable.Range(0, 49).Select(i => Math.SinCos(i * Math.PI / 24)).Select(at => Seen(middle + (radius * new Vector3d(at.Sin, 0, at.Cos))))];
}
