using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>
/// Shots that answer questions: whether the goalkeeper reaches the ball, which kick bounces once, which goes in off the post, and how certain a
/// penalty is.
/// </summary>
internal static class QueryShots
{
    private const double Penalty = 11;
    private const double Post = 16;
    private static readonly Vector3d s_from = new(0, 0.11, 0);

    /// <summary>The position of a diving goalkeeper's feet before the shot, m.</summary>
    public static Vector3d KeeperFeet { get; } = new(0, 0, -Post + 0.5);

    /// <summary>A goalkeeper who is beaten.</summary>
    public static GalleryShot Beaten() => Keeper("keeper-beaten", "A keeper who is beaten", new Vector3d(-4.8, 4, -26));

    /// <summary>A goalkeeper who saves the shot.</summary>
    public static GalleryShot Saved() => Keeper("keeper-saves", "A keeper who saves", new Vector3d(-3.2, 6, -24));

    /// <summary>A pass that bounces once.</summary>
    public static GalleryShot OneBounce()
    {
        var target = new Vector3d(-2, 0.6, -24);
        var request = new AimRequest { From = s_from, Target = target, Speed = 19, TopSpin = 10, MaximumElevationDegrees = 40, Tolerance = 0.001 };
        AimResult found = new BankShotAimer(Scene.Measured).Find(request, "ground");
        return new GalleryShot
        {
            Id = "one-bounce-pass",
            Name = "Pass with one bounce",
            About = "The library found this kick: one bounce, then up to a teammate's knee, 24 m away.",
            Scenario = Kick(Scene.Measured, found.Velocity, found.Spin),
            Points = [target],
            DrawnTo = 40,
        };
    }

    /// <summary>A shot aimed to go in off the post.</summary>
    public static GalleryShot OffThePost()
    {
        Scene scene = Scene.Measured with { Goals = [Furniture.Goal(Post)] };
        var target = new Vector3d(2.2, 0.9, -Post - 0.6);
        var request = new AimRequest { From = s_from, Target = target, Speed = 24, MaximumElevationDegrees = 30, Tolerance = 0.001 };
        AimResult found = new BankShotAimer(scene).Find(request, "left post");
        return new GalleryShot
        {
            Id = "in-off-the-post",
            Name = "In off the post, as aimed",
            About = "The library found this kick: off the inside of the post and in.",
            Scenario = Kick(scene, found.Velocity, found.Spin),
            Points = [target],
            DrawnTo = 20,
        };
    }

    /// <summary>A penalty with the ellipse of its scatter.</summary>
    public static GalleryShot Ellipse()
    {
        Goal goal = Furniture.Goal(Penalty);
        var velocity = new Vector3d(-6.7, 4.6, -23);
        var spread = new KickSpread { SpeedPercent = 3, ElevationDegrees = 1.2, AzimuthDegrees = 1.5 };
        GoalChanceResult scatter = new GoalChance(Scene.Measured).Find(s_from, velocity, Vector3d.Zero, spread, goal);
        return new GalleryShot
        {
            Id = "penalty-ellipse",
            Name = "How surely a penalty goes in",
            About = FormattableString.Invariant(
                $"The same penalty again and again, by a player who is off by a degree or so. The rings at the goal hold 39 and 86 of 100 such kicks; {100 * scatter.OnTarget:0} of 100 go in."),
            Scenario = Kick(Scene.Measured with { Goals = [goal] }, velocity, Vector3d.Zero),
            OnGoal = [Ring(goal, scatter, 1), Ring(goal, scatter, 2)],
            DrawnTo = 15,
        };
    }

    private static GalleryShot Keeper(string id, string name, Vector3d velocity)
    {
        Goal goal = Furniture.Goal(Post);
        Scene scene = Scene.Measured with { Goals = [goal] };
        var bodies = new KinematicBodies();
        var simulator = new Simulator(scene);
        var keeper = new KeeperDive(bodies.Add("keeper", KeeperDive.Kind), goal, simulator, KeeperFeet);
        keeper.Follow(simulator.Launch(s_from, velocity, Vector3d.Zero));
        KeeperResult answer = keeper.Answer;
        Vector3d At(double aside, double height) => new(-aside, height, -Post);
        string saved = answer.Saves ? FormattableString.Invariant($"He dives and saves it; he could have waited {answer.LatestReaction:0.00} s.") : "He dives, but he cannot get there in time.";
        return new GalleryShot
        {
            Id = id,
            Name = name,
            About = FormattableString.Invariant(
                $"{3.6 * velocity.Length:0} km/h from {Post:0} m, {Math.Abs(answer.LateralOffset):0.0} m beside the keeper. {saved} The frame is what he covers by then."),
            Keeper = keeper,
            SceneCode = "Scene.Measured",
            Scenario = Kick(scene with { Bodies = bodies }, velocity, Vector3d.Zero) with { BeforeStep = ball => keeper.Follow(in ball) },
            OnGoal =
            [
                new SceneShape("what he can cover by then", SceneShapeKind.Guide)
                {
                    Lines =
                    [
                        [
                            At(answer.ReachLeft, 0.01), At(answer.ReachRight, 0.01), At(answer.ReachRight, answer.ReachHeight), At(answer.ReachLeft, answer.ReachHeight),
                            At(answer.ReachLeft, 0.01),
                        ],
                    ],
                },
            ],
            DrawnTo = 20,
        };
    }

    /// <summary>Returns an ellipse in the plane of a goal with the given number of standard deviations.</summary>
    private static SceneShape Ring(Goal goal, GoalChanceResult scatter, double deviations)
    {
        double angle = scatter.AxisDegrees * Math.PI / 180;
        Vector3d Point(double t)
        {
            double along = deviations * scatter.LongAxis * Math.Cos(t);
            double across = deviations * scatter.ShortAxis * Math.Sin(t);
            double aside = scatter.Aside + (along * Math.Cos(angle)) - (across * Math.Sin(angle));
            return new Vector3d(-aside, scatter.Height + (along * Math.Sin(angle)) + (across * Math.Cos(angle)), goal.Center.Z);
        }

        return new SceneShape("one and two standard deviations", SceneShapeKind.Guide) { Lines = [[.. Enumerable.Range(0, 49).Select(i => Point(i * Math.PI / 24))]] };
    }

    private static Scenario Kick(Scene scene, Vector3d velocity, Vector3d spin) => GalleryShots.Shot(s_from, velocity, spin) with { Scene = scene };
}
