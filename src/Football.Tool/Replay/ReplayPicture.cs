using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>Shots in one animated picture, with the objects around them.</summary>
internal sealed record ReplayPicture
{
    /// <summary>The short name, for links.</summary>
    public required string Id { get; init; }

    public required string Name { get; init; }

    /// <summary>The description; may be empty.</summary>
    public string About { get; init; } = "";

    public required IReadOnlyList<ReplayShot> Shots { get; init; }

    public required IReadOnlyList<SceneShape> Shapes { get; init; }

    /// <summary>The goals; they determine the position of the pitch.</summary>
    public IReadOnlyList<Goal> Goals { get; init; } = [];

    /// <summary>The ground; null if there is none.</summary>
    public required GroundGrid? Ground { get; init; }

    /// <summary>The poses of a moving goalkeeper; empty if there is none.</summary>
    public IReadOnlyList<KeeperPose> Keeper { get; init; } = [];

    /// <summary>The target points of the kicks, in m.</summary>
    public IReadOnlyList<Vector3d> Targets { get; init; } = [];

    /// <summary>Creates a picture of shots in their scenes. It has the ground of the first scene and the objects of all scenes.</summary>
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

            // Records are equal if their values are equal, so the same goal in two files is drawn once.
            Scene fresh = scene with { Goals = [.. scene.Goals.Where(seen.Add)], Nets = [.. scene.Nets.Where(seen.Add)] };
            shapes.AddRange(SceneShapes.Of(fresh).Where(shape => shape.Kind != SceneShapeKind.Obstacle || seen.Add(Text(shape))));
        }

        // A picture shows bodies that code moves in its own way.
        shapes.AddRange(played.Where(shot => shot.Scenario.BeforeStep is null).SelectMany(shot => shot.Scenario.Scene.Bodies ?? Enumerable.Empty<KinematicBody>())
            .Where(body => !body.IsWithdrawn).Select(SceneShapes.Of).Where(shape => seen.Add(Text(shape))));
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

        // Returns the movements of the nets of a shot's scene, with the indices of the picture's nets.
        NetMove[] Nets(Scenario scenario)
        {
            int[] own = [.. scenario.Scene.Nets.Select(net => nets[net]), .. scenario.Scene.Goals.SelectMany(goal => goal.Nets().Select((_, i) => nets[goal] + i))];
            return [.. NetMoves.Thinned(NetMoves.Of(scenario)).Select(move => move with { Net = own[move.Net] })];
        }
    }

    /// <summary>Returns the shot of one of several balls.</summary>
    private static ReplayShot Shot(string name, Scenario scenario, Outcome outcome, int ball)
    {
        BallLaunch launch = scenario.Balls[ball];
        Scenario own = scenario with { Balls = [], Scene = scenario.Scene with { Ball = launch.Ball }, Position = launch.Position, Velocity = launch.Velocity, Spin = launch.Spin };
        Outcome its = outcome with { Samples = outcome.BallSamples[ball], Events = [.. outcome.Events.Where(item => item.Ball == ball)] };
        return new ReplayShot(name, KickNumbers.Of(own).Text, new Track(own, its));
    }

    private static string Text(SceneShape shape) => $"{shape.Radius} {shape.Velocity} {string.Join(' ', shape.Points)}";
}
