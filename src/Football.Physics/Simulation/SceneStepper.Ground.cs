namespace Football.Physics;

/// <content>The ball on the ground: sliding, rolling, coming to rest.</content>
internal sealed partial class Stepper<TFast, TSpun, TAir, TIntegrator>
{
    /// <summary>
    /// Towards the end of a slide or a roll, where the direction turns ever faster, a piece goes this share of the way for a step of
    /// 10 ms, and more, as the root, for a longer one.
    /// </summary>
    private const double Approach = 0.125;

    /// <summary>The largest such share.</summary>
    private const double LargestApproach = 0.4;

    /// <summary>The last of a slide, this share of a step long, is done in closed form with the mean push of the air.</summary>
    private const double ClosedForm = 0.04;

    /// <summary>ε of the heuristic, m/s.</summary>
    private const double HeuristicSlip = 1e-3;

    private void Slide(ref BallState s, ref StepRun run)
    {
        if (LeavesGround(ref s, ref run))
        {
            return;
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin);
        Vector3d slip = Slip.Of(from.Velocity, from.Spin, _ball.Radius);
        double size = slip.Length;
        bool exact = _settings.RollingTransition == RollingTransition.Exact;
        if (size < Slip.Rolling)
        {
            StartRolling(ref s, ref run);
            return;
        }

        SlidingSystem<TAir> system = _sliding;
        system.SlipDirection = slip / size;
        system.StartSpin = from.Spin;
        system.Branch = GroundBranch(ref s, in from);
        double next = run.Next;
        double airRate = GroundRateAtMost(in from, out double airSpeed);
        double h = next * airRate <= LargestChange ? next : DividedOnGround(next, in from, s.Branch);
        if (h <= 0)
        {
            RelaxOnGround(ref s, ref run);
            return;
        }

        run.Keep(h, next);
        double fastest = _around.Ground.Sliding + (_ball.Radius * _around.Ground.SlidingTorque)
            + (airRate * (airSpeed + (_ball.Radius * SumOfSizes(in from.Spin))));
        bool grips = _around.Ground.Sliding > 0;
        if (exact && grips && (_custom || fastest * h > Approach * size))
        {
            system.Rates(s.Time, in from, out MotionRates rates);
            run.Log.Evaluations++;

            // ṡ = v̇ + r ŷ × ω̇
            Vector3d slipRate = Slip.Of(rates.Acceleration, rates.SpinAcceleration, _ball.Radius);
            double friction = _around.Ground.Sliding + (_ball.Radius * _around.Ground.SlidingTorque);
            Vector3d push = slipRate + (friction * system.SlipDirection);
            if (size < 0.5 * friction * ClosedForm * run.Length && push.LengthSquared < 0.25 * friction * friction
                && EndSlide(ref s, ref run, ref system, in from, in slip, in push, friction, in rates))
            {
                return;
            }

            h = Shorten(h, run.Length, in system.SlipDirection, size, in slipRate);
        }

        var trial = new MotionTrial<SlidingSystem<TAir>, TIntegrator>(in system, s.Time, in from, in _wind, _ball.Radius);
        trial.Step(h);
        CrossJumpOnGround(ref trial, ref s, h, ref run);
        run.Log.Evaluations += trial.Evaluations;

        // Where friction does not turn the ball, or too weakly, its spin ends at zero.
        Vector3d spin = trial.Step1.End.Spin;
        spin = trial.System.StopsSpin(in spin) ? Vector3d.Zero : spin;
        MoveOnGround(ref s, ref trial, in spin, ref run);
        if (!exact && !run.Log.Halted)
        {
            // (2.27), (2.28): the slip grew, or is small.
            double after = Slip.Of(s.Velocity, s.Spin, _ball.Radius).Length;
            if (after > size || after < HeuristicSlip)
            {
                StartRolling(ref s, ref run);
            }
        }
    }

