namespace Football.Physics;

/// <summary>A step in flight along a constant spin axis, to be taken with several lengths.</summary>
internal struct FlightTrial<TFast, TSpun, TAir, TIntegrator> : ITrial
    where TFast : struct, IAerodynamics
    where TSpun : struct, IAerodynamics
    where TAir : struct, IAerodynamics
    where TIntegrator : struct, IIntegrator
{
    public FlightStep End;
    public double Length;
    private readonly Stepper<TFast, TSpun, TAir, TIntegrator> _stepper;
    private readonly FlightPoint _from;
    private readonly double _height;

    public FlightTrial(Stepper<TFast, TSpun, TAir, TIntegrator> stepper, in FlightPoint from, double height)
    {
        _stepper = stepper;
        _from = from;
        _height = height;
        End = default;
        Length = 0;
        Evaluations = 0;
    }

    public int Evaluations { get; private set; }

    public readonly double Height => _height + (End.Path.Y + (Length * _stepper.Wind.Y));

    public readonly double VerticalVelocity => End.AirVelocity.Y + _stepper.Wind.Y;

    public readonly DragJump EndJump => DragJump.At(End.AirVelocity.LengthSquared, _stepper.RadiusSquared * End.SpinRate * End.SpinRate);

    public void Step(double h)
    {
        Evaluations += _stepper.Take(in _from, h, out End);
        Length = h;
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
        _stepper.FlightRatesAt(in _from, in End.AirVelocity, End.SpinRate, out Vector3d a, out double b);
        Evaluations++;
        return FlightTrial.JumpRate(in End.AirVelocity, End.SpinRate, in a, b, _stepper.RadiusSquared);
    }
}

/// <summary>What every flight trial shares.</summary>
internal static class FlightTrial
{
    /// <summary>Rates of the drag law's jump: d|u|²/dt = 2 u·a, d(r|ω|)²/dt = 2 r² |ω| d|ω|/dt.</summary>
    public static DragJump JumpRate(in Vector3d airVelocity, double spinRate, in Vector3d acceleration, double spinAcceleration, double radiusSquared) =>
        DragJump.Rate(2.0 * Vector3d.Dot(in airVelocity, in acceleration), 2.0 * radiusSquared * spinRate * spinAcceleration);
}
