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

    public readonly Vector3d Position => Taken.End.Position;

    public readonly Vector3d Velocity => Taken.End.Velocity;

    public readonly Vector3d StartAcceleration => Taken.StartRates.Acceleration;

    public readonly DragJump StartJump => DragJump.At(in _from, in _wind, _radius);

    public readonly DragJump StartJumpRate => DragJump.Rate(in _from, in Taken.StartRates, in _wind, _radius);

    public readonly DragJump EndJump => DragJump.At(in Taken.End, in _wind, _radius);

    public readonly Motion EndMotion => Taken.End;

    // Never inlined: one body for all who take the step again.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Step(double h)
    {
        _integrator.Advance(ref System, _time, in _from, h, out Taken);
        Length = h;
        Evaluations += _integrator.Stages;
    }

    public void MoveTo(ref BallState s) => System.Move(ref s, in _from, in Taken);

    public void Nudge(double dt)
    {
        // On by dt with the rates at the end, extrapolated from those of the start and the mean of the step.
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
        return DragJump.Rate(in Taken.End, in rates, in _wind, _radius);
    }

    public Vector3d EndAcceleration() => EndRates().Acceleration;

    /// <summary>Rates at the end; one evaluation.</summary>
    public MotionRates EndRates()
    {
        System.Rates(_time + Length, in Taken.End, out MotionRates rates);
        Evaluations++;
        return rates;
    }
}