    /// <summary>The end of a slide in closed form: the air's push is the mean of both ends.</summary>
    /// <returns>False where the slide outlasts the step.</returns>
    private bool EndSlide(
        ref BallState s,
        ref StepRun run,
        ref SlidingSystem<TAir> system,
        in Motion from,
        in Vector3d slip,
        in Vector3d push,
        double friction,
        in MotionRates rates)
    {
        var torqueAxis = new Vector3d(system.SlipDirection.Z, 0, -system.SlipDirection.X);
        Vector3d air = rates.Acceleration + (_around.Ground.Sliding * system.SlipDirection);
        double turn = rates.SpinAcceleration.Y;
        var first = new SlipDecay(in slip, in push, friction);
        Vector3d velocity = from.Velocity + (first.Time * air) - (_around.Ground.Sliding * first.Direction);
        Vector3d spin = Slip.RollingSpin(in velocity, from.Spin.Y + (first.Time * turn), _ball.Radius);
        MotionRates end = system.Pushed(s.Time + first.Time, new Motion(from.Position, in velocity, in spin), in torqueAxis);
        run.Log.Evaluations++;
        Vector3d endPush = Slip.Of(end.Acceleration, end.SpinAcceleration, _ball.Radius);
        var decay = new SlipDecay(in slip, 0.5 * (push + endPush), friction);
        double t = decay.Time;
        if (!(t > 0 && t <= run.Left))
        {
            return false;
        }

        // v = v₀ − μ_s N/m ∫ŝ + ∫a,  p = p₀ + v₀ t − μ_s N/m ∫∫ŝ + ∫∫a, a linear in time
        velocity = from.Velocity + ((0.5 * t) * (air + end.Acceleration)) - (_around.Ground.Sliding * decay.Direction);
        spin = Slip.RollingSpin(in velocity, from.Spin.Y + (0.5 * t * (turn + end.SpinAcceleration.Y)), _ball.Radius);
        Vector3d position = from.Position + (t * from.Velocity) + ((t * t / 6.0) * ((2.0 * air) + end.Acceleration)) - (_around.Ground.Sliding * decay.Twice);
        PieceObserver? observer = run.Log.Observer;
        BallState before = observer is null ? default : s;
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * t) * (from.Spin + spin));
        s.Position = new Vector3d(position.X, _contact, position.Z);
        s.Velocity = velocity.Horizontal;
        s.SpinAxis = spin;
        s.Time = Math.Min(s.Time + t, run.End);
        run.Left -= t;
        run.Log.Steps++;
        if (observer is not null)
        {
            Watch(observer, run.Log, in before, rates.Acceleration, in s, Extrapolate.Rate(in from.Velocity, s.Velocity, in rates.Acceleration, t));
        }

        if (!run.Log.Halted)
        {
            StartRolling(ref s, ref run);
        }

        return true;
    }

    private void Roll(ref BallState s, ref StepRun run)
    {
        if (LeavesGround(ref s, ref run))
        {
            return;
        }

        double energy = KineticEnergy(s.Velocity, s.Spin);
        if (energy < _ground.RestEnergy)
        {
            Rest(ref s, ref run);
            return;
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin);
        double speed = from.Velocity.Length;
        RollingSystem<TAir> system = _rolling;
        system.Branch = GroundBranch(ref s, in from);
        double next = run.Next;
        double airRate = GroundRateAtMost(in from, out double airSpeed);
        double h = next * airRate <= LargestChange ? next : DividedOnGround(next, in from, s.Branch);
        if (h <= 0)
        {
            RelaxOnGround(ref s, ref run);
            return;
        }

        run.Keep(h, next);
        if (speed < Slip.Rolling)
        {
            from = new Motion(s.Position, Vector3d.Zero, new Vector3d(0, from.Spin.Y, 0));
            Vector3d push = system.Pushed(s.Time, in from).Acceleration;
            run.Log.Evaluations++;
            double pushSize = push.Length;
            system.Pinned = pushSize <= _around.Ground.Rolling;
            system.Direction = pushSize > 0 ? push / pushSize : Vector3d.Zero;
        }
        else
        {
            system.Direction = from.Velocity / speed;
            double fastest = _around.Ground.Rolling + (airRate * airSpeed);
            if (_custom || fastest * h > Approach * speed)
            {
                system.Rates(s.Time, in from, out MotionRates rates);
                run.Log.Evaluations++;
                h = Shorten(h, run.Length, in system.Direction, speed, rates.Acceleration);
            }
        }

        var trial = new MotionTrial<RollingSystem<TAir>, TIntegrator>(in system, s.Time, in from, in _wind, _ball.Radius);
        trial.Step(h);
        CrossJumpOnGround(ref trial, ref s, h, ref run);
        bool rests = KineticEnergy(trial.Step1.End.Velocity, trial.Step1.End.Spin) < _ground.RestEnergy;
        if (rests)
        {
            LocateRest(ref trial, energy);
        }

        run.Log.Evaluations += trial.Evaluations;
        Vector3d spin = Slip.RollingSpin(trial.Step1.End.Velocity, trial.Step1.End.Spin.Y, _ball.Radius);
        MoveOnGround(ref s, ref trial, in spin, ref run);
        if (rests && !run.Log.Halted)
        {
            Rest(ref s, ref run);
        }
    }

    /// <summary>Ends a rolling step where its kinetic energy falls to the rest energy.</summary>
    private void LocateRest(ref MotionTrial<RollingSystem<TAir>, TIntegrator> trial, double energy)
    {
        double rest = _ground.RestEnergy;
        double low = 0;
        double high = trial.Length;

        // Speeds fall about linearly, energies with their square.
        double startRoot = Math.Sqrt(energy);
        double endRoot = Math.Sqrt(KineticEnergy(trial.Step1.End.Velocity, trial.Step1.End.Spin));
        double tau = high * (startRoot - Math.Sqrt(rest)) / (startRoot - endRoot);
        for (int i = 0; i < 40; i++)
        {
            tau = tau > low && tau < high ? tau : 0.5 * (low + high);
            trial.Step(tau);
            double excess = KineticEnergy(trial.Step1.End.Velocity, trial.Step1.End.Spin) - rest;
            MotionRates rates = trial.EndRates();

            // dE/dt = m v·v̇ + I ω·ω̇
            double power = (_ball.Mass * Vector3d.Dot(trial.Step1.End.Velocity, rates.Acceleration))
                + (_ball.MomentOfInertia * Vector3d.Dot(trial.Step1.End.Spin, rates.SpinAcceleration));
            double correction = -excess / power;
            if (power < 0 && Math.Abs(correction) <= 1e-12)
            {
                return;
            }

            if (excess > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            if (high - low <= 1e-15 * high)
            {
                return;
            }

            tau = power < 0 ? tau + correction : 0;
        }
    }

    private void Rest(ref BallState s, ref StepRun run)
    {
        run.Log.Events.Add(new BallEvent(BallEventKind.Rest, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Rest;
        s.Velocity = Vector3d.Zero;
        s.SetGroundSpin(Vector3d.Zero);
        s.Motion = MotionState.Stopped;
    }

    private void MoveOnGround<TSystem>(ref BallState s, ref MotionTrial<TSystem, TIntegrator> trial, in Vector3d spin, ref StepRun run)
        where TSystem : struct, IMotionSystem
    {
        PieceObserver? observer = run.Log.Observer;
        BallState before = observer is null ? default : s;
        ref readonly MotionStep step = ref trial.Step1;
        double h = trial.Length;
        double about = s.SpinAxis.Y;
        s.BaseOrientation = s.BaseOrientation.Turned(in step.Rotation);
        s.Position = new Vector3d(step.End.Position.X, _contact, step.End.Position.Z);
        s.Velocity = step.End.Velocity.Horizontal;

        // Damping and decay end the spin about the vertical, they never reverse it.
        bool reversed = about > 0 ? spin.Y < 0 : about < 0 && spin.Y > 0;
        s.SpinAxis = reversed && !_custom ? new Vector3d(spin.X, 0, spin.Z) : spin;
        s.Time = Math.Min(s.Time + h, run.End);
        run.Left -= h;
        run.Log.Steps++;
        if (observer is not null)
        {
            MotionRates endRates = default;
            if (observer.WantsEndAcceleration)
            {
                endRates = trial.EndRates();
                run.Log.Evaluations++;
            }

            Watch(observer, run.Log, in before, in step.StartRates.Acceleration, in s, in endRates.Acceleration);
        }
    }

    /// <summary>Splits a step on the ground at the drag law's jump, and takes the other branch from there.</summary>
    private void CrossJumpOnGround<TSystem>(ref MotionTrial<TSystem, TIntegrator> trial, ref BallState s, double h, ref StepRun run)
        where TSystem : struct, IMotionSystem
    {
        if (!(_air.Jumps && _locatesJump) || run.Splits >= StepRun.MaximumSplits)
        {
            return;
        }

        DragJump start = trial.StartJump;
        DragJump startRate = trial.StartJumpRate;
        DragJump end = trial.EndJump;
        if (!DragJump.MayCross(s.Branch, in start, in startRate, in end, h))
        {
            return;
        }

        run.Splits++;
        MotionTrial<TSystem, TIntegrator> whole = trial;
        if (start.Branch == s.Branch && JumpLocator.Locate(ref trial, s.Branch, in start, in startRate, h))
        {
            s.Branch = s.Branch == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
            return;
        }

        trial = whole;
        s.Branch = end.Branch;
    }

    private DragBranch GroundBranch(ref BallState s, in Motion from)
    {
        if (_air.Jumps && (s.Branch is DragBranch.Unknown or >= DragBranch.AlongCriticalSpeed || !_locatesJump))
        {
            s.Branch = _flight.JumpAt(in from).Branch;
        }

        return s.Branch;
    }

    /// <summary>A bound, 1/s, for how fast the air and the damping change the motion, without a root.</summary>
    /// <param name="from">The ball.</param>
    /// <param name="airSpeed">A bound of the speed relative to the air, m/s.</param>
    private double GroundRateAtMost(in Motion from, out double airSpeed)
    {
        airSpeed = SumOfSizes(from.Velocity - _wind);
        return (_bound.PerSpeed * airSpeed) + (_bound.PerSpin * SumOfSizes(in from.Spin)) + _bound.Constant + _around.Ground.SpinDamping;
    }

    private static double SumOfSizes(in Vector3d v) => Math.Abs(v.X) + Math.Abs(v.Y) + Math.Abs(v.Z);

    private double DividedOnGround(double left, in Motion from, DragBranch branch) =>
        Divided(left, (from.Velocity - _wind).Length, from.Spin.Length, branch, _around.Ground.SpinDamping);

    /// <summary>Shortens a piece in which a vector would lose, or turn by, more than a share of its size.</summary>
    private static double Shorten(double h, double step, in Vector3d direction, double size, in Vector3d rate)
    {
        double along = Vector3d.Dot(in rate, in direction);
        double acrossSquared = Math.Max(0, rate.LengthSquared - (along * along));
        double closing = Math.Sqrt(acrossSquared + (along < 0 ? along * along : 0));
        double share = step > 0.01 ? Math.Min(LargestApproach, Approach * Math.Sqrt(step * 100)) : Approach;
        return closing * h > share * size ? share * size / closing : h;
    }

    /// <summary>½ m v² + ½ I ω², J.</summary>
    private double KineticEnergy(in Vector3d v, in Vector3d w) =>
        (_halfMass * v.LengthSquared) + (_halfInertia * w.LengthSquared);
}
