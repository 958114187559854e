using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>One compiled body: the laws of a scene and an integrator.</summary>
/// <typeparam name="TFast">The laws of a plain step of flight, where they hold.</typeparam>
/// <typeparam name="TSpun">The laws of a step with a spin too fast for those, where they hold.</typeparam>
/// <typeparam name="TAir">The laws everywhere.</typeparam>
/// <typeparam name="TIntegrator">The integrator.</typeparam>
internal sealed partial class Stepper<TFast, TSpun, TAir, TIntegrator> : Stepper
    where TFast : struct, IAerodynamics
    where TSpun : struct, IAerodynamics
    where TAir : struct, IAerodynamics
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A step is divided so that no force changes the motion by more than this share of itself, explicit Euler's limit of no overshoot.</summary>
    private const double LargestChange = 1.0;

    /// <summary>Up to this restitution every ball comes to rest, whatever the method and its step.</summary>
    private const double MostElastic = 0.95;

    /// <summary>A ball that would be back on the ground sooner than this, s, stays down: so an impact takes time, however strong gravity is.</summary>
    private const double ShortestHop = 1e-6;

    private readonly BallProperties _ball;
    private readonly Ground _ground;
    private readonly SolverSettings _settings;
    private readonly Vector3d _wind;
    private readonly double _upward;
    private readonly double _contact;
    private readonly double _radiusSquared;
    private readonly double _halfMass;
    private readonly double _halfInertia;
    private readonly RateBound _bound;

    /// <summary>Up to this length, s, no step that the fused laws cover must be divided.</summary>
    private readonly double _wholeUpTo;
    private readonly bool _custom;
    private readonly bool _locatesJump;

    /// <summary>Into how many pieces explicit Euler divides a hop at least, 3e/(1 − e).</summary>
    private readonly double _piecesOfHop;

    /// <summary>Whether nothing but the Magnus force acts on a velocity that the method cannot turn without making it longer.</summary>
    private readonly bool _spirals;
    private TFast _fast;
    private TSpun _spun;
    private TAir _air;
    private TIntegrator _integrator;
    private readonly Surroundings<TAir> _around;
    private readonly FlightSystem<TAir> _flight;
    private readonly SlidingSystem<TAir> _sliding;
    private readonly RollingSystem<TAir> _rolling;

    public Stepper(Scene scene, SolverSettings settings)
    {
        _ball = scene.Ball;
        _ground = scene.Ground;
        _settings = settings;
        _wind = scene.Air.Wind;
        _upward = Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
        _contact = scene.Ground.Height + scene.Ball.Radius;
        _radiusSquared = scene.Ball.Radius * scene.Ball.Radius;
        _halfMass = 0.5 * scene.Ball.Mass;
        _halfInertia = 0.5 * scene.Ball.MomentOfInertia;
        _air = default;
        _air.Prepare(scene);
        _fast = default;
        _fast.Prepare(scene);
        _spun = default;
        _spun.Prepare(scene);
        _integrator = default;
        RateBound bound = _air.Bound;

        // A ball that falls from rest is soon as fast as drag lets it: 1/√(P a) is how soon.
        _bound = new RateBound(bound.PerSpeed, bound.PerSpin, bound.Constant + (Math.Sqrt(bound.PerSpeed) * Math.Sqrt(Math.Abs(_upward))));
        _wholeUpTo = _fast.WholeUpTo(in _bound);
        double restitution = Math.Min(_ground.NormalRestitution, MostElastic);
        _piecesOfHop = 3.0 * restitution / (1.0 - restitution);
        _spirals = _integrator.Order < 4 && _air.Lifts && !(_air.Drags && bound.PerSpeed > 0);
        _locatesJump = _air.Jumps && settings.LocateJump && _integrator.Order > 1;

        _around = new Surroundings<TAir>(scene, in _air);
        _custom = _around.Custom.Act;
        _flight = new FlightSystem<TAir> { Around = _around };
        _sliding = new SlidingSystem<TAir> { Around = _around };
        _rolling = new RollingSystem<TAir> { Around = _around };
    }

    [MethodImpl(Hot.Path)]
    public override void Step(ref BallState state, double dt, StepLog log)
    {
        double end = state.Time + dt;
        if (state.Motion == MotionState.Airborne && !_custom && state.Branch < DragBranch.AlongCriticalSpeed)
        {
            // Nearly every step is a flight without an event.
            if (FlyWhole(ref state, dt, log, true, out FlightStep step, out double h))
            {
                return;
            }

            if (h > 0)
            {
                FlyOn(ref state, end, dt, ref step, h, log);
                return;
            }
        }

        Finish(ref state, end, dt, log);
    }

    /// <summary>A whole step, piece by piece.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Finish(ref BallState state, double end, double dt, StepLog log)
    {
        var run = new StepRun { Left = dt, Length = dt, End = end, Log = log };
        Finish(ref state, ref run);
    }

    /// <summary>A step that begins with a piece of flight with something in it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void FlyOn(ref BallState state, double end, double dt, ref FlightStep step, double h, StepLog log)
    {
        // dt itself: end − time differs from it by rounding, which would leave a sliver of a step.
        var run = new StepRun { Left = dt, Length = dt, End = end, Log = log };
        run.Keep(h, dt);
        FlyEventful(ref state, ref run, ref step, h);
        if (!log.Halted)
        {
            Finish(ref state, ref run);
        }
    }

    /// <summary>The rest of a step, piece by piece.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Finish(ref BallState state, ref StepRun run)
    {
        while (run.Left > 0 && state.Motion != MotionState.Stopped)
        {
            if (++run.Pieces > MostInARow)
            {
                RelaxToEnd(ref state, ref run);
                continue;
            }

            switch (state.Motion)
            {
                case MotionState.Airborne:
                    if (_custom || state.Branch >= DragBranch.AlongCriticalSpeed)
                    {
                        FlyFreely(ref state, ref run);
                    }
                    else
                    {
                        Fly(ref state, ref run);
                    }

                    break;
                case MotionState.Sliding:
                    Slide(ref state, ref run);
                    break;
                default:
                    Roll(ref state, ref run);
                    break;
            }

            if (run.Log.Halted)
            {
                return;
            }
        }

        state.Time = run.End;
    }

    public override void AirFactors(double speed, double spinRate, out double drag, out double lift)
    {
        double speedSquared = speed * speed;
        DragBranch branch = DragJump.At(speedSquared, _radiusSquared * spinRate * spinRate).Branch;
        _air.Begin(spinRate, branch, out AirStep step);
        _air.Evaluate(in step, speedSquared, spinRate, speedSquared, out drag, out lift, out _);
    }

    /// <summary>Shows a piece to an observer; the acceleration at its end is used only if the observer wants it.</summary>
    private void Watch(
        PieceObserver observer, StepLog log, in BallState from, in Vector3d startAcceleration, in BallState to, in Vector3d endAcceleration)
    {
        int degree = _integrator.Order <= 2 ? 2 : observer.WantsEndAcceleration ? 5 : 3;
        var piece = new PathPiece(
            from.Time, to.Time - from.Time, from.Position, from.Velocity, in startAcceleration, to.Position, to.Velocity, in endAcceleration, from.Motion, degree);
        log.Halted |= observer.Add(in piece);
    }

    /// <summary>An impact where the ball is, and what becomes of the ball.</summary>
    private void Impact(ref BallState s, ref StepRun run)
    {
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        ImpactResponse.Apply(_ball, _ground, in v, in w, out Vector3d velocity, out Vector3d spin);
        run.Log.Events.Add(new BallEvent(BallEventKind.Impact, s.Time, s.Position, in v, in w, in velocity, in spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Impact;
        s.Branch = DragBranch.Unknown;
        run.Part = 0;
        run.Pieces = 0;
        if (velocity.Y >= _ground.MinimumBounceSpeed ? velocity.Y >= 0.5 * ShortestHop * -_upward : _upward > 0 && !IsPressedDown(in s, velocity.Horizontal, in spin, ref run))
        {
            s.Velocity = velocity;
            s.SetFlightSpin(in spin);
            return;
        }

        s.Velocity = velocity.Horizontal;
        s.SetGroundSpin(in spin);
        if (Slip.Of(s.Velocity, in spin, _ball.Radius).Length < Slip.Rolling)
        {
            StartRolling(ref s, ref run);
        }
        else
        {
            s.Motion = MotionState.Sliding;
            run.Log.Events.Add(new BallEvent(BallEventKind.Slide, s.Time, s.Position, s.Velocity, in spin, s.Velocity, in spin));
        }
    }

    /// <summary>The slip is over: the spin becomes that of pure rolling.</summary>
    private void StartRolling(ref BallState s, ref StepRun run)
    {
        Vector3d before = s.Spin;
        Vector3d spin = Slip.RollingSpin(s.Velocity, before.Y, _ball.Radius);
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Rolling;
        run.Log.Events.Add(new BallEvent(BallEventKind.Roll, s.Time, s.Position, s.Velocity, in before, s.Velocity, in spin));
    }

    /// <summary>A ball that is lighter than the air leaves the ground, unless the wind presses it down.</summary>
    /// <returns>True when it left.</returns>
    private bool LeavesGround(ref BallState s, ref StepRun run)
    {
        if (_upward <= 0 || IsPressedDown(in s, s.Velocity, s.Spin, ref run))
        {
            return false;
        }

        s.SetFlightSpin(s.Spin);
        s.Motion = MotionState.Airborne;
        s.Branch = DragBranch.Unknown;
        return true;
    }

    /// <summary>Whether the vertical force on a ball that is lighter than the air, at contact and without vertical velocity, points down.</summary>
    private bool IsPressedDown(in BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        var at = new Motion(s.Position, in velocity, in spin);
        FlightSystem<TAir> system = _flight;
        run.Log.Evaluations++;
        return system.On(system.JumpAt(in at).Branch, s.Time, in at).Acceleration.Y <= 0;
    }
}
