namespace FootballPhysics.Batch;

/// <summary>Which balls of a scene may fly in lanes: those that keep within the domain of the laws there and the reach of float; others fly alone.</summary>
internal readonly struct LaneDomain
{
    /// <summary>Greatest speed |u|, m/s.</summary>
    public const double GreatestSpeed = 128;

    /// <summary>Greatest surface speed r|ω|, m/s: beyond, the spin decay by two plates is not a parabola in the spin any more.</summary>
    public const double GreatestSurfaceSpeed = 14;

    /// <summary>Greatest height above where a flight ends, m: float then places that end within 4e-6 m.</summary>
    private const double GreatestDrop = 100;

    /// <summary>No force may change the motion in a step by more than twice this share of itself; the single ball then divides the step.</summary>
    private const double LargestChange = 0.5;

    private readonly double _radius;
    private readonly double _gravity;
    private readonly double _step;
    private readonly RateBound _bound;

    /// <param name="scene">The scene.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <exception cref="ArgumentOutOfRangeException">The scene names a law that there is not.</exception>
    public LaneDomain(Scene scene, double timeStep)
    {
        _radius = scene.Ball.Radius;
        _gravity = Math.Abs(Weight.UpwardAcceleration(scene));
        _step = timeStep;
        _bound = DragBound(scene) + SceneLaws.Magnus(scene).Bound + SceneLaws.SpinDecay(scene).Bound;
    }

    /// <summary>The bound of the drag within the domain: the measured law's rises with the speed, without end.</summary>
    private static RateBound DragBound(Scene scene)
    {
        if (scene.Forces.Drag != ForceLaw.Empirical || scene.Forces.Coefficients != AerodynamicModel.Measured)
        {
            return SceneLaws.Drag(scene).Bound;
        }

        MeasuredLaw law = default;
        law.Prepare(scene);
        return law.DragBound(GreatestSpeed);
    }

    /// <summary>No flight within the domain is accelerated more strongly, m/s².</summary>
    /// <param name="airSpeed">|u| at most, m/s.</param>
    /// <param name="spinRate">Size of the spin at most, rad/s.</param>
    public double AccelerationAtMost(double airSpeed, double spinRate) =>
        _gravity + (airSpeed * ((_bound.PerSpeed * airSpeed) + (_bound.PerSpin * spinRate) + _bound.Constant));

    /// <summary>True when a flight stays within the domain.</summary>
    /// <param name="airSpeedSquared">|u|² at the launch.</param>
    /// <param name="spinRate">Size of the spin.</param>
    /// <param name="drop">How far down it may come, the wind's share not counted, m.</param>
    /// <param name="windSpeed">Vertical speed of the wind, m/s.</param>
    /// <param name="duration">How long it may last, s.</param>
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
