namespace Football.Physics;

/// <summary>A step in flight along a constant spin axis, to be taken with several lengths.</summary>
internal struct FlightTrial<TFast, TAir, TIntegrator> : ITrial
    where TFast : struct, IAerodynamics
    where TAir : struct, IAerodynamics
    where TIntegrator : struct, IIntegrator
{
    public FlightStep End;
    public double Length;
    private readonly FlightPoint _from;
    private readonly double _height;
    private readonly double _windUp;
    private readonly double _radius;
    private TFast _fast;
    private TAir _air;
    private TIntegrator _integrator;

    public FlightTrial(in TFast fast, in TAir air, in FlightPoint from, double height, double windUp, double radius)
    {
        _fast = fast;
        _air = air;
        _from = from;
        _height = height;
        _windUp = windUp;
        _radius = radius;
        _integrator = default;
        End = default;
        Length = 0;
        Evaluations = 0;
    }

    public int Evaluations { get; private set; }

    public readonly double Height => _height + (End.Path.Y + (Length * _windUp));

    public readonly double VerticalVelocity => End.AirVelocity.Y + _windUp;

    public readonly DragJump EndJump => DragJump.At(End.AirVelocity.LengthSquared, _radius * _radius * End.SpinRate * End.SpinRate);

    public void Step(double h)
    {
        if (_fast.Covers(_from.AirVelocity.LengthSquared, _from.SpinRate, h))
        {
            _integrator.Fly(ref _fast, in _from, h, out End);
        }
        else
        {
            _integrator.Fly(ref _air, in _from, h, out End);
        }

        Length = h;
        Evaluations += _integrator.Stages;
    }

    public void Nudge(double dt)
    {
        Vector3d a = Extrapolate.Rate(_from.AirVelocity, End.AirVelocity, End.StartAcceleration, Length);
        double b = Extrapolate.Rate(_from.SpinRate, End.SpinRate, End.StartSpinAcceleration, Length);
        End.Path += dt * (End.AirVelocity + ((0.5 * dt) * a));
        End.Turn += dt * End.SpinRate;
        End.AirVelocity += dt * a;
        End.SpinRate += dt * b;
        Length += dt;
    }

    public DragJump EndJumpRate()
    {
        FlightRates.Of(ref _air, in _from, in End.AirVelocity, End.SpinRate, out Vector3d a, out double b);
        Evaluations++;
        return FlightTrial.JumpRate(in End.AirVelocity, End.SpinRate, in a, b, _radius);
    }
}

/// <summary>What every flight trial shares.</summary>
internal static class FlightTrial
{
    /// <summary>Rates of the drag law's jump: d|u|²/dt = 2 u·a, d(r|ω|)²/dt = 2 r² |ω| d|ω|/dt.</summary>
    public static DragJump JumpRate(in Vector3d airVelocity, double spinRate, in Vector3d acceleration, double spinAcceleration, double radius) =>
        DragJump.Rate(2.0 * Vector3d.Dot(in airVelocity, in acceleration), 2.0 * radius * radius * spinRate * spinAcceleration);
}
