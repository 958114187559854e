using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>A step of flight along a constant spin axis, which can be repeated with other lengths.</summary>
/// <param name="around">The forces on the ball.</param>
/// <param name="flight">Takes the steps.</param>
/// <param name="from">The ball at the start.</param>
internal struct FlightSweep(Surroundings around, IFlight flight, in BallState from) : IFlightSweep
{
    /// <summary>The result of the step.</summary>
    public FlightStep Taken;
    private readonly Surroundings _around = around;
    private readonly IFlight _flight = flight;
    private readonly BallState _from = from;
    private readonly Vector3d _fromAirVelocity = from.Velocity - around.Wind;

    public double Length { get; set; }

    public int Evaluations { get; set; }

    public readonly Vector3d Position => _from.Position + (Taken.Path + (Length * _around.Wind));

    public readonly Vector3d Velocity => Taken.AirVelocity + _around.Wind;

    public readonly Vector3d StartAcceleration => Taken.StartAcceleration;

    public readonly DragJump StartJump => JumpAt(in _fromAirVelocity, _from.Flight.SpinRate);

    public readonly DragJump StartJumpRate =>
        JumpRate(in _fromAirVelocity, _from.Flight.SpinRate, in Taken.StartAcceleration, Taken.StartSpinAcceleration);

    public readonly DragJump EndJump => JumpAt(in Taken.AirVelocity, Taken.SpinRate);

    public readonly Motion EndMotion => new(Position, Velocity, _from.Flight.Axis * Taken.SpinRate, _from.AirDistance + Taken.AirDistance);

    public void Step(double h)
    {
        FlightMotion motion = _from.Flight;
        _flight.Fly(in _from, ref motion, in _around.Wind, _from.Branch, _around.Upward, h, out Taken);
        Evaluations += _flight.Stages;
        Length = h;
    }

    public void Nudge(double dt)
    {
        // Extrapolate by dt with the rates at the end, which follow from the rates at the start and the mean of the step.
        Vector3d a = Extrapolate.Rate(in _fromAirVelocity, in Taken.AirVelocity, in Taken.StartAcceleration, Length);
        double b = Extrapolate.Rate(_from.Flight.SpinRate, Taken.SpinRate, Taken.StartSpinAcceleration, Length);
        Taken.Path += dt * (Taken.AirVelocity + ((0.5 * dt) * a));
        Taken.Turn += dt * Taken.SpinRate;
        Taken.AirDistance += Length > 0 ? dt * Taken.AirDistance / Length : 0;
        Taken.AirVelocity += dt * a;
        Taken.SpinRate += dt * b;
        Length += dt;
    }

    public readonly void MoveTo(ref BallState s)
    {
        s.Position = Position;
        s.Velocity = Velocity;
        s.Flight.SpinRate = Math.Max(0, Taken.SpinRate);
        s.Angle += Taken.Turn;
        s.AirDistance += Taken.AirDistance;
    }

    public DragJump EndJumpRate()
    {
        EndRates(out Vector3d a, out double b);
        return JumpRate(in Taken.AirVelocity, Taken.SpinRate, in a, b);
    }

    public Vector3d EndAcceleration()
    {
        EndRates(out Vector3d acceleration, out _);
        return acceleration;
    }

    private void EndRates(out Vector3d acceleration, out double spinAcceleration)
    {
        BallState end = _from;
        MoveTo(ref end);
        end.Time += Length;
        FlightRates.Of(ref _around.Air, in end, _around.Upward, in Taken.AirVelocity, Taken.SpinRate, out acceleration, out spinAcceleration);
        Evaluations++;
    }

    private readonly DragJump JumpAt(in Vector3d airVelocity, double spinRate) =>
        DragJump.At(airVelocity.LengthSquared, _around.RadiusSquared * spinRate * spinRate);

    /// <summary>d|u|²/dt = 2 u·a, d(r|ω|)²/dt = 2 r² |ω| d|ω|/dt.</summary>
    private readonly DragJump JumpRate(in Vector3d airVelocity, double spinRate, in Vector3d acceleration, double spinAcceleration) =>
        DragJump.Rate(2.0 * Vector3d.Dot(in airVelocity, in acceleration), 2.0 * _around.RadiusSquared * spinRate * spinAcceleration);
}

/// <summary>A sweep of flight: along a constant spin axis, or with the full spin vector.</summary>
internal interface IFlightSweep : IFlowSweep
{
    /// <summary>Position, velocity and spin at the end.</summary>
    Motion EndMotion { get; }
}

/// <summary>A step of any motion, which can be repeated with other lengths.</summary>
internal struct MotionSweep<TSystem, TIntegrator> : IFlightSweep
    where TSystem : struct, IMotionSystem
    where TIntegrator : struct, IMotionMethod
{
    public TSystem System;
    public MotionStep Taken;
    private readonly Motion _from;
    private readonly MotionRates _start;
    private readonly Vector3d _wind;
    private readonly double _radius;
    private readonly double _time;
    private TIntegrator _integrator;

    /// <summary>Starts at a state with known rates: they are the first stage for any length.</summary>
    public MotionSweep(in TSystem system, double time, in Motion from, in MotionRates start, in Vector3d wind, double radius)
    {
        Unsafe.SkipInit(out Taken);
        System = system;
        _time = time;
        _from = from;
        _start = start;
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

    /// <summary>The motion at the start.</summary>
    public readonly Motion From => _from;

    // Never inlined, so that all callers share one body.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Step(double h)
    {
        _integrator.Advance(ref System, _time, in _from, in _start, h, out Taken);
        Length = h;
        Evaluations += _integrator.Stages - 1;
    }

    public void MoveTo(ref BallState s) => System.Move(ref s, in _from, in Taken);

    public void Nudge(double dt)
    {
        // Extrapolate by dt with the rates at the end, which follow from the rates at the start and the mean of the step.
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

    /// <summary>Evaluates the forces at a motion at the end time, for <see cref="IMotionSystem.Trace"/>.</summary>
    public void Evaluate(in Motion at)
    {
        System.Rates(_time + Length, in at, out _);
        Evaluations++;
    }

    /// <summary>Returns the rates at the end; one evaluation.</summary>
    public MotionRates EndRates()
    {
        System.Rates(_time + Length, in Taken.End, out MotionRates rates);
        Evaluations++;
        return rates;
    }
}
