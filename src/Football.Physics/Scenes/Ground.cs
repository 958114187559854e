using System.Text.Json.Serialization;

namespace FootballPhysics;

/// <summary>The ground: its material, its height and shape, and the thresholds of bounce and rest. By default it is level.</summary>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Ground
{
    /// <summary>The material. Default <see cref="SurfaceMaterial.MatchTurf"/>.</summary>
    public SurfaceMaterial Material { get; init; } = new();

    /// <summary>Tangential restitution along z, where it differs from that of the material. −1 … 1, only on level ground; default null: the same in all directions.</summary>
    public double? TangentialRestitutionZ { get; init; }

    /// <summary>A ball that leaves an impact upwards with a lower speed stays down, m/s. 0.001 … 10; default 0.2, a hop of 2 mm (guess).</summary>
    public double MinimumBounceSpeed { get; init; } = 0.2;

    /// <summary>A rolling ball with less kinetic energy is at rest, J. 1e-12 … 100; default 1e-4.</summary>
    public double RestEnergy { get; init; } = 1e-4;

    /// <summary>Height of the ground above the origin, m. Within ±1e6; default 0.</summary>
    public double Height { get; init; }

    /// <summary>Upward normal of a tilted plane through the point at <see cref="Height"/> above the origin; its y is above 0. Default straight up: level.</summary>
    public Vector3d Normal { get; init; } = Vector3d.Up;

    /// <summary>Heights of uneven ground, relative to <see cref="Height"/>. Default null: a plane.</summary>
    public HeightField? Heights { get; init; }

    /// <summary>Parts of the ground with another material. Default null: one material everywhere.</summary>
    public ISurfacePattern? Pattern { get; init; }

    /// <summary>The part of drag and Magnus force that acts on the ground. Default <see cref="GroundAerodynamics.Full"/>.</summary>
    public GroundAerodynamics Aerodynamics { get; init; } = GroundAerodynamics.Full;

    /// <summary>True when the ground is a level plane.</summary>
    public bool IsLevel => Heights is null && Normal.X == 0 && Normal.Z == 0;

    /// <summary>True when the ground is <see cref="None"/>.</summary>
    public bool IsNone => double.IsNegativeInfinity(Height);

    /// <summary>The ground of the published profile: its turf, and only the horizontal part of drag and Magnus force on the ground.</summary>
    public static Ground PublishedTurf { get; } = new() { Material = SurfaceMaterial.PublishedTurf, Aerodynamics = GroundAerodynamics.Horizontal };

    /// <summary>No ground: the ball falls for ever.</summary>
    public static Ground None { get; } = PublishedTurf with { Height = double.NegativeInfinity };

    /// <summary>Level ground of every material, and <see cref="None"/>, by the names that JSON, the command line and the engines use. Published materials have the published air on the ground.</summary>
    public static IReadOnlyDictionary<string, Ground> Presets { get; } = SurfaceMaterial.Presets
        .Select(preset => new KeyValuePair<string, Ground>(preset.Key, (preset.Key.StartsWith("published", StringComparison.Ordinal) ? PublishedTurf : new Ground()) with { Material = preset.Value }))
        .Append(new KeyValuePair<string, Ground>("none", None))
        .ToDictionary(preset => preset.Key, preset => preset.Value);

    /// <summary>Makes level ground of a material.</summary>
    /// <param name="material">The material.</param>
    /// <exception cref="ArgumentNullException"><paramref name="material"/> is null.</exception>
    public static Ground Of(SurfaceMaterial material)
    {
        Check.Given(nameof(material), material);
        return new Ground { Material = material };
    }
}
