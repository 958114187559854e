using System.Text.Json;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tests.Reference;

/// <summary>A scenario and its exact result: a line of trajectories.ndjson.</summary>
internal sealed class ReferenceCase
{
    private ReferenceCase(JsonElement line)
    {
        Name = line.GetProperty("name").GetString()!;
        JsonElement scenario = line.GetProperty("scenario");
        Scene = ReadScene(scenario);
        JsonElement launch = scenario.GetProperty("launch");
        Position = Vector(launch.GetProperty("position"));
        Velocity = Vector(launch.GetProperty("velocity"));
        Spin = launch.TryGetProperty("spin", out JsonElement spin) ? Vector(spin) : Vector3d.Zero;
        Orientation = launch.TryGetProperty("orientation", out JsonElement turn) ? Rotation(turn) : Quaterniond.Identity;
        JsonElement stop = scenario.GetProperty("stop");
        StopAt = Choice<StopAt>(stop, "at");
        Duration = Number(stop, "time");
        Expected = new ReferenceResult(line.GetProperty("expected"));
    }

    /// <summary>All cases of the file.</summary>
    public static IReadOnlyList<ReferenceCase> All { get; } = [.. Lines("trajectories.ndjson").Select(line => new ReferenceCase(line))];

    public string Name { get; }

    public Scene Scene { get; }

    public Vector3d Position { get; }

    public Vector3d Velocity { get; }

    public Vector3d Spin { get; }

    public Quaterniond Orientation { get; }

    public StopAt StopAt { get; }

    public double Duration { get; }

    public ReferenceResult Expected { get; }

    /// <summary>The lines of a file beside this class.</summary>
    public static IEnumerable<JsonElement> Lines(string file) =>
        File.ReadLines(Path.Combine(AppContext.BaseDirectory, "Reference", file)).Select(line => JsonDocument.Parse(line).RootElement);

    internal static double Number(JsonElement of, string name) => of.GetProperty(name).GetDouble();

    internal static Vector3d Vector(JsonElement of) => new(of[0].GetDouble(), of[1].GetDouble(), of[2].GetDouble());

    internal static Quaterniond Rotation(JsonElement of) => new(of[0].GetDouble(), of[1].GetDouble(), of[2].GetDouble(), of[3].GetDouble());

    internal static T Choice<T>(JsonElement of, string name)
        where T : struct, Enum => Enum.GetValues<T>().Single(value => of.GetProperty(name).ValueEquals(Words.Of(value)));

    private static Scene ReadScene(JsonElement scenario)
    {
        JsonElement ball = scenario.GetProperty("ball");
        JsonElement air = scenario.GetProperty("air");
        JsonElement forces = scenario.GetProperty("forces");
        JsonElement ground = scenario.GetProperty("ground");
        return Scene.Published with
        {
            Ball = new BallProperties { Mass = Number(ball, "mass"), Radius = Number(ball, "radius"), InertiaFactor = Number(ball, "inertiaFactor") },
            Air = new Air
            {
                Density = Number(air, "density"),
                KinematicViscosity = Number(air, "kinematicViscosity"),
                Wind = Vector(air.GetProperty("wind")),
            },
            Gravity = Number(scenario, "gravity"),
            Forces = ForceSet.Published with
            {
                Buoyancy = forces.GetProperty("buoyancy").GetBoolean(),
                Drag = Choice<ForceLaw>(forces, "drag"),
                Magnus = Choice<ForceLaw>(forces, "magnus"),
                SpinDecay = Choice<ForceLaw>(forces, "spinDecay"),
                Coefficients = Choice<AerodynamicModel>(forces, "coefficients"),
                DragCoefficient = Number(forces, "dragCoefficient"),
                MagnusCoefficient = Number(forces, "magnusCoefficient"),
                SpinDecayCoefficient = Number(forces, "spinDecayCoefficient"),
            },
            Ground = Ground.PublishedTurf with
            {
                Material = SurfaceMaterial.PublishedTurf with
                {
                    NormalRestitution = Number(ground, "normalRestitution"),
                    SpinRestitution = Number(ground, "spinRestitution"),
                    SlidingFriction = Number(ground, "slidingFriction"),
                    RollingResistance = Number(ground, "rollingFriction"),
                    SpinDamping = Number(ground, "spinDamping"),
                    TangentialRestitution = ground.GetProperty("tangentialRestitution")[0].GetDouble(),
                },
                MinimumBounceSpeed = Number(ground, "minimumBounceSpeed"),
                RestEnergy = Number(ground, "restEnergy"),
                Height = Number(ground, "height"),
                Aerodynamics = Choice<GroundAerodynamics>(ground, "aerodynamics"),
                TangentialRestitutionZ = ground.GetProperty("tangentialRestitution")[1].GetDouble(),
            },
        };
    }
}
