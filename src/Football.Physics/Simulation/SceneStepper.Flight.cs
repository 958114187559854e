using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <content>Flight: the ball in the air, along a constant spin axis.</content>
internal sealed partial class Stepper<TFast, TSpun, TAir, TIntegrator>
{
    /// <summary>A step of flight, done if nothing happens in it.</summary>
    /// <param name="s">The ball; moved only if nothing happens.</param>
    /// <param name="left">Length of the step, s.</param>
    /// <param name="log">Where the step is counted.</param>
    /// <param name="only">Whether the step is tried only where the fused laws hold and nothing is divided: a path without another call.</param>
    /// <param name="step">Where the integrator took it.</param>
    /// <param name="h">The length that was tried: less than the step's where that must be divided, 0 where nothing was tried.</param>
    /// <returns>True when the whole step is done.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool FlyWhole(ref BallState s, double left, StepLog log, bool only, out FlightStep step, out double h)
    {
        double vx = s.Flight.Velocity.X;
        double vy = s.Flight.Velocity.Y;
        double vz = s.Flight.Velocity.Z;
        double spin = s.Flight.SpinRate;
        double ux = vx - _wind.X;
        double uy = vy - _wind.Y;
        double uz = vz - _wind.Z;
        Vector3d position = s.Position;
        double y = position.Y;
        DragBranch branch = s.Branch;
        h = 0;
        if (y <= _contact && vy < 0)
        {
            step = default;
            return false;
        }

        double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);
        if (_air.Jumps && (branch == DragBranch.Unknown || !_locatesJump))
        {
            branch = DragJump.At(speedSquared, _radiusSquared * spin * spin).Branch;
            s.Branch = branch;
        }

        h = left;
        bool fast = _fast.Covers(speedSquared, spin, h);
        if (only && !fast)
        {
            h = 0;
            step = default;
            return false;
        }

        if ((_air.Drags || _air.Lifts || _air.SpinDecays) && !(fast && h <= _wholeUpTo))
        {
            double bySpeed = left * _bound.PerSpeed;
            double bySpin = left * ((_bound.PerSpin * spin) + _bound.Constant);
            if (bySpeed * bySpeed * speedSquared > 0.25 * LargestChange * LargestChange || bySpin > 0.5 * LargestChange)
            {
                if (only)
                {
                    h = 0;
                    step = default;
                    return false;
                }

                h = Divided(left, Math.Sqrt(speedSquared), spin, branch);
                if (h <= 0 && left > 0)
                {
                    step = default;
                    return false;
                }
            }
        }

        if (typeof(TIntegrator) == typeof(ExplicitEuler))
        {
            h = WithinHop(h, y - _contact, vy);
        }

        if (!(_air.Drags || _air.Lifts || _air.SpinDecays) && FallWhole(ref s, left, h, log))
        {
            step = default;
            return true;
        }

        if (only || fast)
        {
            _integrator.Fly(ref _fast, ref s.Flight, in _wind, branch, _upward, h, out step);
        }
        else if (_spun.Covers(speedSquared, spin, h))
        {
            _integrator.Fly(ref _spun, ref s.Flight, in _wind, branch, _upward, h, out step);
        }
        else
        {
            _integrator.Fly(ref _air, ref s.Flight, in _wind, branch, _upward, h, out step);
        }

        log.Evaluations += _integrator.Stages;
        double height = y + (step.Path.Y + (h * _wind.Y));
        double climb = step.AirVelocity.Y + _wind.Y;
        if (h < left || height < _contact || (vy < 0 && climb > 0) || log.Observer is not null
            || (_air.SpinDecays && step.SpinRate < 0)
            || (_air.Jumps && _locatesJump && MayCrossJump(branch, ux, uy, uz, speedSquared, spin, in step, h)))
        {
            s.Velocity = new Vector3d(vx, vy, vz);
            s.SpinRate = spin;
            return false;
        }

