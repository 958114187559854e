using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Chance;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Rows of flights in the scalar simulation: with obstacles, beyond the first impact, with events and samples.</summary>
internal sealed class PlayRows : LaunchRows
{
    private const string NoThing = "none";

    /// <summary>The minimum time after which the outcome of a moving ball is unknown, in s. A ball rolls on grass for less than 30 s.</summary>
    private const double LongestFlight = 60;

    /// <summary>The distance from every goal beyond which a ball that moves away is out, in m. Wind can roll a ball on for ever.</summary>
    private const double OutDistance = 100;
    private const string OutcomeName = "outcome";

    private static readonly string[] s_outcomes = ["miss", "goal", "post", "save"];
    private static readonly string[] s_kinds = [.. Enum.GetValues<BallEventKind>().Select(kind => Words.Of(kind)), NoThing];

    private readonly CompiledScenes<CompiledScene> _scenes;
    private readonly Trajectory _path = new();

    /// <summary>The flight to rest, which decides the outcome of a row whose recorded flight does not.</summary>
    private readonly Trajectory _rest = new();
    private readonly bool _tellsOutcome;
    private RowCounts _counts;
    private ChanceShares _chance;
    private CompiledScene _scene = null!;
    private PlayEnd _end;
    private int _lastEvent;

    public PlayRows(SweepPlan plan, int capacity)
        : base(plan, capacity)
    {
        _scenes = new CompiledScenes<CompiledScene>(plan, Draws, scene => new CompiledScene(scene, plan.Things));
        foreach (string name in plan.Row.Hits.Where(name => !plan.Things.Contains(name)))
        {
            throw new RefusedException("row.hits", Quote.Short(name), string.Join(" | ", plan.Things));
        }

        _tellsOutcome = plan.HasGoals && Writes(OutcomeName);
        _counts = NoRows;
    }

    public override RowCounts Counts => _counts;

    private RowCounts NoRows => _tellsOutcome ? new RowCounts(null, 0, 0, 0) : new RowCounts(null);

    protected override void Answer(int count)
    {
        _counts = NoRows;
        for (int i = 0; i < count; i++)
        {
            _scene = _scenes.Of(i);
            Prepare(_scene.Scene, i);
            Play(_scene, i);
            Fill(i, 1);
        }
    }

    protected override SweepScene SceneOf(int row) => _scene.Scene;

    protected override IEnumerable<ColumnSource> AnswerSources() =>
    [
        .. LaunchSources(),
        new(Column.Word("end", "what ended the flight", Ends), (to, row, _) => to.Words[row] = (byte)_end.Kind),
        new(Column.Real("time", "s", "when, since the launch"), (to, row, _) => to.Reals[row] = _end.Time),
        new(Column.Vector("position", "m", "where the centre is then"), (to, row, _) => to.Set(row, _end.Position)),
        new(Column.Vector("velocity", "m/s", "velocity then; at an impact just before it, at rest as it was when rest was declared"), (to, row, _) => to.Set(row, _end.Velocity)),
        new(Column.Vector("spin", "rad/s", "spin then; at a plane that of the end of the step"), (to, row, _) => to.Set(row, _end.Spin)),
        new(Column.Vector("velocityAfter", "m/s", "velocity just after"), (to, row, _) => to.Set(row, _end.VelocityAfter)),
        new(Column.Vector("spinAfter", "rad/s", "spin just after"), (to, row, _) => to.Set(row, _end.SpinAfter)),
        new(Column.Real("apex", "m", "greatest height of the centre"), (to, row, _) => to.Reals[row] = _path.Apex),
        new(Column.Whole("bounces", "", "impacts, on whatever it was"), (to, row, _) => to.Wholes[row] = Count(happened => happened.Kind == BallEventKind.Impact)),
        .. OutcomeSources(),
        .. ChanceSources(),
        .. EventSources(),
        .. SampleSources(),
    ];

    private IEnumerable<ColumnSource> OutcomeSources()
    {
        if (Plan.HasGoals)
        {
            yield return new ColumnSource(
                Column.Word(OutcomeName, "of the flight to rest, also after the recorded end; goal: all of the ball was in one; else save: an obstacle was hit; else post: the frame of a goal was hit; else miss", s_outcomes) with { CanMiss = true },
                (to, row, _) => to.Words[row] = Outcome(row));
        }

        if (Plan.Row.Hits.Count > 0)
        {
            yield return new ColumnSource(Column.Whole("hits", "", "how often each of these was hit").Along(Plan.Row.Hits), (to, row, _) =>
            {
                for (int k = 0; k < Plan.Row.Hits.Count; k++)
                {
                    string name = Plan.Row.Hits[k];
                    to.Wholes[(row * Plan.Row.Hits.Count) + k] = Count(happened => happened.Kind is BallEventKind.Impact or BallEventKind.Net && NameOf(happened.ColliderIndex) == name);
                }
            });
        }
    }

