using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>A goalkeeper as a body of the scene: he stands in front of his goal and dives for shots.</summary>
/// <remarks>
/// <see cref="Interception.FindSave"/> decides if he can reach the ball. He notices a kick when the ball leaves its predicted path, reacts, and moves
/// his hands to the ball. If he cannot reach the ball, he dives as far as he can. After the dive, he returns to his position. He only watches the ball.
/// <para>He meets the ball at the point of its path that is nearest to him, if he can be there in time, so he leaves his line only as far as that. If he stands on the line, he lets in
/// as many goals as <see cref="Batch.GoalChance"/> computes for the same abilities, within the standard errors. With a speed of 5 m/s, a dive of full length takes 0.34 to
/// 0.54 s. He saves fewer balls that arrive sooner after his reaction.</para>
/// <para>He looks 2.5 s ahead. If the ball moves and does not reach the line within that time, he looks again every second. So he decides at least 1.5 s before a slow ball arrives.
/// He starts a dive at most 1 s before the ball arrives, unless he must run farther for it. If the ball leaves its path before that, he stays.</para>
/// <para>His body is never faster than <see cref="Player.Speed"/>, and turns at most at 8 rad/s. A new decision starts from the pose and velocity that he has. A dive that his
/// speed does not allow in time ends after the ball has passed.</para>
/// <para>With a <see cref="Rollback"/>, call <see cref="Follow(FixedStepRunner)"/> in <see cref="FixedStepRunner.MoveBodies"/>, so that resimulated steps move him too. When the
/// clock goes back, he continues from the decisions that he had made by then. The scene for predictions must then contain nothing that moves. The state of the
/// ball does not contain his decisions: send a peer that joins his bytes too (<see cref="ToBytes"/>, <see cref="Restore"/>).
/// <see cref="Follow(FixedStepRunner)"/> allocates only if he decides more often in ten seconds than ever before.</para>
/// </remarks>
public sealed partial class KeeperDive
{
    /// <summary>The duration of his prediction, and the time between two looks at a ball that does not reach his line within it, in s.</summary>
    private const double LooksAhead = 2.5;
    private const double LooksAgain = 1;
    private const double LookStep = 0.02;

    /// <summary>The time before the ball's arrival at which he dives if he need not run for it, in s.</summary>
    private const double Waits = 1;

    /// <summary>The time that he stays down after a dive, and the time that he takes to return, in s.</summary>
    private const double Stays = 0.7;
    private const double Returns = 1.4;

    /// <summary>Half the length of his axis, in m; with the radius, 1.96 m from feet to hands.</summary>
    private const double HalfAxis = 0.78;
    private const double Radius = 0.2;

    /// <summary>The assumed distance of the ball from the tips of his hands, in m.</summary>
    private const double Hands = 0.1;

    /// <summary>The lateral distance below which he stays upright, in m.</summary>
    private const double StandsUpTo = 0.3;

    /// <summary>The time for which he keeps his past decisions, in s; the longest rollback.</summary>
    private const double Remembers = 10;

    /// <summary>The deviation from the predicted path that counts as a new shot, in m. The limit for the velocity is a hundred times as large, in m/s.</summary>
    private const double Notices = 0.01;

    /// <summary>The distance from the target of his dive within which a new shot needs no new dive, in m.</summary>
    private const double SamePlace = 0.2;

    private readonly KinematicBody _body;
    private readonly Simulator _ahead;
    private readonly Interception _interception = new();
    private readonly TrajectoryCache _path;
    private readonly Player _abilities;
    private readonly BallPose _home;
    private readonly Vector3d _feet;
    private Decision _last;
    private Decision[] _past = new Decision[32];
    private int _count;
    private double _now = double.NaN;

    /// <summary>Creates a keeper who stands in front of his goal.</summary>
    /// <param name="body">His body, of kind <see cref="Kind"/>, in the scene of the game.</param>
    /// <param name="goal">His goal.</param>
    /// <param name="ahead">The scene for predictions, without him.</param>
    /// <param name="feet">The position of his feet, in m.</param>
    /// <param name="abilities">His reaction, acceleration, speed, reach and height limits above his feet; position and velocity are ignored. Default
    /// null: <see cref="Typical"/>.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public KeeperDive(KinematicBody body, Goal goal, Simulator ahead, Vector3d feet, Player? abilities = null)
    {
        Check.Given(nameof(body), body);
        Check.Given(nameof(goal), goal);
        Check.Given(nameof(ahead), ahead);
        Check.Place(nameof(feet), feet);
        _abilities = abilities ?? Typical;
        _abilities.Validate();
        goal.Validate(nameof(goal));
        _body = body;
        _ahead = ahead;
        Goal = goal;
        _feet = feet;
        _home = new BallPose(feet + new Vector3d(0, HalfAxis + Radius, 0), Quaterniond.Identity);
        _path = new TrajectoryCache(ahead, new LookAheadRequest { Duration = LooksAhead, TimeStep = LookStep }, Notices);
        Stand();
        Put(0);
    }

