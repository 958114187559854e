using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>Everything that a flight depends on, except the kick: ball, air, gravity, forces, ground and objects.</summary>
/// <remarks>Immutable, except for the bodies and engine colliders that it refers to.</remarks>
public sealed record Scene
{
    /// <summary>The maximum number of nets, and of goals: a state stores one bit per net or goal.</summary>
    private const int MostNets = 64;

    /// <summary>The maximum number of zones in a scene.</summary>
    private const int MostZones = 10_000;

    // Create these on first use, because most games need none of them.
    private static Scene? s_published;
    private static Scene? s_vacuum;
    private static Scene? s_highAltitude;

    // Each scene gets its own instances, because a serialiser may write into the defaults of a new scene.

    /// <summary>The ball. Default <see cref="BallProperties.Modern"/>.</summary>
    public BallProperties Ball { get; init; } = new();

    /// <summary>The air. Default still air at sea level.</summary>
    public Air Air { get; init; } = new();

    /// <summary>The downward part of the gravitational acceleration, g, in m/s².</summary>
    /// <remarks>0 … 1000; default 9.81.</remarks>
    public double Gravity { get; init; } = 9.81;

    /// <summary>The gravitational acceleration as a vector, in m/s²; also sets <see cref="Gravity"/>.</summary>
    /// <remarks>
    /// y is −1000 … 0, x and z are within ±1000; default (0, −9.81, 0). A vector that is not straight down tilts the world: level ground
    /// becomes a slope.
    /// </remarks>
    public Vector3d GravityVector
    {
        get => new(Sideways.X, -Gravity, Sideways.Z);
        init => (Gravity, Sideways) = (value.Y == 0 ? 0 : -value.Y, new Vector3d(value.X, 0, value.Z));
    }

    /// <summary>The horizontal part of gravity, in m/s².</summary>
    internal Vector3d Sideways { get; init; }

    /// <summary>True if gravity is not straight down.</summary>
    internal bool IsTilted => Sideways != Vector3d.Zero;

    /// <summary>True if a custom force acts.</summary>
    internal bool HasOwnForces => Forces.CustomForces.Count > 0;

    /// <summary>The forces that act, and the law of each. Default: all, with the measured laws.</summary>
    public ForceSet Forces { get; init; } = new();

    /// <summary>The ground. Default: level <see cref="SurfaceMaterial.MatchTurf"/>.</summary>
    public Ground Ground { get; init; } = new();

    /// <summary>The obstacles that the ball can hit: walls, posts, players. Default: none.</summary>
    public IReadOnlyList<Obstacle> Obstacles { get; init; } = [];

    /// <summary>The nets that do not belong to a goal. Default: none.</summary>
    /// <remarks>At most 64 nets, including those of the goals.</remarks>
    public IReadOnlyList<Net> Nets { get; init; } = [];

    /// <summary>The goals, with their frames and nets; at most 64. Default: none.</summary>
    public IReadOnlyList<Goal> Goals { get; init; } = [];

    /// <summary>The zones that report when the ball enters or leaves them; at most 10 000. Default: none.</summary>
    public IReadOnlyList<Zone> Zones { get; init; } = [];

    /// <summary>The bodies that your game moves: players' feet and heads, a keeper's hands. Default: none.</summary>
    public KinematicBodies? Bodies { get; init; }

    /// <summary>The colliders of a game engine. Default: none.</summary>
    public IEngineColliders? EngineColliders { get; init; }

    /// <summary>The ball and turf of two tracked matches, in still air at sea level, with the measured laws.</summary>
    public static Scene Measured { get; } = new();

    /// <summary>The scene used when none is given: <see cref="Measured"/>.</summary>
    public static Scene Default => Measured;

    /// <summary>A football over turf in still air at sea level, by the laws and numbers of the thesis.</summary>
    /// <remarks>The library was first built to implement this thesis. Its numbers are used as published.</remarks>
    public static Scene Published => s_published ??= new() { Forces = ForceSet.Published, Ground = Ground.PublishedTurf };