    private IEnumerable<ColumnSource> ChanceSources()
    {
        if (Plan.Scene.Chance is null)
        {
            return [];
        }

        ColumnSource Share(string name, string meaning, Func<ChanceShares, (double Share, double Error)> of) =>
            new(Column.Real($"chance.{name}", "", meaning), (to, row, _) => to.Reals[row] = of(_chance).Share);
        ColumnSource Error(string name, Func<ChanceShares, (double Share, double Error)> of) =>
            new(Column.Real($"chance.{name}Error", "", $"standard error of chance.{name}"), (to, row, _) => to.Reals[row] = of(_chance).Error);
        return
        [
            Share("goal", "probability of a goal that the keeper cannot reach", shares => shares.Goal),
            Share("save", "probability of a ball on target that the keeper reaches", shares => shares.Save),
            Share("post", "probability of a ball off the frame that does not go in", shares => shares.Post),
            Share("wide", "probability of every other ball", shares => shares.Wide),
            Error("goal", shares => shares.Goal),
            Error("save", shares => shares.Save),
            Error("post", shares => shares.Post),
            Error("wide", shares => shares.Wide),
            new(Column.Whole("chance.kicks", "", "number of simulated kicks"), (to, row, _) => to.Wholes[row] = _chance.Kicks),
        ];
    }

    private IEnumerable<ColumnSource> EventSources()
    {
        int n = Plan.Row.Events;
        if (n == 0)
        {
            return [];
        }

        string[] places = [.. Enumerable.Range(0, n).Select(k => FormattableString.Invariant($"{k}"))];
        string[] surfaces = [.. Plan.Things.Take(Column.MostWords - 1), NoThing];
        ColumnSource Vector(string name, string unit, string meaning, Func<BallEvent, Vector3d> of) => new(
            Column.Vector($"events.{name}", unit, meaning).Along(places),
            (to, row, _) => Each(row, (k, place) => to.Set(place, k <= _lastEvent ? of(_path.Events[k]) : new Vector3d(double.NaN, double.NaN, double.NaN))));
        return
        [
            new(Column.Whole("events.count", "", "events of the flight, those beyond the first included"), (to, row, _) => to.Wholes[row] = _lastEvent + 1 + _path.Events.Dropped),
            new(Column.Word("events.kind", "what happened", s_kinds).Along(places),
                (to, row, _) => Each(row, (k, place) => to.Words[place] = (byte)(k <= _lastEvent ? (int)_path.Events[k].Kind : s_kinds.Length - 1))),
            new(Column.Word("events.surface", "what was hit or met", surfaces).Along(places),
                (to, row, _) => Each(row, (k, place) => to.Words[place] = (byte)(k <= _lastEvent && _scene.Place(_path.Events[k].ColliderIndex) is >= 0 and int thing && thing < surfaces.Length ? thing : surfaces.Length - 1))),
            new(Column.Real("events.time", "s", "when").Along(places),
                (to, row, _) => Each(row, (k, place) => to.Reals[place] = k <= _lastEvent ? _path.Events[k].Time : double.NaN)),
            Vector("position", "m", "where the centre was", happened => happened.Position),
            Vector("velocityBefore", "m/s", "velocity just before", happened => happened.VelocityBefore),
            Vector("spinBefore", "rad/s", "spin just before", happened => happened.SpinBefore),
            Vector("velocity", "m/s", "velocity just after", happened => happened.Velocity),
            Vector("spin", "rad/s", "spin just after", happened => happened.Spin),
        ];

        void Each(int row, Action<int, int> set)
        {
            for (int k = 0; k < n; k++)
            {
                set(k, (row * n) + k);
            }
        }
    }

    private IEnumerable<ColumnSource> SampleSources()
    {
        IReadOnlyList<double> times = Plan.Row.Samples;
        if (times.Count == 0)
        {
            return [];
        }

        string[] places = [.. times.Select(time => FormattableString.Invariant($"{time:R}"))];
        Action<ColumnData, int, int> Sampled(Func<double, Vector3d> at) => (to, row, _) =>
        {
            for (int k = 0; k < times.Count; k++)
            {
                to.Set((row * times.Count) + k, times[k] <= _end.Time ? at(times[k]) : new Vector3d(double.NaN, double.NaN, double.NaN));
            }
        };
        return
        [
            new(Column.Vector("samples.position", "m", "where the centre is at these times, s; none after the end").Along(places), Sampled(time => _path.PositionAt(time))),
            new(Column.Vector("samples.velocity", "m/s", "velocity at these times, s; none after the end").Along(places), Sampled(time => _path.VelocityAt(time))),
            .. CameraColumns.Of(Plan.Scene.Cameras.Count, times, places, () => _scene.Scene.Cameras, time => time <= _end.Time ? _path.PositionAt(time) : null),
        ];
    }