    /// <summary>The shape and surface of a keeper: 1.96 m from feet to hands, about his centre.</summary>
    /// <remarks>The entire surface has the material of gloves, which absorb most of a ball's speed. The values are guesses.</remarks>
    public static BodyKind Kind { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, -HalfAxis, 0), new Vector3d(0, HalfAxis, 0), Radius),
        Surface = SurfaceMaterial.Glove,
    };

    /// <summary>The abilities of a good goalkeeper in open play, who reads every shot from the kick on and never dives to the wrong side.</summary>
    /// <remarks>
    /// Reaction 0.2 s, acceleration 8 m/s², speed at most 5 m/s, reach 1.9 m in a dive, height 2.6 m. All values are guesses. At a penalty he is beyond human: shooters who aim
    /// as people do score 52 % against him (<c>lab penalties</c>). For a shoot-out, use <see cref="Penalty"/> and a <see cref="Guess"/>.
    /// </remarks>
    public static Player Typical => new() { Reaction = 0.2, Acceleration = 8, Speed = 5, Reach = 1.9, MaximumHeight = 2.6 };

    /// <summary>His goal.</summary>
    public Goal Goal { get; }

    /// <summary>Gets or sets the dive to which he commits before a kick. Default null: he only reacts.</summary>
    /// <remarks>
    /// From <see cref="KeeperGuess.Time"/> on he dives to the target, whatever the ball does. One reaction time after the kick he adapts the dive, but only to a ball on
    /// the side of his dive. Set a guess before its time, and keep it while a rollback may return to it. A peer that joins needs the same guess.
    /// </remarks>
    public KeeperGuess? Guess { get; set; }

    /// <summary>His response to the last shot that he noticed.</summary>
    public KeeperResult Answer => _last.Answer;

    /// <summary>True from the start of a dive until he is back.</summary>
    public bool Dives
    {
        get
        {
            ref readonly KeeperMotion motion = ref Motion(ref _last, _now);
            return !motion.IsStanding && _now < Return(in motion).End;
        }
    }

    /// <summary>The number of shots that he has dived for.</summary>
    public int Count => _last.Count;

    /// <summary>The position and orientation of his body, for drawing.</summary>
    public BallPose BodyPose => new(_body.Position, _body.Orientation);

    /// <summary>Watches the first ball of a runner and moves his body; call it in <see cref="FixedStepRunner.MoveBodies"/>.</summary>
    /// <remarks>The scene of the runner may contain bodies that the scene for predictions lacks. A <see cref="PlaceInput"/> of this tick sends him back to his goal.</remarks>
    /// <param name="runner">The runner.</param>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    public void Follow(FixedStepRunner runner)
    {
        Check.Given(nameof(runner), runner);
        BallState ball = _ahead.Continue(runner.Simulator, runner.State);
        Follow(in ball, IsPlaced(runner));
    }

    /// <summary>Watches the ball and moves his body; call it at the start of every step.</summary>
    /// <param name="ball">The ball before the step, in the scene for predictions.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public void Follow(in BallState ball) => Follow(in ball, isPlaced: false);

    /// <summary>Watches the ball and moves his body, in a step that may begin with a restart; call it at the start of every step.</summary>
    /// <param name="ball">The ball before the step, in the scene for predictions.</param>
    /// <param name="isPlaced">True if a <see cref="PlaceInput"/> placed the ball at this step: he then stands at his position again.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public void Follow(in BallState ball, bool isPlaced)
    {
        BallState.Launched(in ball);
        if (!(ball.Time > _now))
        {
            GoBack(ball.Time);
        }

        _now = ball.Time;
        if (isPlaced)
        {
            Stand();
        }

        if (Guess is { } guess && _now >= guess.Time && !(_last.Seen.Time >= guess.Time))
        {
            Commit(in guess, in ball);
        }

        if (_now >= _last.Look)
        {
            _path.Invalidate();
        }

        if (_path.Update(in ball))
        {
            _last.Seen = ball;
            _last.Look = _path.Path.EndTime < _now + LooksAhead - LookStep ? double.PositiveInfinity : _now + LooksAgain;
            if (!IsCommitted)
            {
                Decide(_now, _abilities.Reaction);
            }

            Remember();
        }
        else if (IsCommitted && _now >= _last.Seen.Time + _abilities.Reaction)
        {
            Adapt(in ball);
        }

        Put(_now);
    }

    /// <summary>True if a restart belongs to the tick of a runner.</summary>
    internal static bool IsPlaced(FixedStepRunner runner)
    {
        KickLog inputs = runner.Kicks;
        int place = inputs.FirstPlaceAt(runner.Tick);
        return place < inputs.PlaceCount && inputs.PlaceAt(place).Tick == runner.Tick;
    }

    /// <summary>Stands at his position, without a decision.</summary>
    private void Stand()
    {
        _last.Before = KeeperMotion.Standing(in _home);
        _last.Dive = _last.Before;

        // Recompute the path even if it matches, because no decision was made for it.
        _path.Invalidate();
    }

    /// <summary>Returns to the decision that he had made before a time; if there is none, the ball is new, and he stands.</summary>
    private void GoBack(double time)
    {
        int count = _count;
        while (_count > 0 && !(_past[_count - 1].Seen.Time < time))
        {
            _count--;
        }

        if (_count == 0)
        {
            // No time is at or after that of a guess.
            _last.Seen.Time = double.NegativeInfinity;
            Stand();
        }
        else if (_count < count || time < _now)
        {
            _last = _past[_count - 1];
            _path.Repeat(in _last.Seen, time);
        }
    }

    /// <summary>Keeps the last decision.</summary>
    private void Remember()
    {
        if (_count == _past.Length)
        {
            // Drop the decisions that were replaced by others before the time to which a rollback may return.
            int old = 0;
            while (old + 1 < _count && _past[old + 1].Seen.Time < _now - Remembers)
            {
                old++;
            }

            _count -= old;
            Array.Copy(_past, old, _past, 0, _count);
            if (old == 0)
            {
                Array.Resize(ref _past, 2 * _count);
            }
        }

        _past[_count++] = _last;
    }

    /// <summary>Evaluates the predicted path, and starts a dive if the ball crosses the goal at a new point.</summary>
    /// <param name="now">The time, in s.</param>
    /// <param name="reaction">The time until he moves, in s.</param>
    private void Decide(double now, double reaction)
    {
        Vector3d feet = Feet(At(now).Pose);
        Player self = Standing(in feet);
        KeeperResult answer = _interception.FindSave(_path.Path, in self, Goal, now);
        _last.Look = answer.Crosses ? double.PositiveInfinity : _last.Look;

        // A planned dive can still change if it starts after his reaction.
        bool isPlanned = _last.Dive.Start > now + reaction;
        if (!answer.Crosses || !answer.IsOnTarget)
        {
            if (isPlanned)
            {
                _last.Dive = _last.Before;
                _last.Count--;
            }

            return;
        }

        _last.Answer = answer;
        PathPoint at = Meeting(in answer, in self, now);
        if (!isPlanned && now < _last.Dive.End && Vector3d.Distance(at.Position, _last.Target) < SamePlace)
        {
            return;
        }

        _last.Target = at.Position;
        Dive(in at, now, reaction);
        _last.Count += isPlanned ? 0 : 1;
    }

    /// <summary>Returns the point of the path to which he moves his hands: the nearest that he can reach before the line, or the point on the line.</summary>
    private PathPoint Meeting(in KeeperResult answer, in Player self, double now)
    {
        Vector3d low = new(self.Position.X, self.MinimumHeight, self.Position.Z);
        PathPoint near = _path.Path.ClosestApproach(low, low + new Vector3d(0, self.MaximumHeight - self.MinimumHeight, 0));
        double time = near.Time - now - self.Reaction;
        bool isBefore = near.Time <= answer.Crossing.Time;
        if (isBefore && time >= 0 && near.Distance <= self.Reach + RunIn(time))
        {
            return near;
        }

        // The nearest point comes too early or is too high: the first point that he can reach is later.
        return answer.Saves && (isBefore || answer.Crossing.Position.Y > self.MaximumHeight) ? answer.Save : answer.Crossing;
    }

    /// <summary>Plans a dive that ends when the ball arrives. Until it starts, he continues his motion.</summary>
    private void Dive(in PathPoint at, double now, double reaction)
    {
        _last.Before = Motion(ref _last, now);
        Vector3d feet = Feet(At(now).Pose);
        double runs = TimeFor((at.Position - feet).Horizontal.Length - _abilities.Reach);
        double start = Math.Max(now + reaction, at.Time - Math.Max(Waits, runs));
        KeeperState state = At(in _last.Before, start);
        BallPose to = Reaching(Feet(state.Pose), at.Position, Math.Max(0, at.Time - start));
        _last.Dive = KeeperMotion.Within(in state, in to, start, at.Time, _abilities.Speed);
    }

    /// <summary>Returns the keeper for the search: at his feet, without motion, and with heights in world coordinates.</summary>
    private Player Standing(in Vector3d feet) => new()
    {
        Position = feet,
        Reaction = _abilities.Reaction,
        Acceleration = _abilities.Acceleration,
        Speed = _abilities.Speed,
        Reach = _abilities.Reach,
        MinimumHeight = _feet.Y + _abilities.MinimumHeight,
        MaximumHeight = _feet.Y + _abilities.MaximumHeight,
    };

    /// <summary>Returns his pose with the hands at the ball, or as close to it as he gets.</summary>
    private BallPose Reaching(in Vector3d feet, Vector3d ball, double left)
    {
        Vector3d aside = (ball - feet).Horizontal;
        double distance = aside.Length;

        // A ball at the end of his reach overlaps the tips of his hands by half its radius: with less it would graze them, and go in.
        double most = RunIn(left) + _abilities.Reach - (0.5 * (Hands + _ahead.Scene.Ball.Radius));
        double share = Math.Min(1, Math.Max(0, most) / Math.Max(distance, 1e-9));
        double low = feet.Y + Radius;
        double high = feet.Y + _abilities.MaximumHeight;
        Vector3d hands = feet + (share * aside) + new Vector3d(0, Math.Max(low, Math.Min(high, ball.Y)) - feet.Y, 0);
        double length = 2.0 * (HalfAxis + Radius) - Hands;
        if (distance <= StandsUpTo)
        {
            double lift = Math.Max(0, hands.Y - feet.Y - length);
            return new BallPose(feet + (share * aside) + new Vector3d(0, HalfAxis + Radius + lift, 0), Quaterniond.Identity);
        }

        // He falls about his feet. To a ball that is farther he flies, along the shortest path of his centre: stretched from there to the ball, or flat.
        Vector3d axis = hands - feet;
        bool flies = axis.Length > length;
        axis -= new Vector3d(0, flies ? Math.Min(axis.Y, HalfAxis + Radius) : 0, 0);
        axis = axis.Normalized();
        Vector3d middle = flies ? hands - (0.5 * length * axis) : feet + (0.5 * length * axis);
        middle = new Vector3d(middle.X, Math.Max(middle.Y, low), middle.Z);
        return new BallPose(in middle, Between(Vector3d.Up, in axis));
    }

    /// <summary>Returns the motion that he is in at a time: the dive, or until it starts, the motion before it.</summary>
    private static ref KeeperMotion Motion(ref Decision decision, double time) => ref time < decision.Dive.Start ? ref decision.Before : ref decision.Dive;

    /// <summary>Returns the motion from a dive to his position.</summary>
    private KeeperMotion Return(in KeeperMotion dive)
    {
        double start = dive.End + Stays;
        return KeeperMotion.Within(dive.At(start), in _home, start, start + Returns, _abilities.Speed);
    }

    /// <summary>Returns his state at a time.</summary>
    private KeeperState At(double time) => At(in Motion(ref _last, time), time);

    /// <summary>Returns his state at a time after a motion has started: the dive, a pause, and the return.</summary>
    private KeeperState At(in KeeperMotion motion, double time) => motion.IsStanding || time < motion.End + Stays ? motion.At(time) : Return(in motion).At(time);

    /// <summary>Moves the body to its state at a time.</summary>
    private void Put(double time)
    {
        KeeperState state = At(time);
        _body.MoveTo(state.Pose.Position, state.Pose.Orientation, state.Velocity, state.Spin, time);
    }

    /// <summary>Returns the point on the ground from which he dives.</summary>
    private Vector3d Feet(BallPose pose)
    {
        Vector3d end = pose.Position - (HalfAxis * pose.Orientation.Rotate(Vector3d.Up));
        return new Vector3d(end.X, _feet.Y, end.Z);
    }

    /// <summary>Returns the shortest rotation between two unit vectors.</summary>
    private static Quaterniond Between(in Vector3d from, in Vector3d to)
    {
        Vector3d axis = Vector3d.Cross(in from, in to);
        return new Quaterniond(axis.X, axis.Y, axis.Z, 1.0 + Vector3d.Dot(in from, in to)).Normalized();
    }

    /// <summary>All that he has decided, and the ball for which he decided it.</summary>
    private struct Decision
    {
        public BallState Seen;
        public KeeperMotion Before;
        public KeeperMotion Dive;
        public Vector3d Target;
        public KeeperResult Answer;
        public int Count;

        /// <summary>The time at which he looks again; ∞ if only another path of the ball changes anything.</summary>
        public double Look;
    }
}
