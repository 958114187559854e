namespace FootballPhysics.Labs.People;

/// <summary>Simulates matches and checks after every step the invariants of any match: each millisecond of the path, energy, look-ahead, rewind, rest.</summary>
internal sealed class StadiumMatches() : PeopleCases("matches")
{
    /// <summary>The largest share by which energy may grow by rounding.</summary>
    private const double EnergyRounding = 1e-8;

    /// <summary>The distance, m, by which contact may move a ball at the end of a piece of its path.</summary>
    private const double PutOn = 2e-6;

    /// <summary>Moving objects that are farther than this, m, do not take part in a step.</summary>
    private const double Apart = 2e-3;

    /// <summary>A ball in a net that is slower than this, m/s, hangs still.</summary>
    private const double Hanging = 1e-6;

    /// <summary>The number of steps that a rewind replays.</summary>
    private const int RewindLength = 120;

    private readonly Trajectory _ahead = new(4096);
    private readonly StepLog _log = new();
    private readonly byte[] _bytes = new byte[Snapshot.Size];

    public readonly PeopleClaim Kicks = new("matches: kicks", ClaimParts.Count);
    public readonly PeopleClaim Goals = new("matches: goals", ClaimParts.Count);
    public readonly PeopleClaim Squeezes = new("matches: squeezes", ClaimParts.Count);

    /// <summary>The positions on the path.</summary>
    public readonly PeopleClaim Inside = new("matches: inside what stands still, m", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);
    public readonly PeopleClaim Left = new("matches: the ball left the stadium");

    /// <summary>The steps without a body near the ball.</summary>
    public readonly PeopleClaim Made = new("matches: energy from nothing, share", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);
    public readonly PeopleClaim Elsewhere = new("matches: look-ahead of a step goes elsewhere");
    public readonly PeopleClaim RewoundElsewhere = new("matches: played again goes elsewhere");
    public readonly PeopleClaim Hung = new("matches: dead ball hangs still in a net", ClaimParts.Count);
    public readonly PeopleClaim Restless = new("matches: dead ball not at rest in 19 s");

    public override PeopleClaim[] Claims => [Kicks, Goals, Squeezes, Inside, Left, Made, Elsewhere, RewoundElsewhere, Hung, Restless];

    /// <summary>Simulates a minute of a match.</summary>
    public override void Play(long seed, int index) => Play(seed, index, 60, _ => { });

    /// <summary>Simulates one match; every second one with frames from a tenth of a millisecond to a quarter of a second.</summary>
    public void Play(long seed, int index, double seconds, Action<double> progress)
    {
        var stadium = new Stadium(SeededRandom.Mix(seed, index));
        var frames = new SeededRandom(SeededRandom.Mix(seed, ~index));
        var played = new List<PlayedStep>(RewindLength);
        bool left = false;
        bool judged = false;
        double rested = 0;
        long goals = 0;
        long squeezes = 0;
        Ball ball = stadium.Ball;
        for (int i = 0; ball.Time < seconds; i++)
        {
            double frame = index % 2 == 0 ? 1.0 / 60
                : frames.Chance(0.1) ? frames.Log(1e-4, 0.25)
                : frames.Chance(0.5) ? frames.Uniform(0.014, 0.019)
                : frames.Uniform(0.004, 0.05);
            (Vector3d Velocity, Vector3d Spin)? kick = stadium.Decide(frame);
            stadium.Put();
            Stadium.Placement kept = stadium.Keep();
            BallState unkicked = ball.State;
            if (kick is { } given)
            {
                ball.Kick(given.Velocity, given.Spin);
            }

            BallState before = ball.State;
            ball.Simulator.LookAhead(in before, new LookAheadRequest { TimeStep = frame, Duration = 1.5 * frame, StopAt = StopAt.Time }, _ahead);
            FormattableString at = $"match {index}, {before.Time} s";
            Meter.Step(ball, frame, at);
            BallState after = ball.State;
            foreach (ref readonly BallEvent item in ball.Events)
            {
                goals += item.Kind == BallEventKind.Goal ? 1 : 0;
                squeezes += item.Kind == BallEventKind.Pinned && item.ColliderIndex >= 0 ? 1 : 0;
            }

            LookAt(stadium, in before, in after, frame, at);
            left |= Stadium.IsOutside(after.Position);
            Energy(stadium, in before, in after, frame, at);
            judged = stadium.HasHadTime && (judged || Judge(ball, rested, at));
            rested = !stadium.IsDead ? ball.Time : rested;
            played.Add(new PlayedStep(unkicked, kept, kick, frame, Snapshot.Hash(in after)));
            if (played.Count == RewindLength)
            {
                Stadium.Placement now = stadium.Keep();
                Rewind(stadium, played, i % 3 == 0 ? new Simulator(stadium.Scene) : ball.Simulator, at);
                stadium.Restore(now, ball.Time);
                played.Clear();
            }

            stadium.Walk(frame);
            progress(ball.Time);
        }

        Cases++;
        Kicks.Add(stadium.Kicks);
        Goals.Add(goals);
        Squeezes.Add(squeezes);
        Left.Case(left);
    }

