using System.Text.Json.Serialization;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>The ground: its material, height, shape, and the thresholds of bounce and rest. Default: level.</summary>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Ground
{
    /// <summary>The material. Default <see cref="SurfaceMaterial.MatchTurf"/>.</summary>
    public SurfaceMaterial Material { get; init; } = new();

    /// <summary>The tangential restitution along z. Default null: the material's value, in all directions.</summary>
    /// <remarks>−1 … 1. A different value is allowed only on level ground.</remarks>
    public double? TangentialRestitutionZ { get; init; }

    /// <summary>The minimum upward speed after an impact for the ball to bounce, in m/s. Default 0.2.</summary>
    /// <remarks>0.001 … 10. A slower ball stays on the ground. A speed of 0.2 m/s gives a hop of 2 mm (guess).</remarks>
    public double MinimumBounceSpeed { get; init; } = 0.2;

    /// <summary>The kinetic energy below which a rolling ball comes to rest, in J. 1e-12 … 100; default 1e-4.</summary>
    public double RestEnergy { get; init; } = 1e-4;

    /// <summary>The height of the ground above the origin, in m; within ±1e6. Default 0.</summary>
    public double Height { get; init; }

    /// <summary>The upward normal of a tilted plane. Default straight up: level ground.</summary>
    /// <remarks>The plane contains the point at <see cref="Height"/> above the origin. The normal's y is above 0.</remarks>
    public Vector3d Normal { get; init; } = Vector3d.Up;

    /// <summary>The heights of uneven ground, relative to <see cref="Height"/>. Default null: a plane.</summary>
    public HeightField? Heights { get; init; }

    /// <summary>The parts of the ground with another material. Default null: one material everywhere.</summary>
    public ISurfacePattern? Pattern { get; init; }

    /// <summary>The part of drag and Magnus force that acts while the ball is on the ground. Default <see cref="GroundAerodynamics.Full"/>.</summary>
    public GroundAerodynamics Aerodynamics { get; init; } = GroundAerodynamics.Full;

    /// <summary>True if the ground is a level plane.</summary>
    public bool IsLevel => Heights is null && Normal.X == 0 && Normal.Z == 0;

    /// <summary>True if there is no ground, as in <see cref="None"/>.</summary>
    public bool IsNone => double.IsNegativeInfinity(Height);

    /// <summary>The ground of the published profile: its turf, with only horizontal drag and Magnus force.</summary>
    public static Ground PublishedTurf { get; } = new() { Material = SurfaceMaterial.PublishedTurf, Aerodynamics = GroundAerodynamics.Horizontal };

    /// <summary>No ground: the ball falls for ever.</summary>
    public static Ground None { get; } = PublishedTurf with { Height = double.NegativeInfinity };

    /// <summary>The presets, by their names in JSON, on the command line and in the engines.</summary>
    /// <remarks>There is level ground of every preset material, and <see cref="None"/>. Ground of a published material uses
    /// <see cref="GroundAerodynamics.Horizontal"/>.</remarks>
    public static IReadOnlyDictionary<string, Ground> Presets { get; } = SurfaceMaterial.Presets
        .Select(preset => new KeyValuePair<string, Ground>(preset.Key, (preset.Key.StartsWith("published", StringComparison.Ordinal) ? PublishedTurf : new Ground()) with { Material = preset.Value }))
        .Append(new KeyValuePair<string, Ground>("none", None))
        .ToDictionary(preset => preset.Key, preset => preset.Value);

    /// <summary>Creates level ground with a material.</summary>
    /// <param name="material">The material.</param>
    /// <exception cref="ArgumentNullException"><paramref name="material"/> is null.</exception>
    public static Ground Of(SurfaceMaterial material)
    {
        Check.Given(nameof(material), material);
        return new Ground { Material = material };
    }
}
