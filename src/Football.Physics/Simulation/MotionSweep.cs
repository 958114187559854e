using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A step of any motion, to be taken with several lengths.</summary>
internal struct MotionSweep<TSystem, TIntegrator> : IFlightSweep
    where TSystem : struct, IMotionSystem
    where TIntegrator : struct, IIntegrator
{
    public TSystem System;
    public MotionStep Taken;
    private readonly Motion _from;
    private readonly Vector3d _wind;
    private readonly double _radius;
    private readonly double _time;
    private TIntegrator _integrator;

    public MotionSweep(in TSystem system, double time, in Motion from, in Vector3d wind, double radius)
    {
        Unsafe.SkipInit(out Taken);
        System = system;
        _time = time;
        _from = from;
        _wind = wind;
        _radius = radius;
        _integrator = default;
        Length = 0;
        Evaluations = 0;
    }

    public double Length { get; private set; }

    public int Evaluations { get; set; }

    public readonly double Height => Taken.End.Position.Y;

    public readonly double VerticalVelocity => Taken.End.Velocity.Y;

    public readonly Vector3d StartAcceleration => Taken.StartRates.Acceleration;

    public readonly DragJump StartJump => JumpAt(in _from);

    public readonly DragJump StartJumpRate => JumpRate(in _from, in Taken.StartRates);

    public readonly DragJump EndJump => JumpAt(in Taken.End);

    public readonly Motion EndMotion => Taken.End;

    public void Step(double h)
    {
        _integrator.Advance(ref System, _time, in _from, h, out Taken);
        Length = h;
        Evaluations += _integrator.Stages;
    }

    public void MoveTo(ref BallState s) => System.Move(ref s, in _from, in Taken);

    public void Nudge(double dt)
    {
        Motion end = Taken.End;
        Vector3d a = Extrapolate.Rate(in _from.Velocity, in end.Velocity, in Taken.StartRates.Acceleration, Length);
        Vector3d b = Extrapolate.Rate(in _from.Spin, in end.Spin, in Taken.StartRates.SpinAcceleration, Length);
        Taken.End = end.After(dt, end.Velocity + ((0.5 * dt) * a), new MotionRates(in a, in b));
        Taken.Rotation += dt * end.Spin;
        Length += dt;
    }

    public DragJump EndJumpRate()
    {
        MotionRates rates = EndRates();
        return JumpRate(in Taken.End, in rates);
    }

    public Vector3d EndAcceleration() => EndRates().Acceleration;

    /// <summary>Rates at the end; one evaluation.</summary>
    public MotionRates EndRates()
    {
        System.Rates(_time + Length, in Taken.End, out MotionRates rates);
        Evaluations++;
        return rates;
    }

    private readonly DragJump JumpAt(in Motion at) =>
        DragJump.At((at.Velocity - _wind).LengthSquared, _radius * _radius * at.Spin.LengthSquared);

    private readonly DragJump JumpRate(in Motion at, in MotionRates rates) => DragJump.Rate(
        2.0 * Vector3d.Dot(at.Velocity - _wind, rates.Acceleration),
        2.0 * _radius * _radius * Vector3d.Dot(at.Spin, rates.SpinAcceleration));
}
