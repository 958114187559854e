namespace FootballPhysics.Labs.Matches;

/// <summary>Counts balls that a player traps, and their speed relative to him afterwards.</summary>
internal static class TrapCounts
{
    private const double Dead = 0.3;

    public static void Play(LabRun run, int count)
    {
        var simulator = new Simulator();
        var touches = new Touches(spread: new TouchSpread { Draws = 0 });
        var sure = new Touches();
        int alive = 0;
        int unsaid = 0;
        double chances = 0;
        int requests = 0;
        var after = new List<double>();
        var settled = new List<double>();
        var away = new List<double>();
        run.Each(count, "trap", (random, i) =>
        {
            bool high = random.Chance(0.4);
            double angle = random.Uniform(0, 6.28);
            Vector3d velocity = random.Uniform(2, 15) * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            Vector3d spin = high || random.Chance(0.3)
                ? random.Uniform(0, 40) * random.Direction()
                : new Vector3d(velocity.Z / 0.11, random.Uniform(-10, 10), -velocity.X / 0.11);
            BallState ball = simulator.Launch(
                new Vector3d(0, high ? random.Uniform(0.15, 0.8) : 0.11, 0), high ? velocity + new Vector3d(0, random.Uniform(-5, 1), 0) : velocity, spin);
            double run = random.Uniform(0, 6.28);
            Vector3d player = random.Chance(0.5) ? Vector3d.Zero : random.Uniform(1, 6) * new Vector3d(Math.Cos(run), 0, Math.Sin(run));
            var request = new TrapRequest { Velocity = player };
            Touch touch = touches.Trap(in ball, request);
            if (i % 20 == 0)
            {
                chances += sure.Trap(in ball, request).Chance;
                requests++;
            }

            FootStrike strike = touches.Foot.Strike(simulator.Scene.Ball, ball.Velocity, ball.Spin, touch.Strike.FootVelocity, touch.Strike.Normal);
            BallState kicked = ball;
            simulator.Kick(ref kicked, strike.Velocity, strike.Spin);
            after.Add((kicked.Velocity - player).Horizontal.Length);
            simulator.Run(ref kicked, 1 / 60.0, request.Duration, StopAt.Time, new StepLog());
            double off = (kicked.Velocity - player).Horizontal.Length;
            settled.Add(off);
            away.Add(touch.Miss);
            alive += off < Dead ? 0 : 1;
            unsaid += off >= Dead && touch.Succeeds ? 1 : 0;
        });
        var then = new Spread(settled);
        LabTable table = run.Table("Traps of balls of up to 15 m/s, in the air and on the ground, of a player who stands or runs", "of the traps", "count", "verdict");
        table.Count("traps", count);
        table.Count("ball faster than 0.3 m/s against the player, settled", alive, alive == 0);
        table.Count("the same, and not said", unsaid, unsaid == 0);
        table.Count("speed against him just after the touch, p95, m/s", new Spread(after).P95);
        table.Count("speed settled, p95, m/s", then.P95);
        table.Count("speed settled, worst, m/s", then.Worst);
        table.Count("gone from him meanwhile, p95, m", new Spread(away).P95);
        table.Count("chance of 1 m/s or less with the foot's errors, mean", chances / Math.Max(1, requests));
    }
}
