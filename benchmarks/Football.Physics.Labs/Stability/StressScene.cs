using System.Globalization;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stability;

/// <summary>A scene, a kick, a method and its frames, all from one number.</summary>
internal sealed record StressScene
{
    /// <summary>The number from which the scene is drawn.</summary>
    public long Number { get; init; }

    public StressKind Kind { get; init; }

    public Integrator Integrator => Settings.Integrator;

    public required Scene Scene { get; init; }

    public required SolverSettings Settings { get; init; }

    public required Vector3d Position { get; init; }

    public required Vector3d Velocity { get; init; }

    public required Vector3d Spin { get; init; }

    /// <summary>The lengths of the frames, s.</summary>
    public required double[] Frames { get; init; }

    /// <summary>The time by which the ball must be at rest, s; the last frame is repeated until then. Null if nothing is guaranteed.</summary>
    public double? RestsBy { get; init; }

    /// <summary>True if the air can give the ball energy.</summary>
    public bool Windy => Scene.Air.Wind.Length > 0;

    /// <summary>True if the scene uses the measured laws of the air.</summary>
    public bool Measured => Scene.Forces.Coefficients == AerodynamicModel.Measured;

    public bool HasOwnForces => Scene.Forces.CustomForces.Count > 0;

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward => -Scene.Gravity + (Scene.Forces.Buoyancy
        ? 4.0 / 3.0 * Math.PI * Math.Pow(Scene.Ball.Radius, 3) * Scene.Air.Density * Scene.Gravity / Scene.Ball.Mass
        : 0);

    /// <summary>True if a game may have all of its numbers.</summary>
    public bool IsMild => Scene.Ball.Mass is >= 0.05 and <= 5
        && Scene.Ball.Radius is >= 0.05 and <= 0.3
        && Scene.Ball.InertiaFactor >= 0.3
        && !HasOwnForces
        && Scene.Forces.DragCoefficient <= 10
        && Math.Abs(Scene.Forces.MagnusCoefficient) <= 5
        && Scene.Forces.SpinDecayCoefficient <= 1
        && Velocity.Length <= 200
        && Spin.Length is 0 or (> 1e-100 and <= 1000)
        && Scene.Air.Wind.Length <= 200
        && Settings.CollisionTolerance <= 1e-3;

    /// <summary>Returns the scene in one line that can be typed in again.</summary>
    public string Text()
    {
        static string N(double value) => value.ToString("R", CultureInfo.InvariantCulture);
        static string V(Vector3d v) => $"[{N(v.X)},{N(v.Y)},{N(v.Z)}]";
        ForceSet f = Scene.Forces;
        Ground g = Scene.Ground;
        static string Limit(double value) => double.IsPositiveInfinity(value) ? "null" : N(value);
        string type = MeasuredStress.Curves.Append((Type: "modern", Curve: DragCurve.Modern)).Append((Type: "beachBall", Curve: DragCurve.SmoothSphere)).First(item => item.Curve == Scene.Ball.DragCurve).Type;
        string profile = Measured ? "\"profile\":\"measured\"," : "";
        string ofBall = Measured ? $"\"type\":\"{type}\"," : "";
        string ofGround = string.Concat(
            SceneFields.GroundMaterial.Select(field => $"\"{field.Name}\":{Limit(field.Get(g.Material))},")
                .Concat(SceneFields.Ground.Select(field => $"\"{field.Name}\":{N(field.Get(g))},")));
        double along = g.Material.TangentialRestitution;
        return $"{{{profile}\"ball\":{{{ofBall}\"mass\":{N(Scene.Ball.Mass)},\"radius\":{N(Scene.Ball.Radius)},\"inertiaFactor\":{N(Scene.Ball.InertiaFactor)}}},"
            + $"\"air\":{{\"density\":{N(Scene.Air.Density)},\"kinematicViscosity\":{N(Scene.Air.KinematicViscosity)},\"wind\":{V(Scene.Air.Wind)}}},"
            + $"\"gravity\":{N(Scene.Gravity)},\"forces\":{{\"buoyancy\":{(f.Buoyancy ? "true" : "false")},\"drag\":\"{Name(f.Drag)}\",\"magnus\":\"{Name(f.Magnus)}\","
            + $"\"spinDecay\":\"{Name(f.SpinDecay)}\",\"coefficients\":\"{Name(f.Coefficients)}\",\"dragCoefficient\":{N(f.DragCoefficient)},"
            + $"\"magnusCoefficient\":{N(f.MagnusCoefficient)},\"spinDecayCoefficient\":{N(f.SpinDecayCoefficient)}}},"
            + $"\"ground\":{{{ofGround}\"tangentialRestitution\":[{N(along)},{N(g.TangentialRestitutionZ ?? along)}],"
            + $"\"height\":{N(g.Height)},\"aerodynamics\":\"{Name(g.Aerodynamics)}\"}},"
            + $"\"launch\":{{\"position\":{V(Position)},\"velocity\":{V(Velocity)},\"spin\":{V(Spin)}}},"
            + $"\"solver\":{{\"integrator\":\"{Name(Settings.Integrator)}\",\"timeStep\":{N(Frames[^1])},\"rollingTransition\":\"{Name(Settings.RollingTransition)}\","
            + $"\"collisionTiming\":\"{Name(Settings.CollisionTiming)}\"}}}}";
    }

