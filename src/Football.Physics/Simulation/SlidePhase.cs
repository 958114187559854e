using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Sliding on the ground, piece by piece: up to the drag law's jump, or to the end of the slip.</summary>
internal sealed class SlidePhase<TAir, TIntegrator>
    where TAir : struct, IAir
    where TIntegrator : struct, IIntegrator
{
    /// <summary>The last of a slide, this share of a step long, is done in closed form with the mean push of the air.</summary>
    private const double ClosedForm = 0.04;

    /// <summary>ε of the heuristic, m/s.</summary>
    private const double HeuristicSlip = 1e-3;

    private readonly Surroundings<TAir> _around;
    private readonly GroundLimit<TAir> _limit;
    private readonly DragJumpGuard<TAir> _jump;
    private readonly ContactPhase<TAir> _contact;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly SlidingSystem<TAir> _system;
    private readonly TIntegrator _integrator;
    private readonly double _friction;
    private readonly bool _exact;

    public SlidePhase(
        SolverSettings settings,
        Surroundings<TAir> around,
        in GroundLimit<TAir> limit,
        DragJumpGuard<TAir> jump,
        ContactPhase<TAir> contact,
        ImplicitPhase<TAir> implicitPhase)
    {
        _around = around;
        _limit = limit;
        _jump = jump;
        _contact = contact;
        _implicit = implicitPhase;
        _system = new SlidingSystem<TAir> { Around = around };
        _integrator = default;
        _friction = around.Ground.Sliding + (around.Ground.Radius * around.Ground.SlidingTorque);
        _exact = settings.RollingTransition == RollingTransition.Exact;
    }

    /// <summary>
    /// A whole step of sliding, done if nothing happens in it. It is the piece that <see cref="Take"/> would take, in one body, so that the
    /// motion stays in registers.
    /// </summary>
    /// <returns>False where something may happen; then nothing is done.</returns>
    [MethodImpl(Hot.Path)]
    public bool TryWhole(ref BallState s, double dt, StepLog log)
    {
        // Propose: the whole step, if the slip does not turn too fast in it, and the air is not too strong.
        ref readonly GroundForces ground = ref _around.Ground;
        var from = new PlanarMotion(in s);
        double slipX = from.VX + (ground.Radius * from.WZ);
        double slipZ = from.VZ - (ground.Radius * from.WX);
        double size = Math.Sqrt((slipX * slipX) + (slipZ * slipZ));
        DragBranch branch = _jump.OnGround(s.Branch, in from);
        double airRate = _limit.RateAtMost(in from, out double airSpeed);
        double fastest = _friction + (airRate * (airSpeed + (ground.Radius * GroundLimit<TAir>.SpinAtMost(in from))));
        if (!_exact || !(dt * airRate <= StabilityLimit.LargestChange) || !(size >= Slip.Rolling)
            || (fastest * dt > GroundLimit<TAir>.Approach * size && ground.Sliding > 0))
        {
            return false;
        }

        // Take it.
        SlidingSystem<TAir> system = default;
        system.Around = _around;
        system.Branch = branch;
        system.SlipX = slipX / size;
        system.SlipZ = slipZ / size;
        system.StartSpin = from.Spin;
        TIntegrator integrator = default;
        integrator.Advance(ref system, s.Time, in from, dt, out PlanarStep taken);

        // Guard: the drag law's jump. The end of the slip is far.
        if (_jump.MayCrossOnGround(branch, in from, in taken, dt))
        {
            return false;
        }

        // Nothing happened: move the ball.
        log.Evaluations += integrator.Stages;
        log.Steps++;
        s.Branch = branch;
        if (log.Observer is null)
        {
            system.Move(ref s, in taken);
            s.Time += dt;
        }
        else
        {
            log.MoveAndShow(ref s, ref system, in taken, dt, integrator.Order);
        }

        return true;
    }

    /// <summary>The next piece of a slide.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (_contact.LeavesGround(ref s, ref run))
        {
            return;
        }

        var from = new PlanarMotion(in s);
        Vector3d slip = Slip.Of(from.Velocity, from.Spin, _around.Radius);
        double size = slip.Length;
        if (size < Slip.Rolling)
        {
            _contact.StartRolling(ref s, ref run);
            return;
        }

        s.Branch = _jump.OnGround(s.Branch, in from);
        SlidingSystem<TAir> system = _system;
        Vector3d direction = slip / size;
        system.SlipX = direction.X;
        system.SlipZ = direction.Z;
        system.StartSpin = from.Spin;
        system.Branch = s.Branch;
        double asked = run.Next;
        double airRate = _limit.RateAtMost(in from, out double airSpeed);
        double h = _limit.PartOf(asked, airRate, in from, s.Branch);
        if (h <= 0)
        {
            _implicit.Slow(ref s, ref run);
            return;
        }

        run.Keep(h, asked);
        ref readonly GroundForces ground = ref _around.Ground;
        double friction = _friction;
        double fastest = friction + (airRate * (airSpeed + (ground.Radius * GroundLimit<TAir>.SpinAtMost(in from))));
        if (_exact && ground.Sliding > 0 && (_around.Air.Varies || fastest * h > GroundLimit<TAir>.Approach * size))
        {
            system.Rates(s.Time, in from, out PlanarRates rates);
            run.Log.Evaluations++;

            // ṡ = v̇ + r ŷ × ω̇
            Vector3d slipRate = Slip.Of(rates.Acceleration, rates.SpinAcceleration, ground.Radius);
            Vector3d push = slipRate + (friction * direction);
            if (size < 0.5 * friction * ClosedForm * run.Length && IsWeak(in push, friction)
                && EndSlip(ref s, ref run, ref system, in from, in slip, in direction, in push, friction, in rates, h))
            {
                return;
            }

            h = GroundLimit<TAir>.Shorten(h, run.Length, in direction, size, in slipRate);
        }

        var sweep = new PlanarSweep<SlidingSystem<TAir>, TIntegrator>(in system, s.Time, in from, _around.ContactHeight, in _around.Wind, _around.Radius);
        sweep.Step(h);
        _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        run.Log.Evaluations += sweep.Evaluations;
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        run.Show(in before, in s, ref sweep, _integrator.Order);
        if (!_exact && !run.Log.Halted)
        {
            // (2.27), (2.28): the slip grew, or is small.
            double after = Slip.Of(s.Velocity, s.Spin, _around.Radius).Length;
            if (after > size || after < HeuristicSlip)
            {
                _contact.StartRolling(ref s, ref run);
            }
        }
    }

    /// <summary>Whether a push of the air is too weak by far to keep a ball sliding.</summary>
    private static bool IsWeak(in Vector3d push, double friction) => push.LengthSquared < 0.25 * friction * friction;

    /// <summary>The end of a slide in closed form: the air's push is the mean of both ends.</summary>
    /// <returns>False where the slide outlasts the piece, or the air's push grows too strong on the way.</returns>
    private bool EndSlip(
        ref BallState s,
        ref StepRun run,
        ref SlidingSystem<TAir> system,
        in PlanarMotion from,
        in Vector3d slip,
        in Vector3d direction,
        in Vector3d push,
        double friction,
        in PlanarRates rates,
        double longest)
    {
        ref readonly GroundForces ground = ref _around.Ground;
        Vector3d air = rates.Acceleration + (ground.Sliding * direction);
        double turn = rates.BY;
        var first = new SlipDecay(in slip, in push, friction);
        Vector3d velocity = from.Velocity + (first.Time * air) - (ground.Sliding * first.Direction);
        Vector3d spin = Slip.RollingSpin(in velocity, from.WY + (first.Time * turn), ground.Radius);
        PlanarMotion there = from;
        there.VX = velocity.X;
        there.VZ = velocity.Z;
        there.WX = spin.X;
        there.WY = spin.Y;
        there.WZ = spin.Z;
        system.Pushed(s.Time + first.Time, in there, direction.Z, -direction.X, out PlanarRates end);
        run.Log.Evaluations++;
        Vector3d endPush = Slip.Of(end.Acceleration, end.SpinAcceleration, ground.Radius);
        Vector3d meanPush = 0.5 * (push + endPush);
        var decay = new SlipDecay(in slip, in meanPush, friction);
        double t = decay.Time;
        if (!(t > 0 && t <= longest && IsWeak(in meanPush, friction)))
        {
            return false;
        }

        // v = v₀ − μ_s N/m ∫ŝ + ∫a,  p = p₀ + v₀ t − μ_s N/m ∫∫ŝ + ∫∫a, a linear in time
        velocity = from.Velocity + ((0.5 * t) * (air + end.Acceleration)) - (ground.Sliding * decay.Direction);
        spin = Slip.RollingSpin(in velocity, from.WY + (0.5 * t * (turn + end.BY)), ground.Radius);
        Vector3d position = s.Position + (t * from.Velocity) + ((t * t / 6.0) * ((2.0 * air) + end.Acceleration)) - (ground.Sliding * decay.Twice);
        BallState before = s;
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * t) * (from.Spin + spin));
        s.Position = new Vector3d(position.X, _around.ContactHeight, position.Z);
        s.Velocity = velocity.Horizontal;
        s.SpinAxis = spin;
        run.Advance(ref s, t);
        if (run.Log.Observer is not null)
        {
            Vector3d endAcceleration = Extrapolate.Rate(from.Velocity, s.Velocity, rates.Acceleration, t);
            run.Log.Show(in before, in s, rates.Acceleration, in endAcceleration, _integrator.Order);
        }

        if (!run.Log.Halted)
        {
            _contact.StartRolling(ref s, ref run);
        }

        return true;
    }
}
