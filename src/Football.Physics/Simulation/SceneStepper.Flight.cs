namespace Football.Physics;

/// <content>Flight: the ball in the air, along a constant spin axis.</content>
internal sealed partial class Stepper<TAir, TIntegrator>
{
    /// <summary>A piece of flight: up to the end of the step, the drag law's jump, the end of the spin, or the ground.</summary>
    private void Fly(ref BallState s, ref StepRun run)
    {
        if (s.Position.Y <= _contact && s.Velocity.Y < 0)
        {
            Impact(ref s, ref run);
            return;
        }

        FlightPoint from;
        from.AirVelocity = s.Velocity - _wind;
        from.SpinRate = s.SpinRate;
        from.Axis = s.SpinAxis;
        from.Upward = _upward;
        double speedSquared = from.AirVelocity.LengthSquared;
        double surfaceSpeedSquared = _radiusSquared * s.SpinRate * s.SpinRate;
        if (_air.Jumps && (s.Branch == DragBranch.Unknown || !_locatesJump))
        {
            s.Branch = DragJump.At(speedSquared, surfaceSpeedSquared).Branch;
        }

        from.Branch = s.Branch;
        double h = run.Left;
        double bySpeed = h * _bound.PerSpeed;
        double bySpin = h * ((_bound.PerSpin * s.SpinRate) + _bound.Constant);
        if (bySpeed * bySpeed * speedSquared > 0.25 * LargestChange * LargestChange || bySpin > 0.5 * LargestChange)
        {
            h = Divide(h, (_bound.PerSpeed * Math.Sqrt(speedSquared)) + (_bound.PerSpin * s.SpinRate) + _bound.Constant);
        }

        _integrator.Fly(ref _air, in from, h, out FlightStep step);
        run.Log.Evaluations += _integrator.Stages;
        DragBranch next = s.Branch;
        if (_air.Jumps && _locatesJump)
        {
            var start = DragJump.At(speedSquared, surfaceSpeedSquared);
            DragJump startRate = FlightTrial.JumpRate(in from.AirVelocity, s.SpinRate, in step.StartAcceleration, step.StartSpinAcceleration, _ball.Radius);
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

        BallState before = s;
        Vector3d position = s.Position + (step.Path + (h * _wind));
        s.Position = hit ? new Vector3d(position.X, _contact, position.Z) : position;
        s.Velocity = step.AirVelocity + _wind;
        s.SpinRate = step.SpinRate;
        s.Angle += step.Turn;
        s.Branch = hit ? DragBranch.Unknown : next;
        s.Time += h;
        run.Left -= h;
        run.Log.Steps++;
        if (run.Log.Observer is { } observer)
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

        var trial = new FlightTrial<TAir, TIntegrator>(in _air, in from, s.Position.Y, _wind.Y, _ball.Radius) { End = step, Length = h };
        bool crosses = start.Branch == s.Branch && JumpLocator.Locate(ref trial, s.Branch, in start, in startRate, h);
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
        var trial = new FlightTrial<TAir, TIntegrator>(in _air, in from, s.Position.Y, _wind.Y, _ball.Radius);
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

        var trial = new FlightTrial<TAir, TIntegrator>(in _air, in from, s.Position.Y, _wind.Y, _ball.Radius);
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
