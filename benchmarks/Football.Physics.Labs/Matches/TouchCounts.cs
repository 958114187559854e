namespace FootballPhysics.Labs.Matches;

/// <summary>Touches of players: dribbles, first-time shots and traps.</summary>
internal sealed class TouchCounts(LabRun run, int count)
{
    private const int TouchesOfOne = 8;
    private const double Farthest = 1.5;
    private const double Near = 0.01;
    private const double Dead = 0.3;

    private readonly Simulator _simulator = new();
    private readonly LabCounts _counts = new();

    /// <summary>The touches without errors of the foot, and those with errors.</summary>
    private readonly Touches _touches = new(spread: new TouchSpread { Draws = 0 });
    private readonly Touches _sure = new();

    /// <summary>Counts the positions of the ball while players dribble along paths with turns.</summary>
    public void Dribbles()
    {
        double farthest = 0;
        double chances = 0;
        var misses = new List<double>();
        var paces = new List<double>();
        var log = new StepLog();
        run.Each(count, "dribble", (random, i) =>
        {
            double pace = random.Uniform(2, 8);
            double angle = random.Uniform(0, 6.28);
            Vector3d player = Vector3d.Zero;
            Vector3d way = Heading(angle);

            // The ball reaches his feet rolling, sliding, skipping, or with a spin of its own.
            BallState ball = _simulator.Launch(
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
                Touch touch = _touches.Dribble(in ball, request);
                _counts.Add("touches");
                misses.Add(touch.Miss);
                paces.Add(touch.SpeedError);
                if (k == 1 && i % 10 == 0)
                {
                    chances += _sure.Dribble(in ball, request).Chance;
                }

                isLost = !touch.Succeeds;
                _simulator.Kick(ref ball, touch.Velocity, touch.Spin);
                int steps = (int)Math.Ceiling(request.Duration / 0.01);
                for (int n = 0; n < steps; n++)
                {
                    double h = request.Duration / steps;
                    _simulator.Step(ref ball, h, log);
                    log.Clear();
                    player += h * pace * way;
                    Vector3d apart = (ball.Position - player).Horizontal;
                    farthest = Math.Max(farthest, apart.Length);
                    isFar |= apart.Length > Farthest;

                    // The ball must be ahead once he has turned: after the middle of a touch. At a turn of 90° it lies next to him at the touch.
                    isBehind |= Vector3d.Dot(apart, way) <= 0 && (n > steps / 2 || Math.Abs(turn) < 0.5);
                }
            }

            _counts.Add("dribbles");
            _counts.AddIf(isFar, "ball farther than 1.5 m from the player");
            _counts.AddIf(isBehind, "ball behind the player");
            _counts.AddIf(isLost, "lost: a touch that did not come off");
        });
        var off = new Spread(paces);
        LabTable table = run.Table("Dribbles at 2 to 8 m/s, turns of up to 90°", "of the dribbles", "count", "verdict");
        _counts.AddTo(
            table, ("dribbles", false), ("touches", false), ("ball farther than 1.5 m from the player", true), ("ball behind the player", true), ("lost: a touch that did not come off", true));
        table.Count("farthest that the ball was, m", farthest);
        table.Count("where he wanted it, p95, m", new Spread(misses).P95);
        table.Count("pace off, mean, m/s", off.Mean);
        table.Count("pace off, p95, m/s", off.P95);
        table.Count("chance of a second touch with errors, mean", chances / Math.Max(1, (count + 9) / 10));
    }

    /// <summary>Counts first-time strikes of moving balls at a target: a predicted hit must also hit in the game.</summary>
    public void FirstTimeShots()
    {
        var path = new Trajectory(4096);
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
            BallState ball = _simulator.Launch(from, high ? velocity + new Vector3d(0, random.Uniform(-4, 2), 0) : velocity, spin);
            var request = new FirstTimeRequest
            {
                Target = new Vector3d(random.Uniform(-3.5, 3.5), random.Uniform(0.2, 2.3), 0),
                Speed = random.Uniform(16, 28),
                TopSpin = random.Uniform(-20, 20),
                SideSpin = random.Uniform(-30, 30),
            };
            Touch touch = _touches.FirstTimeShot(in ball, request);
            if (i % 20 == 0)
            {
                double chance = _sure.FirstTimeShot(in ball, request).Chance;
                chances += double.IsNaN(chance) ? 0 : chance;
                requests++;
            }

            if (!touch.Succeeds)
            {
                _counts.Add(touch.Status == TouchStatus.FootTooSlow ? "the foot is too slow" : "no touch does");
                return;
            }

            // Simulate in the game's own steps, with the foot itself.
            _counts.Add("said to hit");
            BallState kicked = Struck(ball, in touch);
            _simulator.LookAhead(in kicked, new LookAheadRequest { Duration = 5, TimeStep = 1 / 60.0 }, path);
            double miss = (path.ClosestApproach(request.Target).Position - request.Target).Length;
            worst = Math.Max(worst, miss);
            _counts.AddIf(!(miss <= Near), "said to hit, and more than 1 cm off in the game");
        });
        LabTable table = run.Table("First-time shots at balls of up to 15 m/s", "of the shots", "count", "verdict");
        table.Count("shots", count);
        _counts.AddTo(table, ("said to hit", false), ("said to hit, and more than 1 cm off in the game", true));
        table.Count("worst of those that are said to hit, m", worst);
        _counts.AddTo(table, ("the foot is too slow", false), ("no touch does", false));
        table.Count("chance within half a metre with the foot's errors, mean", chances / Math.Max(1, requests));
    }

    /// <summary>Counts balls that a player traps, and their speed relative to him afterwards.</summary>
    public void Traps()
    {
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
            BallState ball = _simulator.Launch(
                new Vector3d(0, high ? random.Uniform(0.15, 0.8) : 0.11, 0), high ? velocity + new Vector3d(0, random.Uniform(-5, 1), 0) : velocity, spin);
            double run = random.Uniform(0, 6.28);
            Vector3d player = random.Chance(0.5) ? Vector3d.Zero : random.Uniform(1, 6) * new Vector3d(Math.Cos(run), 0, Math.Sin(run));
            var request = new TrapRequest { Velocity = player };
            Touch touch = _touches.Trap(in ball, request);
            if (i % 20 == 0)
            {
                chances += _sure.Trap(in ball, request).Chance;
                requests++;
            }

            BallState kicked = Struck(ball, in touch);
            after.Add((kicked.Velocity - player).Horizontal.Length);
            _simulator.Run(ref kicked, 1 / 60.0, request.Duration, StopAt.Time, new StepLog());
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

    /// <summary>Returns a ball that the foot of a touch has struck in the game.</summary>
    private BallState Struck(BallState ball, in Touch touch)
    {
        FootStrike strike = _touches.Foot.Strike(_simulator.Scene.Ball, ball.Velocity, ball.Spin, touch.Strike.FootVelocity, touch.Strike.Normal);
        _simulator.Kick(ref ball, strike.Velocity, strike.Spin);
        return ball;
    }

    private static Vector3d Heading(double angle) => new(Math.Sin(angle), 0, -Math.Cos(angle));
}
