namespace Football.Physics;

/// <summary>Which balls of a scene may fly in lanes: those that keep within the domain of the powers and the reach of float; others fly alone.</summary>
internal readonly struct LaneDomain
{
    /// <summary>Greatest height above where a flight ends, m: float then places that end within 4e-6 m.</summary>
    private const double GreatestDrop = 100;

    /// <summary>No force may change the motion in a step by more than twice this share of itself; the single ball then divides the step.</summary>
    private const double LargestChange = 0.5;

    private readonly double _radius;
    private readonly double _gravity;
    private readonly double _step;
    private readonly RateBound _bound;
    private readonly bool _covers;

    public LaneDomain(Scene scene, double timeStep)
    {
        ForceSet forces = scene.Forces;
        _covers = LaneFlight.Covers(scene);
        _radius = scene.Ball.Radius;
        _gravity = Math.Abs(Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene));
        _step = timeStep;
        _bound = default;
        if (forces.Drag == ForceLaw.Empirical)
        {
            EmpiricalDrag law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }
        else if (forces.Drag == ForceLaw.Constant)
        {
            ConstantDrag law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }

        if (forces.Magnus == ForceLaw.Empirical)
        {
            EmpiricalMagnus law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }
        else if (forces.Magnus == ForceLaw.Constant)
        {
            ConstantMagnus law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }

        if (forces.SpinDecay == ForceLaw.Empirical)
        {
            EmpiricalSpinDecay law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }
        else if (forces.SpinDecay == ForceLaw.Constant)
        {
            ConstantSpinDecay law = default;
            law.Prepare(scene);
            _bound += law.Bound;
        }
    }

    /// <summary>Whether a flight stays within the domain.</summary>
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
        return _covers
            && drop <= GreatestDrop
            && most < LanePowers.GreatestSpeed * LanePowers.GreatestSpeed
            && _radius * spinRate < LanePowers.GreatestSurfaceSpeed
            && bySpin <= LargestChange && bySpeed * bySpeed * most <= LargestChange * LargestChange;
    }
}
