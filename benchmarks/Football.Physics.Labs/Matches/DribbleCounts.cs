namespace FootballPhysics.Labs.Matches;

/// <summary>Counts the positions of the ball while players dribble along paths with turns.</summary>
internal static class DribbleCounts
{
    private const int TouchesOfOne = 8;
    private const double Farthest = 1.5;

    public static void Play(LabRun run, int count)
    {
        var simulator = new Simulator();
        var touches = new Touches(spread: new TouchSpread { Draws = 0 });
        var counts = new LabCounts();
        double farthest = 0;
        double chances = 0;
        var misses = new List<double>();
        var paces = new List<double>();
        var log = new StepLog();
        var sure = new Touches();
        run.Each(count, "dribble", (random, i) =>
        {
            double pace = random.Uniform(2, 8);
            double angle = random.Uniform(0, 6.28);
            Vector3d player = Vector3d.Zero;
            Vector3d way = Heading(angle);

            // The ball reaches his feet rolling, sliding, skipping, or with a spin of its own.
            BallState ball = simulator.Launch(
                player + (0.5 * way) + new Vector3d(0, random.Chance(0.3) ? random.Uniform(0.11, 0.4) : 0.11, 0),
                new Vector3d(random.Uniform(-6, 6), random.Chance(0.3) ? random.Uniform(-2, 1) : 0, random.Uniform(-6, 6)),
                new Vector3d(random.Uniform(-30, 30), random.Uniform(-30, 30), random.Uniform(-30, 30)));
            bool isFar = false;
            bool isBehind = false;
            bool isLost = false;
            for (int k = 0; k < TouchesOfOne && !isLost; k++)
            {
                // Turn by up to 90°, with shorter touches at sharper turns.
                double turn = k == 0 ? 0 : random.Uniform(-Math.PI / 2, Math.PI / 2);
                angle += turn;
                way = Heading(angle);
                var request = new DribbleRequest { Position = player, Direction = way, RunSpeed = pace, Duration = random.Uniform(0.3, 0.6), Lead = 0.6 };
                Touch touch = touches.Dribble(in ball, request);
                counts.Add("touches");
                misses.Add(touch.Miss);
                paces.Add(touch.SpeedError);
                if (k == 1 && i % 10 == 0)
                {
                    chances += sure.Dribble(in ball, request).Chance;
                }

                isLost = !touch.Succeeds;
                simulator.Kick(ref ball, touch.Velocity, touch.Spin);
                int steps = (int)Math.Ceiling(request.Duration / 0.01);
                for (int n = 0; n < steps; n++)
                {
                    double h = request.Duration / steps;
                    simulator.Step(ref ball, h, log);
                    log.Clear();
                    player += h * pace * way;
                    Vector3d apart = (ball.Position - player).Horizontal;
                    farthest = Math.Max(farthest, apart.Length);
                    isFar |= apart.Length > Farthest;

                    // The ball must be ahead once he has turned: after the middle of a touch. At a turn of 90° it lies next to him at the touch.
                    isBehind |= Vector3d.Dot(apart, way) <= 0 && (n > steps / 2 || Math.Abs(turn) < 0.5);
                }
            }

            counts.Add("dribbles");
            counts.AddIf(isFar, "ball farther than 1.5 m from the player");
            counts.AddIf(isBehind, "ball behind the player");
            counts.AddIf(isLost, "lost: a touch that did not come off");
        });
        var off = new Spread(paces);
        LabTable table = run.Table("Dribbles at 2 to 8 m/s, turns of up to 90°", "of the dribbles", "count", "verdict");
        counts.AddTo(
            table, ("dribbles", false), ("touches", false), ("ball farther than 1.5 m from the player", true), ("ball behind the player", true), ("lost: a touch that did not come off", true));
        table.Count("farthest that the ball was, m", farthest);
        table.Count("where he wanted it, p95, m", new Spread(misses).P95);
        table.Count("pace off, mean, m/s", off.Mean);
        table.Count("pace off, p95, m/s", off.P95);
        table.Count("chance of a second touch with errors, mean", chances / Math.Max(1, (count + 9) / 10));
    }

    private static Vector3d Heading(double angle) => new(Math.Sin(angle), 0, -Math.Cos(angle));
}
