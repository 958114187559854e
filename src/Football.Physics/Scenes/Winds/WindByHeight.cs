using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Laws;

/// <summary>A wind whose speed increases with the height above the ground, with or without gusts.</summary>
/// <remarks>
/// u(y) = u_ref ln((max(y, 0) + z₀)/z₀)/ln((z_ref + z₀)/z₀). The wind is a pure function of position, time and the seed of the gusts. Inside a stadium bowl, it
/// is only a rough approximation.
/// </remarks>
public sealed class WindByHeight : IWind
{
    private readonly double _perLogarithm; // u_ref/ln((z_ref + z₀)/z₀), m/s
    private readonly double _perRoughness; // 1/z₀
    private readonly double _alongX;
    private readonly double _alongZ;
    private readonly double _perSpeed; // 1/u_ref
    private readonly GustWaves? _gusts;

    /// <summary>Creates a wind with a speed and a direction.</summary>
    /// <param name="speed">The speed u_ref at the reference height, in m/s. 0 … 200.</param>
    /// <param name="directionX">The x component of the direction that the wind blows towards; its length does not matter, but must not be 0.</param>
    /// <param name="directionZ">The z component of the direction.</param>
    /// <param name="referenceHeight">The height z_ref, in m. 0.1 … 1000; default 10 (law: the height of meteorological wind measurements).</param>
    /// <param name="roughness">The roughness length z₀, in m. 1e-4 … 2; default 0.03 (measured: short grass).</param>
    /// <param name="gusts">The gusts; default none.</param>
    /// <param name="groundHeight">The height of the ground, in m. Within ±1e6; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public WindByHeight(
        double speed,
        double directionX,
        double directionZ,
        double referenceHeight = 10,
        double roughness = 0.03,
        Gusts? gusts = null,
        double groundHeight = 0)
    {
        Check.Within("air.wind.speed", speed, 0, 200);
        Check.Within("air.wind.referenceHeight", referenceHeight, 0.1, 1000);
        Check.Within("air.wind.roughness", roughness, 1e-4, 2);
        Check.Within("ground.height", groundHeight, -Limits.Length, Limits.Length);
        double size = Math.Sqrt((directionX * directionX) + (directionZ * directionZ));
        if (!(size > 1e-100 && size < 1e100))
        {
            throw Check.Refusal("air.wind.direction", $"[{directionX}, {directionZ}]", "[x, z], 2 finite numbers, not both 0");
        }

        // Keep a direction that is a unit vector to within rounding, so that a saved wind is bit-identical when loaded.
        size = Math.Abs(size - 1) <= 1e-15 ? 1 : size;

        // Check the gusts here, because a scene sees only an IWind and cannot check them.
        gusts?.Validate();
        Speed = speed;
        Direction = new Vector3d(directionX / size, 0, directionZ / size);
        ReferenceHeight = referenceHeight;
        Roughness = roughness;
        Gusts = gusts;
        GroundHeight = groundHeight;
        _alongX = Direction.X;
        _alongZ = Direction.Z;

        // Precompute the divisions for use in the steps.
        _perRoughness = 1.0 / roughness;
        _perLogarithm = speed / Elementary.Log((referenceHeight + roughness) / roughness);
        _perSpeed = speed > 0 ? 1.0 / speed : 0;
        _gusts = gusts is { Intensity: > 0 } && speed > 0 ? new GustWaves(gusts, speed) : null;

        // The mean wind far above any valid position, plus all gusts at their maximum: flights rely on this bound.
        Vector3d largest = new Vector3d(speed, 0, 0) + (_gusts?.Largest ?? Vector3d.Zero);
        MaximumSpeed = _perSpeed * MeanAt(4.0 * Limits.Length) * largest.Length;
        Check.Within("air.wind.speed (with its gusts, at any height)", MaximumSpeed, 0, Limits.Speed);
    }

    /// <summary>The speed at the reference height, in m/s.</summary>
    public double Speed { get; }

    /// <summary>The direction that the wind blows towards; a horizontal unit vector.</summary>
    public Vector3d Direction { get; }

    /// <summary>The height at which <see cref="Speed"/> applies, in m.</summary>
    public double ReferenceHeight { get; }

    /// <summary>The roughness length of the ground z₀, in m.</summary>
    public double Roughness { get; }

    /// <summary>The gusts; null if there are none.</summary>
    public Gusts? Gusts { get; }

    /// <summary>The height of the ground, in m.</summary>
    public double GroundHeight { get; }

    /// <inheritdoc/>
    public double MaximumSpeed { get; }

    /// <inheritdoc/>
    public Vector3d At(double time, in Vector3d position) => At(time, position.X, position.Y, position.Z);

    /// <summary>Returns the wind at a position given by its coordinates, in m/s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vector3d At(double time, double x, double y, double z)
    {
        // Below the ground, use the wind at ground level, because the logarithm is not defined there.
        double height = y - GroundHeight;
        height = height > 0 ? height : 0;
        double mean = MeanAt(height);
        return _gusts is null ? new Vector3d(mean * _alongX, 0, mean * _alongZ) : WithGusts(_gusts, ((x * _alongX) + (z * _alongZ)) - (Speed * time), height, mean);
    }

    // d and d⊥ are the directions along and across the wind, g₀, g₁ and g₂ the gusts, u the mean wind at height y, and u_ref that at the reference height.
    // ξ = (distance along the wind) − u_ref t,  W = d (u + f g₀) + d⊥ f g₁ + ŷ f₂ g₂,  f = u(y)/u_ref,  f₂ = f min(1, y/2)
    private Vector3d WithGusts(GustWaves gusts, double distance, double height, double mean)
    {
        Vector3d gust = gusts.At(distance);
        double share = mean * _perSpeed;
        double along = mean + (share * gust.X);
        double across = share * gust.Y;
        return new Vector3d(
            (along * _alongX) - (across * _alongZ),
            share * Math.Min(1.0, 0.5 * height) * gust.Z,
            (along * _alongZ) + (across * _alongX));
    }

    /// <summary>Returns u(y), in m/s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double MeanAt(double height) => _perLogarithm * LogarithmTable.Of((height * _perRoughness) + 1.0);
}
