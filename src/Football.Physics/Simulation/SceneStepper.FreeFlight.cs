namespace Football.Physics;

/// <content>Flight with the full spin vector: with forces of the game's own, and along the drag law's jump.</content>
internal sealed partial class Stepper<TFast, TSpun, TAir, TIntegrator>
{
    private void FlyFreely(ref BallState s, ref StepRun run)
    {
        if (s.Position.Y <= _contact && s.Velocity.Y < 0)
        {
            Impact(ref s, ref run);
            return;
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin);
        FlightSystem<TAir> system = _flight;
        if (_air.Jumps && (s.Branch == DragBranch.Unknown || !_locatesJump))
        {
            s.Branch = system.JumpAt(in from).Branch;
        }

        system.Branch = s.Branch;
        double asked = run.Next;
        double h = Divided(asked, (s.Velocity - _wind).Length, from.Spin.Length, s.Branch);
        if (h <= 0)
        {
            Relax(ref s, ref run);
            return;
        }

        run.Keep(h, asked);

        var trial = new MotionTrial<FlightSystem<TAir>, TIntegrator>(in system, s.Time, in from, in _wind, _ball.Radius);
        trial.Step(h);
        DragBranch next = s.Branch;
        if (_air.Jumps && _locatesJump && run.Splits < StepRun.MaximumSplits)
        {
            next = s.Branch >= DragBranch.AlongCriticalSpeed
                ? LeaveSurface(ref trial, s.Time, in from, h, ref run)
                : CrossJumpFreely(ref trial, s.Time, in from, s.Branch, h, ref run);
            if (trial.Length <= 0)
            {
                s.Branch = next;
                return;
            }
        }

        bool hit = LandFreely(ref trial, in s);
        run.Log.Evaluations += trial.Evaluations;
        BallState before = s;
        Motion end = trial.Step1.End;
        s.BaseOrientation = (Quaterniond.FromRotationVector(in trial.Step1.Rotation) * s.Orientation).Normalised();
        s.Angle = 0;
        s.Position = hit ? new Vector3d(end.Position.X, _contact, end.Position.Z) : end.Position;
        s.Velocity = end.Velocity;
        s.SetFlightSpin(_custom || Vector3d.Dot(in end.Spin, in from.Spin) > 0 ? end.Spin : Vector3d.Zero);
        s.Branch = hit ? DragBranch.Unknown : next;
        s.Time = Math.Min(s.Time + trial.Length, run.End);
        run.Left -= trial.Length;
        run.Log.Steps++;
        if (run.Log.Observer is { } observer)
        {
            MotionRates endRates = default;
            if (observer.WantsEndAcceleration)
            {
                endRates = trial.EndRates();
                run.Log.Evaluations++;
            }

            Watch(observer, run.Log, in before, in trial.Step1.StartRates.Acceleration, in s, in endRates.Acceleration);
        }

        if (hit && !run.Log.Halted)
        {
            Impact(ref s, ref run);
        }
    }

    private bool LandFreely(ref MotionTrial<FlightSystem<TAir>, TIntegrator> trial, in BallState s)
    {
        double h = trial.Length;
        var arc = new HeightArc(
            s.Position.Y - _contact, s.Velocity.Y, trial.Step1.StartRates.Acceleration.Y, trial.Height - _contact, trial.VerticalVelocity, h);
        bool below = arc.End < 0;
        if (_settings.CollisionTiming == CollisionTiming.Bisection)
        {
            if (below)
            {
                ContactLocator.Bisection(ref trial, h, _settings.CollisionTolerance, _contact);
            }

            return below;
        }

        if (!below && !(arc.StartVelocity < 0 && arc.EndVelocity > 0 && arc.Dips))
        {
            return false;
        }

        MotionTrial<FlightSystem<TAir>, TIntegrator> whole = trial;
        if (ContactLocator.Exact(ref trial, _integrator, in arc, _contact))
        {
            return true;
        }

        trial = whole;
        return false;
    }

    private DragBranch CrossJumpFreely(
        ref MotionTrial<FlightSystem<TAir>, TIntegrator> trial, double time, in Motion from, DragBranch branch, double h, ref StepRun run)
    {
        DragJump start = trial.StartJump;
        DragJump startRate = trial.StartJumpRate;
        DragJump end = trial.EndJump;
        if (!DragJump.MayCross(branch, in start, in startRate, in end, h))
        {
            return branch;
        }

        run.Splits++;
        if (start.Branch != branch)
        {
            DragBranch resolved = ResolveBranch(time, in from, branch, ref run);
            if (resolved != branch)
            {
                trial.Length = 0;
                return resolved;
            }
        }

        MotionTrial<FlightSystem<TAir>, TIntegrator> whole = trial;
        if (!JumpLocator.Locate(ref trial, branch, in start, in startRate, h))
        {
            trial = whole;
            return branch;
        }

        return ResolveBranch(time + trial.Length, in trial.Step1.End, branch, ref run);
    }

    /// <summary>Ends a step along the jump where one branch alone leads off it, or where the other surface is met.</summary>
    private DragBranch LeaveSurface(ref MotionTrial<FlightSystem<TAir>, TIntegrator> trial, double time, in Motion from, double h, ref StepRun run)
    {
        DragBranch along = trial.System.Branch;
        DragJump end = trial.EndJump;
        double other = along == DragBranch.AlongCriticalSpeed ? end.Spin : end.Speed;
        if (other <= 0)
        {
            double start = along == DragBranch.AlongCriticalSpeed ? trial.StartJump.Spin : trial.StartJump.Speed;
            run.Splits++;
            trial.Step(start > 0 ? h * start / (start - other) : 0);
            return DragBranch.NoSpin;
        }

        double share = trial.System.SpinningShare(time + h, in trial.Step1.End, out _, out _);
        run.Log.Evaluations += 2;
        if (share is >= 0 and <= 1)
        {
            return along;
        }

        double startShare = trial.System.SpinningShare(time, in from, out _, out _);
        run.Log.Evaluations += 2;
        run.Splits++;
        double limit = share > 1 ? 1 : 0;
        double fraction = startShare is > 0 and < 1 ? (limit - startShare) / (share - startShare) : 0;
        trial.Step(fraction * h);
        return share > 1 ? DragBranch.Spinning : DragBranch.NoSpin;
    }
}
