namespace FootballPhysics.Labs.Matches;

/// <summary>Counts first-time strikes of moving balls at a target: a predicted hit must also hit in the game.</summary>
internal static class FirstTimeCounts
{
    private const double Near = 0.01;

    public static void Play(LabRun run, int count)
    {
        var simulator = new Simulator();
        var touches = new Touches(spread: new TouchSpread { Draws = 0 });
        var sure = new Touches();
        var path = new Trajectory(4096);
        var counts = new LabCounts();
        double worst = 0;
        double chances = 0;
        int requests = 0;
        run.Each(count, "shot", (random, i) =>
        {
            bool high = random.Chance(0.5);
            Vector3d from = new(random.Uniform(-12, 12), high ? random.Uniform(0.15, 1.2) : 0.11, random.Uniform(8, 24));
            double speed = random.Uniform(0, 15);
            double angle = random.Uniform(0, 6.28);
            Vector3d velocity = speed * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            Vector3d spin = high ? random.Uniform(0, 40) * random.Direction() : new Vector3d(velocity.Z / 0.11, random.Uniform(-20, 20), -velocity.X / 0.11);
            BallState ball = simulator.Launch(from, high ? velocity + new Vector3d(0, random.Uniform(-4, 2), 0) : velocity, spin);
            var request = new FirstTimeRequest
            {
                Target = new Vector3d(random.Uniform(-3.5, 3.5), random.Uniform(0.2, 2.3), 0),
                Speed = random.Uniform(16, 28),
                TopSpin = random.Uniform(-20, 20),
                SideSpin = random.Uniform(-30, 30),
            };
            Touch touch = touches.FirstTimeShot(in ball, request);
            if (i % 20 == 0)
            {
                double chance = sure.FirstTimeShot(in ball, request).Chance;
                chances += double.IsNaN(chance) ? 0 : chance;
                requests++;
            }

            if (!touch.Succeeds)
            {
                counts.Add(touch.Status == TouchStatus.FootTooSlow ? "the foot is too slow" : "no touch does");
                return;
            }

            // Simulate in the game's own steps, with the foot itself.
            counts.Add("said to hit");
            FootStrike strike = touches.Foot.Strike(simulator.Scene.Ball, ball.Velocity, ball.Spin, touch.Strike.FootVelocity, touch.Strike.Normal);
            BallState kicked = ball;
            simulator.Kick(ref kicked, strike.Velocity, strike.Spin);
            simulator.LookAhead(in kicked, new LookAheadRequest { Duration = 5, TimeStep = 1 / 60.0 }, path);
            double miss = (path.ClosestApproach(request.Target).Position - request.Target).Length;
            worst = Math.Max(worst, miss);
            counts.AddIf(!(miss <= Near), "said to hit, and more than 1 cm off in the game");
        });
        LabTable table = run.Table("First-time shots at balls of up to 15 m/s", "of the shots", "count", "verdict");
        table.Count("shots", count);
        counts.AddTo(table, ("said to hit", false), ("said to hit, and more than 1 cm off in the game", true));
        table.Count("worst of those that are said to hit, m", worst);
        counts.AddTo(table, ("the foot is too slow", false), ("no touch does", false));
        table.Count("chance within half a metre with the foot's errors, mean", chances / Math.Max(1, requests));
    }
}
