namespace FootballPhysics;

/// <summary>Everything a flight depends on but the kick: ball, air, gravity, forces, ground. Built once; immutable.</summary>
public sealed record Scene
{
    /// <summary>Nets, and goals, of a scene at most: a state says of each in one bit whether the ball is in it.</summary>
    private const int MostNets = 64;

    /// <summary>Zones of a scene at most.</summary>
    private const int MostZones = 10_000;

    // Made when they are asked for: most games have none of them.
    private static Scene? s_published;
    private static Scene? s_vacuum;
    private static Scene? s_highAltitude;

    // New ones: a serializer may write into the values that a new scene has.

    /// <summary>The ball. Default <see cref="BallProperties.Modern"/>.</summary>
    public BallProperties Ball { get; init; } = new();

    /// <summary>The air. Default still air at sea level.</summary>
    public Air Air { get; init; } = new();

    /// <summary>Downward part of the gravitational acceleration, g, m/s². 0 … 1000; default 9.81.</summary>
    public double Gravity { get; init; } = 9.81;

    /// <summary>
    /// Gravitational acceleration as a vector, m/s²: y within −1000 … 0, x and z within ±1000; default (0, −9.81, 0). A vector that is not straight down tilts the world: level ground
    /// becomes a slope. Sets <see cref="Gravity"/> too.
    /// </summary>
    public Vector3d GravityVector
    {
        get => new(Sideways.X, -Gravity, Sideways.Z);
        init => (Gravity, Sideways) = (value.Y == 0 ? 0 : -value.Y, new Vector3d(value.X, 0, value.Z));
    }

    /// <summary>The horizontal part of gravity, m/s².</summary>
    internal Vector3d Sideways { get; init; }

    /// <summary>True if forces act that no law of the air gives: the game's own, or a gravity that is not straight down.</summary>
    internal bool HasOwnForces => Forces.CustomForces.Count > 0 || Sideways != Vector3d.Zero;

    /// <summary>Which forces act, and by which law. Default all of them, by the measured laws.</summary>
    public ForceSet Forces { get; init; } = new();

    /// <summary>The ground. Default <see cref="SurfaceMaterial.MatchTurf"/>, level.</summary>
    public Ground Ground { get; init; } = new();

    /// <summary>Things that can be hit: walls, posts, players. Default none.</summary>
    public IReadOnlyList<Obstacle> Obstacles { get; init; } = [];

    /// <summary>Nets, apart from those of the goals; at most 64 nets in all. Default none.</summary>
    public IReadOnlyList<Net> Nets { get; init; } = [];

    /// <summary>Goals, with their frames and nets; at most 64. Default none.</summary>
    public IReadOnlyList<Goal> Goals { get; init; } = [];

    /// <summary>Zones, which report when the ball enters and leaves them; at most 10 000. Default none.</summary>
    public IReadOnlyList<Zone> Zones { get; init; } = [];

    /// <summary>Things that the game moves: players' feet and heads, a keeper's hands. Default none.</summary>
    public KinematicBodies? Bodies { get; init; }

    /// <summary>The colliders of a game engine. Default none.</summary>
    public IEngineColliders? EngineColliders { get; init; }

    /// <summary>The ball and the turf of two tracked matches, in still air at sea level, by the measured laws.</summary>
    public static Scene Measured { get; } = new();

    /// <summary>The scene of whatever is given none: <see cref="Measured"/>.</summary>
    public static Scene Default => Measured;

    /// <summary>A football over turf in still air at sea level, by the laws and numbers of the thesis that the library began with, as published.</summary>
    public static Scene Published => s_published ??= new() { Forces = ForceSet.Published, Ground = Ground.PublishedTurf };

    /// <summary>The published scene without air: no buoyancy, drag, Magnus force or spin decay.</summary>
    public static Scene Vacuum => s_vacuum ??= Published with { Forces = ForceSet.None };

    /// <summary>A stadium at 2 240 m (Mexico City) at 20 °C and 40 % humidity: air of 0.913 kg/m³, kinematic viscosity 1.99e-5 m²/s.</summary>
    public static Scene HighAltitude => s_highAltitude ??= new() { Air = Weather.AtAltitude(2240, 20, 0.4).ToAir() };

    /// <summary>The default scene with a steady wind.</summary>
    /// <param name="wind">Wind velocity, m/s.</param>
    public static Scene Windy(Vector3d wind) => new() { Air = new Air { Wind = wind } };

    /// <summary>Where its obstacles with a mass are, shared by the scenes of several balls among them; default none of its own.</summary>
    internal ObstacleMotions? Motions { get; init; }

    /// <summary>True when the ball can meet anything except the ground. Bodies of which there are none count as nothing: a simulator lets nobody add one later.</summary>
    internal bool HasThings => Obstacles.Count > 0 || Nets.Count > 0 || Goals.Count > 0 || Bodies is { Count: > 0 } || EngineColliders is not null;

    /// <summary>Checks every number of the scene.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException">A part is null; the message names it.</exception>
    public void Validate()
    {
        // What is null is named before anything of it is read.
        Check.Member("ball", Ball);
        Check.Member("air", Air);
        Check.Member("forces", Forces);
        Check.Member("ground", Ground);
        Check.Member("obstacles", Obstacles);
        Check.Member("nets", Nets);
        Check.Member("goals", Goals);
        Check.Member("zones", Zones);

        // Parts alone, then what depends on several: the least mass on the air, the most damping and the sharpest hollow on the ball.
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

    /// <summary>Refuses a ball that is too light: it holds some of the air that it displaces, and nothing ends its spin at once.</summary>
    private void ValidateLightness()
    {
        // With less mass the buoyancy alone would be more than twenty times its weight.
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

        // The height of no ground is −∞.
        if (!Ground.IsNone)
        {
            Check.Within("ground.height", Ground.Height, -Limits.Length, Limits.Length);
        }

        Check.Defined("ground.aerodynamics", Ground.Aerodynamics, (int)Ground.Aerodynamics, 3);

        // A ground that leans over, or is a wall, has no above.
        Vector3d normal = Check.Direction("ground.normal", Ground.Normal);
        Check.Within("ground.normal[1]", normal.Y, 0, 1, exclusiveLow: true);
        if (!Ground.IsLevel || Ground.Pattern is not null)
        {
            ValidateShape(normal);
        }
    }

    private void ValidateShape(in Vector3d normal)
    {
        // Along x and z means nothing on a slope: one number for all directions.
        if (!Ground.IsLevel && Ground.TangentialRestitutionZ is { } z && z != Ground.Material.TangentialRestitution)
        {
            throw Check.Refusal(
                "ground.tangentialRestitution",
                FormattableString.Invariant($"[{Ground.Material.TangentialRestitution}, {z}]"),
                "two equal numbers, because the ground is not level");
        }

        // Its surfaces are checked here, for it is asked for them by number in a step.
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

        // A ball can lie in every hollow: slopes of at most 1, curvatures of at most half its own.
        if (Ground.Heights is { } heights)
        {
            Check.Within("ground.heights (its steepest slope)", heights.SteepestSlope, 0, 1);
            Check.Within("ground.heights (its strongest curvature, 1/m)", heights.StrongestCurvature, 0, 0.5 / Ball.Radius);

            // Heights are along the vertical: a plane cannot be tilted too.
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

        // Nets of goals count too: all share the 64 bits of a state.
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

            // Events tell zones apart by their names.
            if (!names.Add(Zones[i].Name))
            {
                throw Check.Refusal(Check.Item("zones", i) + ".name", $"\"{Zones[i].Name}\"", "a name that no other zone has");
            }
        }
    }
}
