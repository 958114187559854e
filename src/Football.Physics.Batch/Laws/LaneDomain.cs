using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>The flights that lanes can simulate, limited by the domain of the laws and the range of floats.</summary>
/// <param name="scene">The scene.</param>
/// <param name="timeStep">The length of a step, in s.</param>
/// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
internal readonly struct LaneDomain(Scene scene, double timeStep)
{
    /// <summary>The greatest speed |u|, in m/s.</summary>
    public const double GreatestSpeed = 128;

    /// <summary>The greatest surface speed r|ω|, in m/s. Above it, the two-plate spin decay is no longer a parabola in the spin.</summary>
    public const double GreatestSurfaceSpeed = 14;

    /// <summary>The greatest height above the end of a flight, in m: floats then locate the end within 4e-6 m.</summary>
    private const double GreatestDrop = 100;

    /// <summary>Half the largest relative change of the motion by a force in a step. Above it, the single ball uses substeps.</summary>
    private const double LargestChange = 0.5;

    private readonly double _radius = scene.Ball.Radius;
    private readonly double _gravity = Math.Abs(Weight.UpwardAcceleration(scene));
    private readonly double _step = timeStep;
    private readonly RateBound _bound = SceneLaws.DragBound(scene, GreatestSpeed) + SceneLaws.Magnus(scene).Bound + SceneLaws.SpinDecay(scene).Bound;

    /// <summary>Returns a bound on the acceleration of flights in the domain, in m/s².</summary>
    /// <param name="airSpeed">The maximum |u|, in m/s.</param>
    /// <param name="spinRate">The maximum spin, in rad/s.</param>
    public double AccelerationAtMost(double airSpeed, double spinRate) =>
        _gravity + (airSpeed * ((_bound.PerSpeed * airSpeed) + (_bound.PerSpin * spinRate) + _bound.Constant));

    /// <summary>Returns true if a flight stays within the domain.</summary>
    /// <param name="airSpeedSquared">|u|² at the launch.</param>
    /// <param name="spinRate">The magnitude of the spin.</param>
    /// <param name="drop">The maximum descent, without the wind's share, in m.</param>
    /// <param name="windSpeed">The vertical speed of the wind, in m/s.</param>
    /// <param name="duration">The longest flight, in s.</param>
    public bool Covers(double airSpeedSquared, double spinRate, double drop, double windSpeed, double duration)
    {
        // In the air's frame only gravity does work.
        double most = airSpeedSquared + (2.0 * _gravity * (drop + (Math.Abs(windSpeed) * duration)));
        double bySpin = _step * ((_bound.PerSpin * spinRate) + _bound.Constant);
        double bySpeed = _step * _bound.PerSpeed;
        return drop <= GreatestDrop
            && most < GreatestSpeed * GreatestSpeed
            && _radius * spinRate < GreatestSurfaceSpeed
            && bySpin <= LargestChange && bySpeed * bySpeed * most <= LargestChange * LargestChange;
    }
}