    private void Play(CompiledScene scene, int row)
    {
        BallState ball = Launch(scene, row);
        scene.Simulator.LookAhead(in ball, scene.Request, _path);
        _end = PlayEnd.Of(_path, scene.Scene);
        if (!_end.IsFinite)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"row {Draws.First + row}: the motion overflows. Reduce the speeds, the coefficients or stop.time."));
        }

        if (scene.Scene.Chance is { } chance)
        {
            _chance = ChanceShares.Of(scene.Chances.Find(chance with { Position = Launches.Position[row], Velocity = Launches.Velocity[row], Spin = Launches.Spin[row] }));
        }

        _lastEvent = _path.Events.Count - 1;
        while (_lastEvent >= 0 && _path.Events[_lastEvent].Time > _end.Time)
        {
            _lastEvent--;
        }
    }

    private string NameOf(int thing) => _scene.Place(thing) is >= 0 and int place ? Plan.Things[place] : NoThing;

    private int Count(Func<BallEvent, bool> counts)
    {
        int count = 0;
        for (int k = 0; k <= _lastEvent; k++)
        {
            count += counts(_path.Events[k]) ? 1 : 0;
        }

        return count;
    }

    private BallState Launch(CompiledScene scene, int row) =>
        scene.Simulator.Launch(Launches.Position[row], Launches.Velocity[row], Launches.Spin[row], scene.Scene.Orientation ?? scene.Simulator.LaunchOrientation);

    /// <summary>
    /// Returns the index in <see cref="s_outcomes"/>, or <see cref="Column.Missing"/>. The recorded flight decides if it contains a goal or ends at rest.
    /// Otherwise the ball is launched again and simulated to rest: a later goal wins over an earlier save or post.
    /// </summary>
    private byte Outcome(int row)
    {
        // Colliders 1 to n are the obstacles; the frames of goals follow.
        int obstacles = _scene.Scene.Scene.Obstacles.Count;
        string? outcome = OutcomeOf(_path, obstacles);
        if (outcome is null)
        {
            BallState ball = Launch(_scene, row);
            _scene.Simulator.LookAhead(in ball, _scene.ToRest, _rest);
            outcome = OutcomeOf(_rest, obstacles, IsOut(_rest.Final));
        }

        if (outcome is not null)
        {
            return (byte)Array.IndexOf(s_outcomes, outcome);
        }

        _counts = !_rest.IsComplete || !_rest.Final.Position.IsFinite ? _counts with { Overflowed = _counts.Overflowed + 1 }
            : _rest.Events.Dropped > 0 ? _counts with { TooManyEvents = _counts.TooManyEvents + 1 }
            : _counts with { StillMoving = _counts.StillMoving + 1 };
        return Column.Missing;
    }

    /// <summary>True if a ball is far from every goal, and moves away from each.</summary>
    private bool IsOut(in BallState ball)
    {
        foreach (Goal goal in _scene.Scene.Scene.Goals)
        {
            Vector3d away = (ball.Position - goal.Center).Horizontal;
            if (!(away.Length > OutDistance && Vector3d.Dot(in away, ball.Velocity) > 0))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Returns the outcome of a flight; null if the flight contains no goal, and does not show everything until the ball rests or is out.</summary>
    private static string? OutcomeOf(Trajectory path, int obstacles, bool isOut = false)
    {
        bool saved = false;
        bool post = false;
        foreach (ref readonly BallEvent happened in path.Events.Span)
        {
            switch (happened.Kind)
            {
                case BallEventKind.Goal:
                    return "goal";
                case BallEventKind.Impact when happened.ColliderIndex > 0:
                    saved |= happened.ColliderIndex <= obstacles;
                    post |= happened.ColliderIndex > obstacles;
                    break;
            }

            if (happened.Kind == BallEventKind.Rest)
            {
                isOut = true;
                break;
            }
        }

        return isOut && path.IsComplete && path.Events.Dropped == 0 && path.Final.Position.IsFinite ? saved ? "save" : post ? "post" : "miss" : null;
    }

    private sealed class CompiledScene
    {
        /// <summary>The index of each collider of the scene in the list of all scenes' colliders.</summary>
        private readonly int[] _places;
        private GoalChance? _chances;

        public CompiledScene(SweepScene scene, List<string> things)
        {
            Scene = scene;
            Simulator = new Simulator(scene.Scene, scene.Solver);
            _places = [.. Simulator.Names.Select((name, i) => i < things.Count && things[i] == name ? i : things.IndexOf(name))];
            Request = new LookAheadRequest
            {
                Duration = scene.Duration,
                TimeStep = scene.TimeStep,
                StopAt = scene.StopAt switch
                {
                    SweepStop.Impact => StopAt.Impact,
                    SweepStop.Time => StopAt.Time,
                    _ => StopAt.Rest,
                },
                UntilPlane = scene.Plane,
            };
            ToRest = new LookAheadRequest { Duration = Math.Max(LongestFlight, scene.Duration), TimeStep = scene.TimeStep };
        }

        public SweepScene Scene { get; }

        public Simulator Simulator { get; }

        /// <summary>The calculator of chances.</summary>
        public GoalChance Chances => _chances ??= new GoalChance(Scene.Scene);

        public LookAheadRequest Request { get; }

        /// <summary>The request of the flight that decides the outcome.</summary>
        public LookAheadRequest ToRest { get; }

        /// <summary>Returns the index of a collider in the list of all scenes' colliders; −1 if it is not there.</summary>
        public int Place(int thing) => thing >= 0 && thing < _places.Length ? _places[thing] : -1;
    }
}
