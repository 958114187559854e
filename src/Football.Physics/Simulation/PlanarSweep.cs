using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A step on the flat ground, to be taken with several lengths.</summary>
internal struct PlanarSweep<TSystem, TIntegrator> : IFlowSweep
    where TSystem : struct, IPlanarSystem
    where TIntegrator : struct, IIntegrator
{
    public TSystem System;
    public PlanarStep Taken;
    private readonly PlanarMotion _from;
    private readonly Vector3d _wind;
    private readonly double _radius;
    private readonly double _height;
    private readonly double _time;
    private TIntegrator _integrator;

    public PlanarSweep(in TSystem system, double time, in PlanarMotion from, double height, in Vector3d wind, double radius)
    {
        Unsafe.SkipInit(out Taken);
        System = system;
        _time = time;
        _from = from;
        _height = height;
        _wind = wind;
        _radius = radius;
        _integrator = default;
        Length = 0;
        Evaluations = 0;
    }

    public double Length { get; private set; }

    public int Evaluations { get; set; }

    public readonly Vector3d Position => new(Taken.End.X, _height, Taken.End.Z);

    public readonly Vector3d Velocity => Taken.End.Velocity;

    public readonly Vector3d StartAcceleration => Taken.StartRates.Acceleration;

    public readonly DragJump StartJump => DragJump.At(in _from, in _wind, _radius);

    public readonly DragJump StartJumpRate => DragJump.Rate(in _from, in Taken.StartRates, in _wind, _radius);

    public readonly DragJump EndJump => DragJump.At(in Taken.End, in _wind, _radius);

    // Never inlined: one body for all who take the step again.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Step(double h)
    {
        _integrator.Advance(ref System, _time, in _from, h, out Taken);
        Length = h;
        Evaluations += _integrator.Stages;
    }

    public void Nudge(double dt)
    {
        PlanarMotion end = Taken.End;
        PlanarRates rates;
        rates.AX = Extrapolate.Rate(_from.VX, end.VX, Taken.StartRates.AX, Length);
        rates.AZ = Extrapolate.Rate(_from.VZ, end.VZ, Taken.StartRates.AZ, Length);
        rates.BX = Extrapolate.Rate(_from.WX, end.WX, Taken.StartRates.BX, Length);
        rates.BY = Extrapolate.Rate(_from.WY, end.WY, Taken.StartRates.BY, Length);
        rates.BZ = Extrapolate.Rate(_from.WZ, end.WZ, Taken.StartRates.BZ, Length);
        Taken.End = end.After(dt, end.VX + ((0.5 * dt) * rates.AX), end.VZ + ((0.5 * dt) * rates.AZ), in rates);
        Taken.Rotation += dt * end.Spin;
        Length += dt;
    }

    public DragJump EndJumpRate()
    {
        PlanarRates rates = EndRates();
        return DragJump.Rate(in Taken.End, in rates, in _wind, _radius);
    }

    public Vector3d EndAcceleration() => EndRates().Acceleration;

    /// <summary>Rates at the end; one evaluation.</summary>
    public PlanarRates EndRates()
    {
        System.Rates(_time + Length, in Taken.End, out PlanarRates rates);
        Evaluations++;
        return rates;
    }

    public void MoveTo(ref BallState s) => System.Move(ref s, in Taken);
}
