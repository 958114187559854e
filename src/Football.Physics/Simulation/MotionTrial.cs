using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A general step, to be taken with several lengths.</summary>
internal struct MotionTrial<TSystem, TIntegrator> : ITrial
    where TSystem : struct, IMotionSystem
    where TIntegrator : struct, IIntegrator
{
    public TSystem System;
    public MotionStep Step1;
    public double Length;
    private readonly Motion _from;
    private readonly Vector3d _wind;
    private readonly double _radius;
    private readonly double _time;
    private TIntegrator _integrator;

    public MotionTrial(in TSystem system, double time, in Motion from, in Vector3d wind, double radius)
    {
        Unsafe.SkipInit(out Step1);
        System = system;
        _time = time;
        _from = from;
        _wind = wind;
        _radius = radius;
        _integrator = default;
        Length = 0;
        Evaluations = 0;
    }

    public int Evaluations { get; private set; }

    public readonly double Height => Step1.End.Position.Y;

    public readonly double VerticalVelocity => Step1.End.Velocity.Y;

    public readonly DragJump EndJump => JumpAt(in Step1.End);

    public readonly DragJump StartJump => JumpAt(in _from);

    public readonly DragJump StartJumpRate => JumpRate(in _from, in Step1.StartRates);

    public void Step(double h)
    {
        _integrator.Advance(ref System, _time, in _from, h, out Step1);
        Length = h;
        Evaluations += _integrator.Stages;
    }

    public void Nudge(double dt)
    {
        Motion end = Step1.End;
        Vector3d a = Extrapolate.Rate(in _from.Velocity, in end.Velocity, in Step1.StartRates.Acceleration, Length);
        Vector3d b = Extrapolate.Rate(in _from.Spin, in end.Spin, in Step1.StartRates.SpinAcceleration, Length);
        Step1.End = end.After(dt, end.Velocity + ((0.5 * dt) * a), new MotionRates(in a, in b));
        Step1.Rotation += dt * end.Spin;
        Length += dt;
    }

    public DragJump EndJumpRate()
    {
        MotionRates rates = EndRates();
        return JumpRate(in Step1.End, in rates);
    }

    /// <summary>Rates at the end; one evaluation.</summary>
    public MotionRates EndRates()
    {
        System.Rates(_time + Length, in Step1.End, out MotionRates rates);
        Evaluations++;
        return rates;
    }

    private readonly DragJump JumpAt(in Motion at) =>
        DragJump.At((at.Velocity - _wind).LengthSquared, _radius * _radius * at.Spin.LengthSquared);

    private readonly DragJump JumpRate(in Motion at, in MotionRates rates) => DragJump.Rate(
        2.0 * Vector3d.Dot(at.Velocity - _wind, rates.Acceleration),
        2.0 * _radius * _radius * Vector3d.Dot(at.Spin, rates.SpinAcceleration));
}
