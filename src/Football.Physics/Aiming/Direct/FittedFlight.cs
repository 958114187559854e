namespace FootballPhysics.Aiming;

/// <summary>An approximate flight: drag and lift are quadratics in |u|² through the exact laws at three speeds.</summary>
/// <remarks>
/// Both coefficients fall as the spin decays. The error is a few millimetres at 25 m; the cost is a quarter of that of a full flight. The solvers rehearse
/// their first corrections in this flight.
/// </remarks>
internal struct FittedFlight
{
    /// <summary>The longest step, in s, at which RK4 is accurate to a millimetre, and the maximum number of steps.</summary>
    private const double LongestStep = 0.5;
    private const double MostSteps = 16;

    /// <summary>The largest ratio of the slowest to the fastest sampled speed; it keeps the samples apart.</summary>
    private const double Slowest = 0.9;

    /// <summary>The relative change of spin that measures its effect on drag and lift.</summary>
    private const double SpinChange = 0.02;

    /// <summary>The relative difference in spin for which a fit is valid; its error is then a few 1e-4.</summary>
    private const double CloseSpin = 0.05;

    /// <summary>The minimum spin of a fit, in rad/s.</summary>
    private const double LeastSpin = 1;

    /// <summary>The share of the flight time over which the end of the path is extrapolated to its plane.</summary>
    private const double Reach = 0.25;

    private Vector3d _wind;
    private double _upward;
    private double _spinRate;
    private double _middleSquared;
    private double _endSquared;
    private double _drag;
    private double _dragSlope;
    private double _dragBend;
    private double _lift;
    private double _liftSlope;
    private double _liftBend;

    private double _dragPerLoss;
    private double _liftPerLoss;
    private double _decay;
    private double _decaySlope;

    // The motion of the ball relative to the air.
    private Vector3d _axis;
    private Vector3d _path;
    private Vector3d _velocity;
    private Vector3d _from;
    private double _time;
    private double _lost;

    /// <summary>Fits drag and lift.</summary>
    /// <param name="context">The scene.</param>
    /// <param name="speed">The airspeed at launch, in m/s.</param>
    /// <param name="spinRate">The spin at launch, in rad/s.</param>
    /// <param name="drag">The approximate drag per length, in 1/m.</param>
    /// <param name="time">The approximate duration of the flight, in s.</param>
    public void Fit(AimContext context, double speed, double spinRate, double drag, double time)
    {
        _wind = context.Scene.Air.Wind;
        _upward = context.Upward;
        _spinRate = Math.Max(LeastSpin, spinRate);

        // The airspeed |u| = v/(1 + k v t), from v with the drag k per length, after half of the time and at the end.
        double slowing = drag * speed * time;
        double end = speed * Math.Min(Slowest, 1.0 / (1.0 + slowing));
        double middle = Math.Max(speed / (1.0 + (0.5 * slowing)), 0.5 * (speed + end));

        // Evaluate the exact laws at three speeds, and once more at the middle speed with slightly less spin.
        context.Factors(speed, _spinRate, out double drag0, out double lift0, out double decay0);
        context.Factors(middle, _spinRate, out double drag1, out double lift1, out _);
        context.Factors(end, _spinRate, out double drag2, out double lift2, out double decay2);
        context.Factors(middle, (1.0 - SpinChange) * _spinRate, out double lessDrag, out double lessLift, out _);

        // The loss of spin, t (d₀ − (d₀ − d₂) t/2T), and its effect on drag and lift.
        double perSpin = 1.0 / (SpinChange * _spinRate);
        _dragPerLoss = drag1 > 0 ? perSpin * (1.0 - (lessDrag / drag1)) : 0;
        _liftPerLoss = lift1 > 0 ? perSpin * (1.0 - (lessLift / lift1)) : 0;
        _decay = decay0;
        _decaySlope = 0.5 * (decay0 - decay2) / time;

        // Newton's divided differences.
        _middleSquared = middle * middle;
        _endSquared = end * end;
        double perFirst = 1.0 / ((speed * speed) - _middleSquared);
        double perSecond = 1.0 / (_middleSquared - _endSquared);
        double perBoth = 1.0 / ((speed * speed) - _endSquared);
        _drag = drag2;
        _dragSlope = (drag1 - drag2) * perSecond;
        _dragBend = (((drag0 - drag1) * perFirst) - _dragSlope) * perBoth;
        _lift = lift2;
        _liftSlope = (lift1 - lift2) * perSecond;
        _liftBend = (((lift0 - lift1) * perFirst) - _liftSlope) * perBoth;
    }

