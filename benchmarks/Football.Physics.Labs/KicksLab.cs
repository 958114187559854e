namespace FootballPhysics.Labs;

/// <summary>football lab kicks: kicks that were measured, filmed or described, simulated with both profiles.</summary>
internal static class KicksLab
{
    /// <summary>The kicks used balls of the time of the wind-tunnel tests: the generic ball on dry turf, by the measured laws.</summary>
    private static readonly Scene Tunnel = Scene.Measured with { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) };

    private const double Radius = 0.11;
    private const double Degree = Math.PI / 180;
    private const double RevolutionsPerSecond = 2 * Math.PI;

    /// <summary>The launch speed is unknown: it is set so that the measured laws reproduce the range in the film. The apex is then a result.</summary>
    private const double MenckeSpeed = 15.1;
    private const double MenckeElevation = 42.3 * Degree;

    /// <summary>29 yards, m.</summary>
    private const double BeckhamDistance = 26.5;

    /// <summary>The number of seeds of the knuckle force that are simulated.</summary>
    private const int Seeds = 200;

    public static Lab Create() => new Lab(
        "kicks",
        "Known kicks (measured, filmed or reported), compared with both profiles, including those that neither reproduces.",
        ["football lab kicks", "football lab kicks --csv kicks.csv"]).Plays(Run);

    /// <summary>All rows.</summary>
    public static IReadOnlyList<ReportedKick> Kicks { get; } =
    [
        new("Mencke, no spin", "range, m", 17.9, 0.1, scene => Landing(scene, MenckeSpeed, MenckeElevation).X, "the launch was set for this range by the measured laws"),
        new("Mencke, no spin", "height of the apex, m", 4.59, 0.05, scene => Apex(scene).Y, "the film's curve is symmetric, a drag crisis gives none"),
        new("Mencke, no spin", "way to the apex, m", 8.9, 0.1, scene => Apex(scene).X, "likewise"),
        new("Mencke, S 0.25", "aside at 16.35 m, m", -1.61, 0.1, MenckeAside, "needs C_L 0.45, outside every tunnel's series; the film's own first slope is not the stated one"),
        new("Carré, TV kick of 32.2 m/s", "time to the goal, s", 1.0, 0.1, scene => Television(scene).Time),
        new("Carré, TV kick of 32.2 m/s", "speed at the goal, m/s", 22.8, 1.5, scene => Television(scene).Speed),
        new("Beckham 2001, 36 m/s, 63 rad/s, 27 m", "off the tangent, m", 3, 0.3, scene => Aside(scene, 36, 63, 27), "popular numbers, which no drag law gives"),
        new("Roberto Carlos, 30 m/s, 10 rev/s, 30 m", "off the straight line, m", 4, 0.5, scene => Aside(scene, 30, 10 * RevolutionsPerSecond, 30), "reported with 3.5 N, which is the force at 25 m/s"),
        new("Physics World 1998, 25 m/s, 8 rev/s", "side force, N", 3.5, 0.4, scene => SideForce(scene, 25, 8 * RevolutionsPerSecond)),
        new("Physics World 1998, 30 m/s, 10 rev/s", "side force, N", 3.5, 0.4, scene => SideForce(scene, 30, 10 * RevolutionsPerSecond), "Asai's own medians give 5.6 N"),
        new("Punt of 28 m/s, no spin", "elevation of the longest, °", 45, 3, scene => Longest(scene, 1.0, 28, 0), "45° is the rule without air"),
        new("Throw-in of 18 m/s, backspin 20 rad/s", "elevation of the longest, °", 30, 3, scene => Longest(scene, 2.2, 18, -20)),
        new("1172 m for sea level, Brazuca, 34 m/s, 60 rad/s, 25 m", "less aside, m", 0.49, 0.1, scene => Thin(scene, 1172, 20), "the place and spin of the report are unknown"),
        new("12 °C for 27 °C, the same kick", "more aside, m", 0.166, 0.1, scene => Thin(scene, 0, 27) - Thin(scene, 0, 12), "likewise"),
        new("Knuckle ball of 30 m/s, 20 m", "scatter aside, SD, m", null, 0, Scatter),
    ];

    private static void Run(LabRun run)
    {
        LabTable table = run.Table("Kicks", "kick", "number", "reported", "±", "measured", "measured is", "published", "published is", "why not");
        foreach (ReportedKick kick in Kicks)
        {
            double measured = kick.Of(Tunnel);
            double published = kick.Of(Scene.Published);
            table.Add(kick.Name, kick.Number, kick.Reported, kick.Reported is null ? null : kick.Within, measured, kick.Verdict(measured), published, kick.Verdict(published), kick.WhyNot);
        }
    }

    private static Vector3d Landing(Scene scene, double speed, double elevation) =>
        new Simulator(scene).FirstImpact(new Vector3d(0, Radius, 0), Velocity(speed, elevation), Vector3d.Zero, 0.01, 20).Position;

    private static Vector3d Apex(Scene scene)
    {
        Vector3d highest = default;
        Fly(scene, new Vector3d(0, Radius, 0), Velocity(MenckeSpeed, MenckeElevation), Vector3d.Zero, state =>
        {
            highest = state.Position.Y > highest.Y ? state.Position : highest;
            return state.Velocity.Y < 0;
        });
        return highest;
    }

    /// <summary>Returns the lateral deviation of the kick launched 0.125 to one side and bent to the other.</summary>
    private static double MenckeAside(Scene scene)
    {
        Vector3d forwards = Velocity(MenckeSpeed, MenckeElevation);
        var velocity = new Vector3d(forwards.X, forwards.Y, 0.125 * forwards.X);
        return At(scene, 16.35, new Vector3d(0, 1, 0), velocity, new Vector3d(0, 0.25 * velocity.Length / Radius, 0)).Position.Z;
    }

    private static (double Time, double Speed) Television(Scene scene)
    {
        (double time, _, Vector3d velocity) = At(scene, BeckhamDistance, new Vector3d(0, Radius, 0), Velocity(32.2, 10 * Degree), new Vector3d(0, 55, 0));
        return (time, velocity.Length);
    }

    /// <summary>Returns the lateral deviation of a kick with spin about the vertical from its first direction, m.</summary>
    private static double Aside(Scene scene, double speed, double spin, double distance) =>
        Math.Abs(At(scene, distance, new Vector3d(0, Radius, 0), Velocity(speed, 12 * Degree), new Vector3d(0, spin, 0)).Position.Z);

    private static double SideForce(Scene scene, double speed, double spin)
    {
        new Simulator(scene).AirFactors(speed, spin, out _, out double lift);
        return scene.Ball.Mass * lift * speed;
    }

    /// <summary>Returns the elevation, °, of the kick with the greatest range at a speed.</summary>
    private static double Longest(Scene scene, double height, double speed, double topSpin)
    {
        double best = 0;
        double farthest = 0;
        for (double degrees = 20; degrees <= 60; degrees += 0.5)
        {
            double range = new Simulator(scene).FirstImpact(new Vector3d(0, height, 0), Velocity(speed, degrees * Degree), new Vector3d(0, 0, -topSpin), 0.02, 20).Position.X;
            (farthest, best) = range > farthest ? (range, degrees) : (farthest, best);
        }

        return best;
    }

    /// <summary>Returns the reduction of a kick's lateral deviation at an altitude, compared with sea level at 20 °C, m.</summary>
    private static double Thin(Scene scene, double altitude, double temperature)
    {
        Scene Of(Weather weather) => scene with { Ball = BallProperties.Brazuca, Air = weather.ToAir() };
        return Aside(Of(new Weather()), 34, 60, 25) - Aside(Of(Weather.AtAltitude(altitude, temperature)), 34, 60, 25);
    }

    /// <summary>Returns the standard deviation of the lateral positions at which knuckle balls of many seeds pass, m.</summary>
    private static double Scatter(Scene scene)
    {
        double squares = Enumerable.Range(1, Seeds).Sum(seed =>
        {
            Scene knuckle = scene with { Forces = scene.Forces with { KnuckleSeed = seed } };
            double aside = At(knuckle, 20, new Vector3d(0, Radius, 0), Velocity(30, 8 * Degree), Vector3d.Zero).Position.Z;
            return aside * aside;
        });
        return Math.Sqrt(squares / Seeds);
    }

    private static Vector3d Velocity(double speed, double elevation) => new(speed * Math.Cos(elevation), speed * Math.Sin(elevation), 0);

    /// <summary>Returns time, position and velocity of a ball when it passes a distance.</summary>
    private static (double Time, Vector3d Position, Vector3d Velocity) At(Scene scene, double distance, Vector3d position, Vector3d velocity, Vector3d spin)
    {
        BallState before = default;
        BallState after = Fly(scene, position, velocity, spin, state =>
        {
            bool passed = state.Position.X >= distance;
            before = passed ? before : state;
            return passed;
        });
        double share = (distance - before.Position.X) / (after.Position.X - before.Position.X);
        return (
            before.Time + (share * (after.Time - before.Time)),
            before.Position + (share * (after.Position - before.Position)),
            before.Velocity + (share * (after.Velocity - before.Velocity)));
    }

    private static BallState Fly(Scene scene, Vector3d position, Vector3d velocity, Vector3d spin, Func<BallState, bool> until)
    {
        var simulator = new Simulator(scene with { Ground = Ground.None });
        var log = new StepLog();
        BallState state = simulator.Launch(position, velocity, spin);
        while (!until(state) && state.Time < 20)
        {
            simulator.Step(ref state, 0.01, log);
        }

        return state;
    }
}

/// <summary>A published number of a kick.</summary>
/// <param name="Name">The kick.</param>
/// <param name="Number">The name of the number.</param>
/// <param name="Reported">The published number; null if none is known.</param>
/// <param name="Within">The tolerance.</param>
/// <param name="Of">Computes the number in a scene.</param>
/// <param name="WhyNot">The known reason for a deviation.</param>
internal sealed record ReportedKick(string Name, string Number, double? Reported, double Within, Func<Scene, double> Of, string? WhyNot = null)
{
    public string? Verdict(double value) => Reported is { } reported ? Math.Abs(value - reported) <= Within ? "met" : "NOT MET" : null;
}
