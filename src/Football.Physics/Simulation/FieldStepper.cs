using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// A step in air whose wind depends on place or time, or with a knuckle force. Nearly every step is one piece of flight with nothing in it, taken
/// along the constant axis of the spin; all else is done as in any air.
/// </summary>
/// <typeparam name="TIntegrator">The one-step method.</typeparam>
internal sealed class FieldStepper<TIntegrator> : SceneStepper<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    private readonly StabilityLimit _limit;
    private readonly double _contactHeight;
    private readonly double _fastestWind;
    private readonly TIntegrator _integrator;

    public FieldStepper(Scene scene, SolverSettings settings, in SceneAir air)
        : base(scene, settings, in air)
    {
        _integrator = default;
        _limit = Limit;
        _contactHeight = Around.World.LevelContact;
        _fastestWind = Around.Air.FastestWind;
        TakeWholeSteps(scene, settings, in air);
    }

    public override void Step(ref BallState s, double dt, StepLog log)
    {
        if (s.Motion != MotionState.Airborne || _integrator.GainsByHops || !TryWhole(ref s, dt, log))
        {
            base.Step(ref s, dt, log);
        }
    }

    /// <summary>Takes a whole step, if nothing happens in it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool TryWhole(ref BallState s, double dt, StepLog log)
    {
        // The bound of the change errs towards no, as the guards do: the ground, a dip through it, the end of the spin.
        var from = new FieldMotion(in s);
        double most = (from.Velocity - Around.Wind).Length + _fastestWind;
        if (dt * _limit.RateAtMost(most, from.SpinRate) > StabilityLimit.LargestChange || (from.Y <= _contactHeight && from.VY < 0))
        {
            return false;
        }

        if (!IsClear(ref s, dt, most * most))
        {
            return false;
        }

        var system = new FieldSystem { Around = Around, Axis = s.Flight.Axis };
        _integrator.Advance(ref system, s.Time, in from, dt, out FieldStep step);
        log.Evaluations += _integrator.Stages;
        if (step.End.Y < _contactHeight || (from.VY < 0 && step.End.VY > 0) || step.End.SpinRate < 0)
        {
            return false;
        }

        if (log.Observer is null)
        {
            Move(ref s, in step, dt);
        }
        else
        {
            MoveAndShow(ref s, in system, in step, dt, log);
        }

        log.Steps++;
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Move(ref BallState s, in FieldStep step, double dt)
    {
        s.Position = step.End.Position;
        s.Flight.Velocity = step.End.Velocity;
        s.Flight.SpinRate = step.End.SpinRate;
        s.AirDistance = step.End.AirDistance;
        s.Angle += step.Turn;
        s.Branch = DragBranch.Unknown;
        s.Time += dt;
    }

    /// <summary>Moves the ball to the end of a whole step, and shows that to the observer.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveAndShow(ref BallState s, in FieldSystem system, in FieldStep step, double dt, StepLog log)
    {
        BallState before = s;
        Move(ref s, in step, dt);
        Vector3d acceleration = default;
        if (log.Observer!.WantsEndAcceleration)
        {
            system.Rates(s.Time, in step.End, out FieldRates end);
            acceleration = end.Acceleration;
            log.Evaluations++;
        }

        log.Show(in before, in s, in step.StartAcceleration, in acceleration, _integrator.Order);
    }
}