    /// <summary>True if the fit is valid for a spin, in rad/s.</summary>
    public readonly bool Fits(double spinRate) => Math.Abs(Math.Max(LeastSpin, spinRate) - _spinRate) < CloseSpin * _spinRate;

    /// <summary>Begins a flight.</summary>
    public void Begin(in Vector3d from, in Vector3d velocity, in Vector3d spin)
    {
        double spinRate = spin.Length;
        _from = from;
        _path = Vector3d.Zero;
        _velocity = velocity - _wind;
        _axis = spinRate > 0 ? spin / spinRate : Vector3d.Zero;
        _lost = _spinRate - spinRate;
        _time = 0;
    }

    /// <summary>Simulates to an approximate time, and from there to a plane.</summary>
    /// <returns>False if the plane is too far away.</returns>
    public bool Fly(double time, ref PlaneCrossing crossing)
    {
        AdvanceTo(time);

        // Extrapolate with a parabola: in a further time τ, the gap closes by v τ + a τ²/2, with the speed v and the acceleration a towards the plane.
        Vector3d position = _from + _path + (_time * _wind);
        Vector3d velocity = _velocity + _wind;
        Rates(in _velocity, _time, out Vector3d a);

        // Two fixed-point iterations: first the time at constant speed, then the time at the mean speed over it.
        double gap = -crossing.Beyond(in position, _time);
        double outward = crossing.Outward(in velocity);
        double tau = gap / outward;
        tau = gap / (outward + (0.5 * tau * crossing.Along(in a)));
        if (!(outward > 0 && Math.Abs(tau) < Reach * time))
        {
            return false;
        }

        crossing.Take(_time + tau, position + (tau * (velocity + ((0.5 * tau) * a))), velocity + (tau * a));
        return true;
    }

    /// <summary>Advances with the classical Runge–Kutta method; the rates depend on the velocity only, so the path costs little more.</summary>
    private void AdvanceTo(double time)
    {
        double left = time - _time;
        double steps = Math.Min(Math.Ceiling(left / LongestStep), MostSteps);
        double h = left / steps;
        for (int i = 0; i < steps; i++)
        {
            // Compute the path from the same four stages: u + h (k₁ + k₂ + k₃)/6.
            Vector3d u = _velocity;
            double start = _time + (i * h);
            Rates(in u, start, out Vector3d k1);
            Rates(u + ((0.5 * h) * k1), start + (0.5 * h), out Vector3d k2);
            Rates(u + ((0.5 * h) * k2), start + (0.5 * h), out Vector3d k3);
            Rates(u + (h * k3), start + h, out Vector3d k4);
            _path += h * (u + ((h / 6.0) * (k1 + k2 + k3)));
            _velocity += (h / 6.0) * (k1 + k4 + (2.0 * (k2 + k3)));
        }

        _time = time;
    }

    /// <summary>u̇ = L (ω̂ × u) − D u + g.</summary>
    private readonly void Rates(in Vector3d u, double time, out Vector3d rates)
    {
        // The factors D of drag and L of lift at this |u|², in Newton's form, reduced by the loss of spin.
        double loss = _lost + (time * (_decay - (time * _decaySlope)));
        double squared = u.LengthSquared;
        double past = squared - _endSquared;
        double beyond = squared - _middleSquared;
        double drag = (1.0 - (loss * _dragPerLoss)) * (_drag + (past * (_dragSlope + (beyond * _dragBend))));
        double lift = (1.0 - (loss * _liftPerLoss)) * (_lift + (past * (_liftSlope + (beyond * _liftBend))));
        rates = new Vector3d(
            (lift * ((_axis.Y * u.Z) - (_axis.Z * u.Y))) - (drag * u.X),
            (lift * ((_axis.Z * u.X) - (_axis.X * u.Z))) - (drag * u.Y) + _upward,
            (lift * ((_axis.X * u.Y) - (_axis.Y * u.X))) - (drag * u.Z));
    }
}