    private static string Name<T>(T value)
        where T : struct, Enum
    {
        string name = value.ToString();
        return char.ToLowerInvariant(name[0]) + name[1..];
    }
}

/// <summary>The kinds of scenes, which are the rows of the stress matrix.</summary>
internal enum StressKind
{
    /// <summary>Any shot: 0 to 200 m/s, spin 0 to 1000 rad/s about any axis, any allowed ground and laws, frames of 1 to 100 ms.</summary>
    AnyShot,

    /// <summary>Frames of 1 µs to 1 ms.</summary>
    ShortSteps,

    /// <summary>Frames of 0.1 to 1 s.</summary>
    LongSteps,

    /// <summary>Frames of any length, including 0, denormal lengths, and hitches of 5 s.</summary>
    IrregularFrames,

    /// <summary>Wind of 20 to 80 m/s from any direction, including from above and below.</summary>
    Hurricane,

    /// <summary>Launches at, on and under the ground, slow and fast.</summary>
    LaunchOnGround,

    /// <summary>Balls that graze the ground.</summary>
    Grazing,

    /// <summary>Normal restitution near 1, and the minimum bounce speed as low as allowed.</summary>
    BounceTrain,

    /// <summary>Spin without travel, in the air and on the ground.</summary>
    SpinWithoutTravel,

    /// <summary>Spin along the flight.</summary>
    GyroSpin,

    /// <summary>Shots at the drag law's jump, which has sliding modes.</summary>
    SlidingMode,

    /// <summary>Balls that must come to rest within a stated time.</summary>
    ComesToRest,

    /// <summary>Numbers far outside football: zero mass, zero size, zero gravity, gravity of 1e6, air like mercury.</summary>
    Absurd,
}

/// <summary>Measures by how many decades a scene lies outside the numbers of ordinary balls, grounds and kicks.</summary>
internal static class Absurdity
{
    public static double Of(StressScene scene)
    {
        BallProperties ball = scene.Scene.Ball;
        Air air = scene.Scene.Air;
        Ground ground = scene.Scene.Ground;
        ForceSet forces = scene.Scene.Forces;
        SolverSettings settings = scene.Settings;
        double decades = Outside(ball.Mass, 0.05, 5) + Outside(ball.Radius, 0.05, 0.3) + Outside(ball.InertiaFactor, 0.3, 1)
            + Outside(scene.Scene.Gravity, 1, 30)
            + Outside(air.Density, 0.5, 2) + Outside(air.KinematicViscosity, 1e-5, 3e-5) + Outside(air.Wind.Length, 1e-6, 30)
            + Outside(scene.Velocity.Length, 1e-3, 60) + Outside(scene.Spin.Length, 1e-3, 200)
            + (scene.HasOwnForces ? 2 : 0)
            + (settings.Integrator != Integrator.Rk4 ? 0.5 : 0)
            + (settings.CollisionTiming == CollisionTiming.Bisection ? 0.5 + Outside(settings.CollisionTolerance, 1e-9, 1e-3) : 0);
        decades += forces.Drag == ForceLaw.Constant ? Outside(forces.DragCoefficient, 0.01, 2) : 0;
        decades += forces.Magnus == ForceLaw.Constant ? Outside(forces.MagnusCoefficient, 0.01, 2) : 0;
        decades += forces.SpinDecay == ForceLaw.Constant ? Outside(forces.SpinDecayCoefficient, 1e-6, 1e-2) : 0;
        decades += 0.2 * (Outside(ground.Height, 1e-9, 1e4) + Outside(scene.Position.Length, 1e-9, 1e4));
        decades += 0.3 * (Outside(ground.Material.SlidingFriction, 0.01, 2) + Outside(ground.Material.RollingResistance, 0.001, 1) + Outside(ground.MinimumBounceSpeed, 0.001, 1));
        return decades;
    }

    /// <summary>Returns the decades by which a value lies outside a range; 0 is always ordinary.</summary>
    public static double Outside(double value, double low, double high)
    {
        double size = Math.Abs(value);
        return size == 0 ? 0 : size < low ? Math.Log10(low / size) : size > high ? Math.Log10(size / high) : 0;
    }
}