    /// <summary>The published scene without air: no buoyancy, drag, Magnus force or spin decay.</summary>
    public static Scene Vacuum => s_vacuum ??= Published with { Forces = ForceSet.None };

    /// <summary>The default scene in a stadium at 2 240 m (Mexico City), at 20 °C and 40 % humidity.</summary>
    /// <remarks>The air has a density of 0.913 kg/m³ and a kinematic viscosity of 1.99e-5 m²/s.</remarks>
    public static Scene HighAltitude => s_highAltitude ??= new() { Air = Weather.AtAltitude(2240, 20, 0.4).ToAir() };

    /// <summary>Creates the default scene with a steady wind.</summary>
    /// <param name="wind">The wind velocity, in m/s.</param>
    public static Scene Windy(Vector3d wind) => new() { Air = new Air { Wind = wind } };

    /// <summary>The motions of the obstacles with a finite mass, shared by the scenes of several balls. Default: the simulator creates its own.</summary>
    internal ObstacleMotions? Motions { get; init; }

    /// <summary>True if the ball can hit anything except the ground.</summary>
    /// <remarks>An empty list of bodies counts as none: no body can be added once a simulator exists.</remarks>
    internal bool HasThings => Obstacles.Count > 0 || Nets.Count > 0 || Goals.Count > 0 || Bodies is { Count: > 0 } || EngineColliders is not null;

    /// <summary>Throws if a number of the scene is out of range.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException">A part is null; the message names it.</exception>
    public void Validate()
    {
        // Check for null first, so that the message names the missing part before anything reads the part.
        Check.Member("ball", Ball);
        Check.Member("air", Air);
        Check.Member("forces", Forces);
        Check.Member("ground", Ground);
        Check.Member("obstacles", Obstacles);
        Check.Member("nets", Nets);
        Check.Member("goals", Goals);
        Check.Member("zones", Zones);

        // Check each part alone, then the limits that involve several parts: minimum mass (air), damping and hollows (ball).
        Ball.Validate();
        Air.Validate();
        Check.Within("gravity", Gravity, 0, 1000);
        Check.Within("gravity[0]", Sideways.X, -1000, 1000);
        Check.Within("gravity[2]", Sideways.Z, -1000, 1000);
        Forces.Validate();
        ValidateLightness();
        ValidateGround();
        ValidateThings();
        ValidateZones();
    }

    /// <summary>Throws if the ball is too light for the air that it displaces, or its spin decays too fast.</summary>
    private void ValidateLightness()
    {
        // With a smaller mass, buoyancy alone would exceed twenty times the weight.
        double displaced = Buoyancy.DisplacedMass(Ball, Air);
        if (!(Ball.Mass >= 0.05 * displaced))
        {
            throw Check.Refusal("ball.mass", FormattableString.Invariant($"{Ball.Mass:R}"), FormattableString.Invariant($"at least a twentieth of the displaced air's mass, {displaced:R} kg"));
        }

        Check.Within("forces.spinDecayCoefficient", Forces.SpinDecayCoefficient, 0, Ball.MostDamping);
    }

    private void ValidateGround()
    {
        Check.Member("ground.material", Ground.Material);
        Check.Within("ground.tangentialRestitution[0]", Ground.Material.TangentialRestitution, -1, 1);
        Ground.Material.Validate("ground", Ball.MostDamping, mayAdd: false);
        SceneFields.Check(SceneFields.Ground, Ground, "ground.");
        if (Ground.TangentialRestitutionZ is { } tangential)
        {
            Check.Within("ground.tangentialRestitution[1]", tangential, -1, 1);
        }

        // A scene without a ground has the height −∞.
        if (!Ground.IsNone)
        {
            Check.Within("ground.height", Ground.Height, -Limits.Length, Limits.Length);
        }

        Check.Defined("ground.aerodynamics", Ground.Aerodynamics, (int)Ground.Aerodynamics, 3);

        // A vertical or overhanging ground has no upper side.
        Vector3d normal = Check.Direction("ground.normal", Ground.Normal);
        Check.Within("ground.normal[1]", normal.Y, 0, 1, exclusiveLow: true);
        if (!Ground.IsLevel || Ground.Pattern is not null)
        {
            ValidateShape(normal);
        }
    }

