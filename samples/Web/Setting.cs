using System.Globalization;
using System.Text;
using FootballPhysics.Shapes;

namespace FootballPhysics.Web;

/// <summary>The settings of a visitor, which give the scene and the C# program that builds it.</summary>
/// <param name="Profile">"measured" or "published".</param>
/// <param name="Ball">The name of a ball in <see cref="BallProperties.Presets"/>.</param>
/// <param name="Ground">The name of a ground in <see cref="FootballPhysics.Ground.Presets"/>.</param>
/// <param name="Altitude">Above the sea, m; at 0 the air is that of the default scene.</param>
/// <param name="WindAcross">To the right, m/s.</param>
/// <param name="WindAlong">Towards the goal, m/s.</param>
/// <param name="Distance">From the ball to the goal line, m.</param>
/// <param name="Aside">How far right of the goal's middle the ball lies, m.</param>
/// <param name="Wall">Players in the wall; 0 for none.</param>
/// <param name="Keeper">0 for none, 1 to 3 for how good he is.</param>
internal sealed record Setting(
    string Profile, string Ball, string Ground, double Altitude, double WindAcross, double WindAlong, double Distance, double Aside, int Wall, int Keeper)
{
    /// <summary>The step of the page, s.</summary>
    public const double TimeStep = 0.01;

    private const double WallDistance = 9.15;
    private const double Shoulder = 0.5;

    /// <summary>The default ground is that of the profile.</summary>
    private string GroundName => Profile == "published" && Ground == "matchTurf" ? "publishedTurf" : Ground;

    /// <summary>The goal that is kicked at.</summary>
    public Goal Goal => new() { Center = new Vector3d(-Aside, 0, -Distance), Facing = new Vector3d(0, 0, 1) };

    /// <summary>Where the ball lies.</summary>
    public Vector3d Start => new(0, BallProperties.Presets[Ball].Radius, 0);

    /// <summary>Where the players of the wall stand: on the way to the near half of the goal.</summary>
    public IReadOnlyList<Vector3d> Players
    {
        get
        {
            Vector3d towards = new Vector3d(-Aside + (Aside < 0 ? -1.3 : 1.3), 0, -Distance).Normalized();
            var along = new Vector3d(-towards.Z, 0, towards.X);
            double distance = Math.Min(WallDistance, 0.6 * Distance);
            return [.. Enumerable.Range(0, Wall).Select(i => (distance * towards) + ((i - (0.5 * (Wall - 1))) * Shoulder * along))];
        }
    }

    /// <summary>A goalkeeper of the chosen quality; null if there is none.</summary>
    public Keeper? NewKeeper() => Keeper == 0 ? null : new Keeper(Goal, Reaction, GloveSpeed);

    /// <summary>The scene, with a goalkeeper's bodies or without.</summary>
    public Scene Scene(KinematicBodies? bodies) => (Profile == "published" ? FootballPhysics.Scene.Published : FootballPhysics.Scene.Measured) with
    {
        Ball = BallProperties.Presets[Ball],
        Ground = FootballPhysics.Ground.Presets[GroundName],
        Air = (Altitude == 0 ? new Air() : Weather.AtAltitude(Altitude).ToAir()) with { Wind = new Vector3d(WindAcross, 0, -WindAlong) },
        Goals = [Goal],
        Obstacles = [.. Players.SelectMany(Player)],
        Bodies = bodies,
    };

    /// <summary>A program that plays a kick in this scene and prints what happens.</summary>
    public string Code(Vector3d velocity, Vector3d spin)
    {
        var code = new StringBuilder("using FootballPhysics;\nusing FootballPhysics.Prediction;\nusing FootballPhysics.Shapes;\n\n");
        code.Append(CultureInfo.InvariantCulture, $"var goal = new Goal {{ Center = {Of(Goal.Center)}, Facing = new Vector3d(0, 0, 1) }};\n");
        if (Keeper > 0)
        {
            code.Append(CultureInfo.InvariantCulture, $"var keeper = new Keeper(goal, reaction: {Reaction}, speed: {GloveSpeed});\n");
        }

        if (Wall > 0)
        {
            code.Append(CultureInfo.InvariantCulture, $"Vector3d[] wall = [{string.Join(", ", Players.Select(Of))}];\n");
        }

        string profile = Profile == "published" ? "Published" : "Measured";
        code.Append(CultureInfo.InvariantCulture, $"var scene = Scene.{profile} with\n{{\n    Ball = BallProperties.Presets[\"{Ball}\"],\n    Ground = Ground.Presets[\"{GroundName}\"],\n")
            .Append(CultureInfo.InvariantCulture, $"    Air = {(Altitude == 0 ? "new Air()" : $"Weather.AtAltitude({Altitude}).ToAir()")} with {{ Wind = {Of(new Vector3d(WindAcross, 0, -WindAlong))} }},\n    Goals = [goal],\n")
            .Append(Wall > 0 ? "    Obstacles =\n    [\n        .. wall.SelectMany(at => new[]\n        {\n"
                + "            new Obstacle { Name = \"wall\", Shape = new CapsuleShape(at + new Vector3d(0, 0.2, 0), at + new Vector3d(0, 1.35, 0), 0.2), Surface = SurfaceMaterial.Boot },\n"
                + "            new Obstacle { Name = \"wall\", Shape = new SphereShape(at + new Vector3d(0, 1.7, 0), 0.12), Surface = SurfaceMaterial.Head },\n        }),\n    ],\n" : "")
            .Append("};\n\n");
        if (Keeper > 0)
        {
            code.Append("var path = new Trajectory();\nvar empty = new Simulator(scene);\n")
                .Append(CultureInfo.InvariantCulture, $"empty.LookAhead(empty.Launch({Of(Start)}, {Of(velocity)}, {Of(spin)}), new LookAheadRequest {{ Duration = 3, TimeStep = {TimeStep} }}, path);\n")
                .Append("keeper.Watch(path);\n\n");
        }

        code.Append(CultureInfo.InvariantCulture, $"var ball = new Ball({(Keeper > 0 ? "scene with { Bodies = keeper.Bodies }" : "scene")});\n")
            .Append(CultureInfo.InvariantCulture, $"ball.Kick(velocity: {Of(velocity)}, spin: {Of(spin)});\n")
            .Append(CultureInfo.InvariantCulture, $"while (ball.Time < {Flight.Longest} && ball.Motion != MotionState.Rest)\n{{\n{(Keeper > 0 ? "    keeper.MoveTo(ball.Time);\n" : "")}    ball.Step({TimeStep});\n")
            .Append("    foreach (BallEvent happened in ball.Events)\n        Console.WriteLine(FormattableString.Invariant($\"{happened.Time:F6} {happened.Kind} {ball.Simulator.NameOf(happened.ColliderIndex)} {happened.Position.X:F6} {happened.Position.Y:F6} {happened.Position.Z:F6}\"));\n}\n");
        if (Keeper > 0)
        {
            code.Append('\n').Append(KeeperSource());
        }

        return code.ToString();
    }

    private double Reaction => Keeper switch { 1 => 0.38, 2 => 0.28, _ => 0.2 };

    private double GloveSpeed => Keeper switch { 1 => 3.6, 2 => 4.6, _ => 5.6 };

    private static Obstacle[] Player(Vector3d at) =>
    [
        new Obstacle { Name = "wall", Shape = new CapsuleShape(at + new Vector3d(0, 0.2, 0), at + new Vector3d(0, 1.35, 0), 0.2), Surface = SurfaceMaterial.Boot },
        new Obstacle { Name = "wall", Shape = new SphereShape(at + new Vector3d(0, 1.7, 0), 0.12), Surface = SurfaceMaterial.Head },
    ];

    private static string Of(Vector3d v) => FormattableString.Invariant($"new Vector3d({v.X + 0.0:R}, {v.Y + 0.0:R}, {v.Z + 0.0:R})");

    private static string KeeperSource()
    {
        using Stream source = typeof(Setting).Assembly.GetManifestResourceStream("Keeper.cs")!;
        string text = new StreamReader(source).ReadToEnd().ReplaceLineEndings("\n");
        return text[text.IndexOf("/// <summary>", StringComparison.Ordinal)..];
    }
}
