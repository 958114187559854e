using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>Shots in one moving picture, with what stands around them.</summary>
internal sealed record ReplayPicture
{
    /// <summary>Its short name, for links.</summary>
    public required string Id { get; init; }

    public required string Name { get; init; }

    /// <summary>What is to be seen; may be empty.</summary>
    public string About { get; init; } = "";

    public required IReadOnlyList<ReplayShot> Shots { get; init; }

    public required IReadOnlyList<SceneShape> Shapes { get; init; }

    /// <summary>The goals, which say where the pitch is.</summary>
    public IReadOnlyList<Goal> Goals { get; init; } = [];

    /// <summary>The ground; null where there is none.</summary>
    public required GroundGrid? Ground { get; init; }

    /// <summary>The poses of a goalkeeper who moves; empty if there is none.</summary>
    public IReadOnlyList<KeeperPose> Keeper { get; init; } = [];

    /// <summary>Points that the ball was aimed at, m.</summary>
    public IReadOnlyList<Vector3d> Targets { get; init; } = [];

    /// <summary>Shots in the scenes they were played in: the ground of the first, the things of all.</summary>
    public static ReplayPicture Of(string id, string name, IReadOnlyList<(string Name, Scenario Scenario, Outcome Outcome)> played)
    {
        var shapes = new List<SceneShape>();
        var seen = new HashSet<object>();
        var nets = new Dictionary<object, int>();
        int count = 0;
        foreach (Scene scene in played.Select(shot => shot.Scenario.Scene))
        {
            foreach (Net net in scene.Nets.Where(net => nets.TryAdd(net, count)))
            {
                count++;
            }

            foreach (Goal goal in scene.Goals.Where(goal => nets.TryAdd(goal, count)))
            {
                count += goal.Nets().Count();
            }

            // Records are equal by what they say: the same goal in two files is one.
            Scene fresh = scene with { Goals = [.. scene.Goals.Where(seen.Add)], Nets = [.. scene.Nets.Where(seen.Add)] };
            shapes.AddRange(SceneShapes.Of(fresh).Where(shape => shape.Kind != SceneShapeKind.Obstacle || seen.Add(Text(shape))));
        }

        ReplayShot[] shots = [.. played.SelectMany(shot => shot.Scenario.Balls.Count > 0
            ? Enumerable.Range(0, shot.Scenario.Balls.Count).Select(ball => Shot(FormattableString.Invariant($"{shot.Name}: ball {ball}"), shot.Scenario, shot.Outcome, ball))
            : [new ReplayShot(shot.Name, KickNumbers.Of(shot.Scenario).Text, new Track(shot.Scenario, shot.Outcome)) { Nets = Nets(shot.Scenario) }])];
        return new ReplayPicture
        {
            Id = id,
            Name = name,
            Shots = shots,
            Shapes = shapes,
            Goals = [.. played.SelectMany(shot => shot.Scenario.Scene.Goals).Distinct()],
            Ground = GroundGrid.Of(played[0].Scenario.Scene.Ground, [.. shots.SelectMany(shot => shot.Track.Keys).Select(key => key.Position), .. shapes.SelectMany(shape => shape.Points)]),
        };

        // The nets of a shot's own scene, as the picture counts them.
        NetMove[] Nets(Scenario scenario)
        {
            int[] own = [.. scenario.Scene.Nets.Select(net => nets[net]), .. scenario.Scene.Goals.SelectMany(goal => goal.Nets().Select((_, i) => nets[goal] + i))];
            return [.. NetMoves.Thinned(NetMoves.Of(scenario)).Select(move => move with { Net = own[move.Net] })];
        }
    }

    /// <summary>One of several balls.</summary>
    private static ReplayShot Shot(string name, Scenario scenario, Outcome outcome, int ball)
    {
        BallLaunch launch = scenario.Balls[ball];
        Scenario own = scenario with { Balls = [], Scene = scenario.Scene with { Ball = launch.Ball }, Position = launch.Position, Velocity = launch.Velocity, Spin = launch.Spin };
        Outcome its = outcome with { Samples = outcome.BallSamples[ball], Events = [.. outcome.Events.Where(item => item.Ball == ball)] };
        return new ReplayShot(name, KickNumbers.Of(own).Text, new Track(own, its));
    }

    private static string Text(SceneShape shape) => $"{shape.Radius} {shape.Velocity} {string.Join(' ', shape.Points)}";
}
