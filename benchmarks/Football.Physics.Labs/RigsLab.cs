namespace FootballPhysics.Labs;

/// <summary>football lab rigs: the results of FIFA's rigs for pitches on every surface of both profiles, next to the windows of the tests.</summary>
internal static class RigsLab
{
    private const double TimeStep = 0.002;

    /// <summary>The height of the ball's lowest point before the drop, m.</summary>
    private const double DropHeight = 2;

    /// <summary>The speed of the ball for the angled shot, 50 km/h at 15° down, m/s.</summary>
    private const double ShotSpeed = 50 / 3.6;
    private const double ShotAngle = 15 * Math.PI / 180;

    /// <summary>The height of the ramp, m; it has an angle of 45° and two rails 100 mm apart inside.</summary>
    private const double RampHeight = 1;
    private const double RailGap = 0.1;

    private static readonly RigWindow Natural = new("natural pitch", (0.60, 1.00), (45, 60), (4, 10));
    private static readonly RigWindow Wet = new("natural pitch, wet", (0.60, 1.00), (45, 80), (4, 10));
    private static readonly RigWindow QualityPro = new("FIFA Quality Pro", (0.60, 0.85), (45, 60), (4, 8));
    private static readonly RigWindow Concrete = new("test ball on concrete", (1.32, 1.38), null, null);

    /// <summary>Every surface, its scene, and the requirements of the rigs; null if none are known.</summary>
    public static IReadOnlyList<(string Profile, string Surface, Scene Scene, RigWindow? Window)> Surfaces { get; } =
    [
        Measured("dryTurf", Ground.Of(SurfaceMaterial.DryTurf), Natural),
        Measured("artificialTurf", Ground.Of(SurfaceMaterial.ArtificialTurf), QualityPro),
        Measured("wetTurf", Ground.Of(SurfaceMaterial.WetTurf), Wet),
        Measured("matchTurf", Ground.Of(SurfaceMaterial.MatchTurf), Wet),
        Measured("hardGround", Ground.Of(SurfaceMaterial.HardGround), null),
        Measured("longGrass", Ground.Of(SurfaceMaterial.LongGrass), null),
        Measured("indoor", Ground.Of(SurfaceMaterial.Indoor), null),
        Measured("concrete", Ground.Of(SurfaceMaterial.Concrete), Concrete),
        Measured("snow", Ground.Of(SurfaceMaterial.Snow), null),
        Published("publishedTurf", Ground.PublishedTurf, Natural),
        Published("publishedWetTurf", Ground.Presets["publishedWetTurf"], Wet),
        Published("publishedCourt", Ground.Presets["publishedCourt"], null),
        Published("publishedSand", Ground.Presets["publishedSand"], null),
    ];

    public static Lab Create() => new Lab(
        "rigs",
        "FIFA's three pitch tests on every surface: drop from 2 m, shot of 50 km/h at 15°, roll from a ramp of 1 m, and the ranges that the tests accept.",
        ["football lab rigs", "football lab rigs --csv rigs.csv"]).Plays(Run);

    /// <summary>Returns the height of the bounce from 2 m, at the ball's lowest point, m.</summary>
    public static double Drop(Scene scene)
    {
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState state = simulator.Fly(new Vector3d(0, DropHeight + simulator.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero, TimeStep, 5, StopAt.Impact);
        double highest = simulator.ContactHeight;
        double before;
        do
        {
            before = state.Position.Y;
            simulator.Step(ref state, TimeStep, log);
            highest = Math.Max(highest, state.Position.Y);
        }
        while (state.Position.Y > before);
        return highest - simulator.ContactHeight;
    }

    /// <summary>Returns the share of the speed along the ground that remains of a shot without spin, %.</summary>
    public static double AngledShot(Scene scene)
    {
        var simulator = new Simulator(scene);
        var velocity = new Vector3d(ShotSpeed * Math.Cos(ShotAngle), -ShotSpeed * Math.Sin(ShotAngle), 0);
        return 100 * simulator.FirstImpact(new Vector3d(0, simulator.ContactHeight, 0), velocity, Vector3d.Zero, TimeStep, 1).Velocity.X / velocity.X;
    }

    /// <summary>Returns the length of the roll from the ramp, m.</summary>
    public static double Roll(Scene scene)
    {
        // On two rails a ball turns with the effective radius r' = √(r² − (w/2)²): v² = 2 g h/(1 + α (r/r')²), ω = v/r'.
        BallProperties ball = scene.Ball;
        double onRails = Math.Sqrt((ball.Radius * ball.Radius) - (0.25 * RailGap * RailGap));
        double turning = ball.Radius / onRails;
        double speed = Math.Sqrt(2 * scene.Gravity * RampHeight / (1 + (ball.InertiaFactor * turning * turning)));
        var simulator = new Simulator(scene);
        return simulator.Fly(
            new Vector3d(0, simulator.ContactHeight, 0), new Vector3d(speed, 0, 0), new Vector3d(0, 0, -speed / onRails), 5 * TimeStep, 120, StopAt.Rest).Position.X;
    }

    private static (string Profile, string Surface, Scene Scene, RigWindow? Window) Measured(string name, Ground ground, RigWindow? window) =>
        ("measured", name, Scene.Measured with { Ground = ground }, window);

    private static (string Profile, string Surface, Scene Scene, RigWindow? Window) Published(string name, Ground ground, RigWindow? window) =>
        ("published", name, Scene.Published with { Ground = ground }, window);

    private static void Run(LabRun run)
    {
        LabTable table = run.Table(
            "FIFA's rigs", "profile", "surface", "drop, m", "drop window", "drop is", "angle, %", "angle window", "angle is", "roll, m", "roll window", "roll is", "test");
        foreach ((string profile, string surface, Scene scene, RigWindow? window) in Surfaces)
        {
            double drop = Drop(scene);
            double angle = AngledShot(scene);
            double roll = Roll(scene);
            table.Add(
                [profile, surface, .. RigWindow.Cells(window?.Drop, drop), .. RigWindow.Cells(window?.Angle, angle), .. RigWindow.Cells(window?.Roll, roll), window?.Name]);
            run.Failed |= profile == "measured" && window is not null && !window.Holds(drop, angle, roll);
        }

        run.Notes.Add("The published profile is the thesis', whose numbers are not of rigs: what it fails is shown, and is no failure of the command.");
        run.Notes.Add("Where there is no window nothing was found: those surfaces are guesses. The angle is what is left of the speed along the ground.");
    }
}

/// <summary>The requirements of a test of pitches for the results of the rigs.</summary>
/// <param name="Name">The test.</param>
/// <param name="Drop">The least and greatest bounce, m.</param>
/// <param name="Angle">The share of the speed along the ground that remains, %.</param>
/// <param name="Roll">The length of the roll, m.</param>
internal sealed record RigWindow(string Name, (double Least, double Most)? Drop, (double Least, double Most)? Angle, (double Least, double Most)? Roll)
{
    /// <summary>Returns a result, its window and its verdict.</summary>
    public static object?[] Cells((double Least, double Most)? window, double value) => window is { } range
        ? [value, FormattableString.Invariant($"{range.Least:0.##} … {range.Most:0.##}"), Inside(window, value) ? "pass" : "FAIL"]
        : [value, null, null];

    public bool Holds(double drop, double angle, double roll) => Inside(Drop, drop) && Inside(Angle, angle) && Inside(Roll, roll);

    private static bool Inside((double Least, double Most)? window, double value) => window is not { } range || (value >= range.Least && value <= range.Most);
}