        s.Position = new Vector3d(position.X + (step.Path.X + (h * _wind.X)), height, position.Z + (step.Path.Z + (h * _wind.Z)));
        s.Angle += step.Turn;
        s.Time += h;
        log.Steps++;
        return true;
    }

    /// <summary>Whether a step may have crossed the drag law's jump.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool MayCrossJump(DragBranch branch, double ux, double uy, double uz, double speedSquared, double spin, in FlightStep step, double h)
    {
        var start = DragJump.At(speedSquared, _radiusSquared * spin * spin);
        var rate = DragJump.Rate(
            2.0 * ((ux * step.StartAcceleration.X) + (uy * step.StartAcceleration.Y) + (uz * step.StartAcceleration.Z)),
            2.0 * _radiusSquared * spin * step.StartSpinAcceleration);
        double wx = step.AirVelocity.X;
        double wy = step.AirVelocity.Y;
        double wz = step.AirVelocity.Z;
        var end = DragJump.At((wx * wx) + (wy * wy) + (wz * wz), _radiusSquared * step.SpinRate * step.SpinRate);
        return DragJump.MayCross(branch, in start, in rate, in end, h);
    }

    /// <summary>A step in vacuum, done if nothing happens in it: what the integrator makes of a constant acceleration.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool FallWhole(ref BallState s, double left, double h, StepLog log)
    {
        // p + h (v + c h g), v + h g
        double vy = s.Velocity.Y;
        double gained = h * _upward;
        double climb = vy + gained;
        double height = s.Position.Y + (h * (vy + (_integrator.ShareInPath * gained)));
        if (h < left || height < _contact || (vy < 0 && climb > 0) || log.Observer is not null)
        {
            return false;
        }

        s.Position = new Vector3d(s.Position.X + (h * s.Velocity.X), height, s.Position.Z + (h * s.Velocity.Z));
        s.Velocity = new Vector3d(s.Velocity.X, climb, s.Velocity.Z);
        s.Angle += h * s.SpinRate;
        s.Time += h;
        log.Steps++;
        log.Evaluations += _integrator.Stages;
        return true;
    }

    /// <summary>Wind, m/s.</summary>
    internal Vector3d Wind => _wind;

    /// <summary>Square of the ball's radius, m².</summary>
    internal double RadiusSquared => _radiusSquared;

    /// <summary>Takes a step of flight, with the fused laws where they hold.</summary>
    /// <returns>Right-hand sides evaluated.</returns>
    internal int Take(in FlightPoint from, double h, out FlightStep step)
    {
        FlightMotion motion;
        motion.Velocity = from.AirVelocity;
        motion.Axis = from.Axis;
        motion.SpinRate = from.SpinRate;
        double speedSquared = from.AirVelocity.LengthSquared;
        if (_fast.Covers(speedSquared, from.SpinRate, h))
        {
            _integrator.Fly(ref _fast, ref motion, Vector3d.Zero, from.Branch, from.Upward, h, out step);
        }
        else if (_spun.Covers(speedSquared, from.SpinRate, h))
        {
            _integrator.Fly(ref _spun, ref motion, Vector3d.Zero, from.Branch, from.Upward, h, out step);
        }
        else
        {
            _integrator.Fly(ref _air, ref motion, Vector3d.Zero, from.Branch, from.Upward, h, out step);
        }

        return _integrator.Stages;
    }

    /// <summary>The right-hand side at a point of a flight.</summary>
    internal void FlightRatesAt(in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate) =>
        FlightRates.Of(ref _air, in from, in u, spin, out acceleration, out spinRate);

    /// <summary>A piece of flight: up to the end of the step, the drag law's jump, the end of the spin, or the ground.</summary>
    private void Fly(ref BallState s, ref StepRun run)
    {
        double next = run.Next;
        if (FlyWhole(ref s, next, run.Log, false, out FlightStep step, out double h))
        {
            s.Time = Math.Min(s.Time, run.End);
            run.Left = next < run.Left ? run.Left - next : 0;
        }
        else if (h > 0)
        {
            run.Keep(h, next);
            FlyEventful(ref s, ref run, ref step, h);
        }
        else if (s.Position.Y <= _contact && s.Velocity.Y < 0)
        {
            Impact(ref s, ref run);
        }
        else
        {
            Relax(ref s, ref run);
        }
    }

    /// <summary>A piece of flight with something in it, from a trial that has found that out.</summary>
    private void FlyEventful(ref BallState s, ref StepRun run, ref FlightStep step, double h)
    {
        FlightPoint from;
        from.AirVelocity = s.Velocity - _wind;
        from.SpinRate = s.SpinRate;
        from.Axis = s.SpinAxis;
        from.Upward = _upward;
        from.Branch = s.Branch;
        DragBranch next = s.Branch;
        if (_air.Jumps && _locatesJump)
        {
            var start = DragJump.At(from.AirVelocity.LengthSquared, _radiusSquared * s.SpinRate * s.SpinRate);
            DragJump startRate = FlightTrial.JumpRate(in from.AirVelocity, s.SpinRate, in step.StartAcceleration, step.StartSpinAcceleration, _radiusSquared);
            var end = DragJump.At(step.AirVelocity.LengthSquared, _radiusSquared * step.SpinRate * step.SpinRate);
            if (DragJump.MayCross(s.Branch, in start, in startRate, in end, h))
            {
                next = CrossJump(in s, in from, in start, in startRate, ref step, ref h, ref run);
                if (h <= 0)
                {
                    s.Branch = next;
                    return;
                }
            }
        }

        if (_air.SpinDecays && step.SpinRate < 0)
        {
            EndSpin(in s, in from, ref step, ref h, ref run);
            next = s.Branch;
        }

        bool hit = false;
        double height = s.Position.Y + (step.Path.Y + (h * _wind.Y));
        double climb = step.AirVelocity.Y + _wind.Y;
        if (height < _contact || (s.Velocity.Y < 0 && climb > 0))
        {
            hit = Land(in s, in from, height, climb, ref step, ref h, ref run);
        }

        PieceObserver? observer = run.Log.Observer;
        BallState before = observer is null ? default : s;
        Vector3d position = s.Position + (step.Path + (h * _wind));
        s.Position = hit ? new Vector3d(position.X, _contact, position.Z) : position;
        s.Velocity = step.AirVelocity + _wind;
        s.SpinRate = step.SpinRate;
        s.Angle += step.Turn;
        s.Branch = hit ? DragBranch.Unknown : next;
        s.Time = Math.Min(s.Time + h, run.End);
        run.Left -= h;
        run.Log.Steps++;
        if (observer is not null)
        {
            Vector3d endAcceleration = default;
            if (observer.WantsEndAcceleration)
            {
                FlightRates.Of(ref _air, in from, in step.AirVelocity, step.SpinRate, out endAcceleration, out _);
                run.Log.Evaluations++;
            }

            Watch(observer, run.Log, in before, in step.StartAcceleration, in s, in endAcceleration);
        }

        if (hit && !run.Log.Halted)
        {
            Impact(ref s, ref run);
        }
    }

    /// <summary>Ends a step at its first crossing of the drag law's jump, and says which branch holds from there.</summary>
    /// <returns>The branch; with h = 0 the step must be taken again on it.</returns>
    private DragBranch CrossJump(
        in BallState s, in FlightPoint from, in DragJump start, in DragJump startRate, ref FlightStep step, ref double h, ref StepRun run)
    {
        if (run.Splits >= StepRun.MaximumSplits)
        {
            return s.Branch;
        }

        run.Splits++;
        if (start.Branch != s.Branch)
        {
            // On the surface to rounding. The branch of the step leads away from it only if the end is on that branch too.
            DragBranch resolved = ResolveBranch(s.Time, new Motion(s.Position, s.Velocity, s.Spin), s.Branch, ref run);
            if (resolved != s.Branch)
            {
                h = 0;
                return resolved;
            }
        }

        var trial = new FlightTrial<TFast, TSpun, TAir, TIntegrator>(this, in from, s.Position.Y) { End = step, Length = h };
        bool crosses = JumpLocator.Locate(ref trial, s.Branch, in start, in startRate, h);
        run.Log.Evaluations += trial.Evaluations;
        if (!crosses)
        {
            return s.Branch;
        }

        step = trial.End;
        h = trial.Length;
        var at = new Motion(s.Position, trial.End.AirVelocity + _wind, s.SpinAxis * trial.End.SpinRate);
        return ResolveBranch(s.Time + h, in at, s.Branch, ref run);
    }

    /// <summary>Which branch of the drag law holds from a point on its jump on.</summary>
    private DragBranch ResolveBranch(double time, in Motion at, DragBranch before, ref StepRun run)
    {
        FlightSystem<TAir> system = _flight;
        DragJump here = system.JumpAt(in at);
        DragBranch along = here.NearerToSpeed ? DragBranch.AlongCriticalSpeed : DragBranch.AlongCriticalSpin;
        system.Branch = along;
        double share = system.SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
        run.Log.Evaluations += 2;
        DragJump inside = system.JumpRate(in at, in spinning);
        DragJump outside = system.JumpRate(in at, in noSpin);
        double a = here.NearerToSpeed ? inside.Speed : inside.Spin;
        double b = here.NearerToSpeed ? outside.Speed : outside.Spin;

        // a: how the law with spin moves across the surface towards its own side; b: how the law without does.
        return a < 0 && b > 0 && share > 0 && share < 1 ? along
            : a > 0 && b > 0 ? DragBranch.Spinning
            : a < 0 && b < 0 ? DragBranch.NoSpin
            : before == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
    }

    /// <summary>Ends a step where its spin reaches zero: decay never reverses a spin.</summary>
    private void EndSpin(in BallState s, in FlightPoint from, ref FlightStep step, ref double h, ref StepRun run)
    {
        var trial = new FlightTrial<TFast, TSpun, TAir, TIntegrator>(this, in from, s.Position.Y);
        double low = 0;
        double high = h;
        double tau = h * s.SpinRate / (s.SpinRate - step.SpinRate);
        for (int i = 0; i < 8; i++)
        {
            tau = Math.Min(Math.Max(tau, low), high);
            trial.Step(tau);
            double w = trial.End.SpinRate;
            if (Math.Abs(w) <= 1e-14 * s.SpinRate || !(tau > 0))
            {
                break;
            }

            if (w > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            tau += w * tau / (s.SpinRate - w);
        }

        run.Log.Evaluations += trial.Evaluations;
        step = trial.End;
        step.SpinRate = 0;
        h = trial.Length;
    }

    /// <summary>Ends a step where the ball touches the ground.</summary>
    /// <returns>False where it does not after all.</returns>
    private bool Land(in BallState s, in FlightPoint from, double height, double climb, ref FlightStep step, ref double h, ref StepRun run)
    {
        var arc = new HeightArc(s.Position.Y - _contact, s.Velocity.Y, step.StartAcceleration.Y, height - _contact, climb, h);
        if (height >= _contact && (_settings.CollisionTiming == CollisionTiming.Bisection || !arc.Dips))
        {
            return false;
        }

        var trial = new FlightTrial<TFast, TSpun, TAir, TIntegrator>(this, in from, s.Position.Y);
        bool hit = true;
        if (_settings.CollisionTiming == CollisionTiming.Bisection)
        {
            ContactLocator.Bisection(ref trial, h, _settings.CollisionTolerance, _contact);
        }
        else
        {
            hit = ContactLocator.Exact(ref trial, _integrator, in arc, _contact);
        }

        run.Log.Evaluations += trial.Evaluations;
        if (hit)
        {
            step = trial.End;
            step.SpinRate = Math.Max(0, step.SpinRate);
            h = trial.Length;
        }

        return hit;
    }
}