    private void ValidateShape(in Vector3d normal)
    {
        // x and z are not axes of a slope, so a slope has a single value for all directions.
        if (!Ground.IsLevel && Ground.TangentialRestitutionZ is { } z && z != Ground.Material.TangentialRestitution)
        {
            throw Check.Refusal(
                "ground.tangentialRestitution",
                FormattableString.Invariant($"[{Ground.Material.TangentialRestitution}, {z}]"),
                "two equal numbers, because the ground is not level");
        }

        // A step looks up these materials by index, so check all of them here.
        if (Ground.Pattern is { } pattern)
        {
            Check.Within("ground.pattern.minimumWidth", pattern.MinimumWidth, 0, double.PositiveInfinity, exclusiveLow: true);
            Check.Given("ground.pattern.surfaces", pattern.Surfaces);
            for (int i = 0; i < pattern.Surfaces.Count; i++)
            {
                Check.GivenItem("ground.pattern.surfaces", i, pattern.Surfaces[i], "a surface");
                pattern.Surfaces[i].Validate(Check.Item("ground.pattern.surfaces", i), Ball.MostDamping, mayAdd: false);
            }
        }

        // The ball must fit into every hollow: the slope is at most 1, the curvature at most half of the ball's own.
        if (Ground.Heights is { } heights)
        {
            Check.Within(heights.Steepest.Field("its steepest slope"), heights.Steepest.Value, 0, 1);
            Check.Within(heights.Strongest.Field("its strongest curvature, 1/m"), heights.Strongest.Value, 0, 0.5 / Ball.Radius);

            // Heights are measured along the vertical, so the plane below them must be level.
            if (normal != Vector3d.Up)
            {
                throw Check.Refusal("ground.normal", Ground.Normal.ToString(), "(0, 1, 0), because ground.heights is set");
            }
        }
    }

    private void ValidateThings()
    {
        for (int i = 0; i < Obstacles.Count; i++)
        {
            Check.GivenItem("obstacles", i, Obstacles[i], "an obstacle");
            Obstacles[i].Validate(Check.Item("obstacles", i), Ball);
        }

        Bodies?.Validate(Ball);

        // Include the nets of goals, because all nets share the 64 bits of a state.
        int nets = Nets.Count;
        for (int i = 0; i < Nets.Count; i++)
        {
            Check.GivenItem("nets", i, Nets[i], "a net");
            Nets[i].Validate(Check.Item("nets", i));
        }

        for (int i = 0; i < Goals.Count; i++)
        {
            Check.GivenItem("goals", i, Goals[i], "a goal");
            Goals[i].Validate(Check.Item("goals", i), Ball.MostDamping);
            nets += Goals[i].NetCount;
        }

        Check.Within("nets (those of the goals included)", nets, 0, MostNets);
        Check.Within("goals", Goals.Count, 0, MostNets);
    }

    private void ValidateZones()
    {
        Check.Within("zones", Zones.Count, 0, MostZones);
        var names = new HashSet<string>(StringComparer.Ordinal);
        for (int i = 0; i < Zones.Count; i++)
        {
            Check.GivenItem("zones", i, Zones[i], "a zone");
            Zones[i].Validate(Check.Item("zones", i), Ball);

            // Events identify zones by name.
            if (!names.Add(Zones[i].Name))
            {
                throw Check.Refusal(Check.Item("zones", i) + ".name", $"\"{Zones[i].Name}\"", "a name that no other zone has");
            }
        }
    }
}