    /// <summary>Compares each millisecond of a step with the standing objects, and checks that the look-ahead ends where the step ended.</summary>
    private void LookAt(Stadium stadium, in BallState before, in BallState after, double frame, FormattableString at)
    {
        // A piece of the path ends before contact moves the ball onto an obstacle, or out of an object that presses it.
        Elsewhere.Case((_ahead.PositionAt(after.Time) - after.Position).Length > PutOn, at);

        int parts = Math.Max(1, (int)(frame / 0.001));
        for (int i = 0; i <= parts; i++)
        {
            Vector3d place = i == parts ? after.Position : _ahead.PositionAt(before.Time + (frame * i / parts));
            double deep = Stadium.BallRadius - stadium.ToStanding(place);
            Inside.Judge(deep, Entered, $"{at}, {i} ms of {1000 * frame:0.00}, {before.Motion} to {after.Motion}");
        }
    }

    /// <summary>Checks that a ball without moving objects near it, outside the goals, gains no energy.</summary>
    private void Energy(Stadium stadium, in BallState before, in BallState after, double frame, FormattableString at)
    {
        if (Stadium.IsInGoal(before.Position) || Stadium.IsInGoal(after.Position)
            || stadium.ToMoving(before.Position, 0) < Stadium.BallRadius + Apart || stadium.ToMoving(after.Position, frame) < Stadium.BallRadius + Apart)
        {
            return;
        }

        // Contacts that squeeze a ball are not reported one by one: an object may come and go within the step.
        for (double since = 0; before.Motion == MotionState.Pinned && since < frame; since += 0.001)
        {
            if (stadium.ToMoving(_ahead.PositionAt(before.Time + since), since) < Stadium.BallRadius + Apart)
            {
                return;
            }
        }

        foreach (ref readonly BallEvent item in stadium.Ball.Events)
        {
            string name = item.ColliderIndex > 0 ? stadium.Ball.Simulator.NameOf(item.ColliderIndex) ?? "" : "";
            if (name.StartsWith("player", StringComparison.Ordinal) || name.StartsWith("foot", StringComparison.Ordinal) || name.StartsWith("sphere", StringComparison.Ordinal))
            {
                return;
            }
        }

        double had = Of(stadium.Scene, in before);
        double made = (Of(stadium.Scene, in after) - had) / Math.Abs(had);
        Made.Judge(made, EnergyRounding, $"{at}, {before.Motion} to {after.Motion}");
    }

    /// <summary>Returns m v²/2 + I ω²/2 + m g′ y, with g′ reduced by the buoyancy.</summary>
    private static double Of(Scene scene, in BallState s)
    {
        BallProperties ball = scene.Ball;
        double air = scene.Forces.Buoyancy ? 4.0 / 3.0 * Math.PI * Math.Pow(ball.Radius, 3) * scene.Air.Density / ball.Mass : 0;
        return (0.5 * ball.Mass * s.Velocity.LengthSquared) + (0.5 * ball.MomentOfInertia * s.Spin.LengthSquared)
            + (ball.Mass * scene.Gravity * (1 - air) * s.Position.Y);
    }

    private bool Judge(Ball ball, double since, FormattableString at)
    {
        if (ball.Time - since < 18)
        {
            return false;
        }

        // On the roof of a net, which supports nothing, the ball hangs still, also against the bar.
        bool hangs = ball.Motion != MotionState.Rest && Stadium.IsInGoal(ball.State.Position) && ball.State.Velocity.Length < Hanging;
        bool rests = ball.Motion == MotionState.Rest || hangs;
        Hung.Case(hangs);
        Restless.Case(!rests, $"{at}: {ball.Motion} at {ball.State.Position}, {ball.State.Velocity.Length:0.000} m/s");
        return true;
    }

    /// <summary>Replays the steps from a snapshot's bytes, with all moving objects at their earlier positions.</summary>
    private void Rewind(Stadium stadium, List<PlayedStep> played, Simulator simulator, FormattableString at)
    {
        BallState first = played[0].Before;
        Snapshot.Write(in first, _bytes);
        BallState state = Snapshot.Read(_bytes);
        foreach (PlayedStep step in played)
        {
            stadium.Restore(step.Kept, state.Time);
            if (step.Kick is { } kick)
            {
                simulator.Kick(ref state, kick.Velocity, kick.Spin);
            }

            _log.Clear();
            simulator.Step(ref state, step.Frame, _log);
            bool elsewhere = Snapshot.Hash(in state) != step.Hash;
            RewoundElsewhere.Case(elsewhere, $"{at}, step of {step.Before.Time} s, {step.Before.Motion} to {state.Motion}");
            if (elsewhere)
            {
                return;
            }
        }
    }

    private sealed record PlayedStep(BallState Before, Stadium.Placement Kept, (Vector3d Velocity, Vector3d Spin)? Kick, double Frame, ulong Hash);
}
