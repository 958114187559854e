namespace Football.Physics;

/// <summary>
/// Pieces by implicit Euler, for air that is far stronger than the ball's inertia: stable at any length, they end in the balance of forces
/// that the motion relaxes to. A step that explicit methods would have to divide too often is taken in a few of these.
/// </summary>
internal sealed class ImplicitPhase
{
    /// <summary>Pieces of a step that is taken by implicit Euler.</summary>
    private const int MostPieces = 16;

    /// <summary>Pieces tried at most to find the instant of a contact; every third halves.</summary>
    private const int MostTries = 120;

    private readonly Surroundings _around;
    private readonly WorldGuard _guard;

    public ImplicitPhase(Surroundings around, WorldGuard guard)
    {
        _around = around;
        _guard = guard;
    }

    /// <summary>All that is left of a step, in one piece.</summary>
    public void TakeRest(ref BallState s, ref StepRun run)
    {
        run.Implicit = MostPieces;
        if (s.Motion == MotionState.Airborne)
        {
            Fly(ref s, ref run);
        }
        else
        {
            Slow(ref s, ref run);
        }
    }

    /// <summary>A piece of flight: along its straight line, up to the first thing that is met.</summary>
    public void Fly(ref BallState s, ref StepRun run)
    {
        double h = run.Left / Math.Max(1, MostPieces - run.Implicit);
        run.Implicit++;
        var from = new Motion(s.Position, s.Velocity, s.Spin);
        MotionRates push = Push(in s, in from.Velocity, in from.Spin, ref run, out Vector3d wind);
        var step = new ImplicitStep(_around, in from, in push, in wind);
        Motion end = step.To(h);
        double at = FirstMet(in s, in step.From, in end, h, out Gap met);
        bool meets = at <= h;

        // The velocity at a contact is that of a piece that ends there; where no piece does, the longest that meets nothing is taken, while a step has pieces left.
        double none = 0;
        Motion free = step.From;
        for (int i = 0; i < MostTries && meets && at < h * (1.0 - 1e-9); i++)
        {
            // Velocities change little with the length of a piece: most often the next one ends all but where this one meets something.
            double middle = i % 3 == 2 || !(at > none) ? 0.5 * (none + h) : at + (1e-3 * (h - at));
            Motion shorter = step.To(middle);
            double sooner = FirstMet(in s, in step.From, in shorter, middle, out Gap found);
            if (sooner <= middle)
            {
                h = middle;
                at = sooner;
                end = shorter;
                met = found;
            }
            else
            {
                none = middle;
                free = shorter;
            }
        }

        if (none > 0 && at < 0.5 * h && !run.IsSpent)
        {
            meets = false;
            end = free;
            h = none;
        }

        end = step.Spun(in end, h);
        h = !meets ? h : met.What == Happening.Contact ? Closer(in s, in end, in met, at) : at;
        BallState before = s;
        s.Position = step.From.Position + (h * end.Velocity);
        s.Velocity = end.Velocity;
        s.Angle += 0.5 * h * (s.SpinRate + end.Spin.Length);
        s.SetFlightSpin(end.Spin);
        s.AirDistance += h * step.AirSpeed;
        s.Branch = DragBranch.Unknown;
        run.Advance(ref s, h);
        run.Log.Relaxed++;
        run.Log.Evaluations += step.Evaluations;
        Show(in before, in s, h, ref run);
        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>A contact that the walk along a piece has passed by its shortest step, to where the straight line has it, s.</summary>
    private double Closer(in BallState s, in Motion end, in Gap met, double at)
    {
        Vector3d there = s.Position + (at * end.Velocity);
        met.Evaluate(in there, end.Velocity, s.Time + at, out double gap, out double rate);
        return gap < -ContactSearch.Touching && rate < 0 ? Math.Max(0, at - (gap / rate)) : at;
    }

    /// <summary>When the ball meets something on the straight line of a piece, s; infinite where it does not.</summary>
    private double FirstMet(in BallState s, in Motion from, in Motion end, double h, out Gap met)
    {
        var path = PathCubic.Line(from.Position, end.Velocity, h);
        return new ContactSearch(_around.World, in path, s.Time).First(in s, -1, out met);
    }

    /// <summary>A piece of a slide or a roll: friction first, to the end of the slip or the roll at most, then the air; along its straight line, up to the first thing that is met.</summary>
    public void Slow(ref BallState s, ref StepRun run)
    {
        World world = _around.World;
        double h = run.Left / Math.Max(1, MostPieces - run.Implicit);
        run.Implicit++;
        Collider carrier = world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        ref readonly ContactMaterial material = ref carrier.MaterialAt(s.Position);
        double load = Math.Max(0, -_around.Upward * n.Y);
        bool slides = s.Motion == MotionState.Sliding;
        MotionRates push = Push(in s, s.Velocity, s.Spin, ref run, out Vector3d wind);
        Vector3d v = s.Velocity - carrier.Velocity;
        Vector3d w = s.Spin + (h * push.SpinAcceleration);

        bool slipEnds = false;
        if (slides)
        {
            // |s| falls by (1 + 1/α) μ_s N/m a second; its direction stays.
            double alpha = world.Ball.InertiaFactor;
            double friction = material.SlidingFriction * load;
            Vector3d slip = Slip.Of(in v, in w, in n, _around.Radius);
            double size = slip.Length;
            double fall = (1.0 + (1.0 / alpha)) * friction;
            double slowing = Math.Min(h, fall > 0 ? size / fall : h);
            slipEnds = !(size > fall * h);
            Vector3d direction = size > 0 ? slip / size : Vector3d.Zero;
            v -= slowing * friction * direction;
            w += slowing * friction / (alpha * _around.Radius) * Vector3d.Cross(in n, in direction);
        }
        else
        {
            double speed = v.Length;
            double friction = h * material.RollingFriction * load;
            v = speed > friction ? v * (1.0 - (friction / speed)) : Vector3d.Zero;
        }

        double about = Vector3d.Dot(in w, in n);
        w -= (about - (about / (1.0 + (h * material.SpinDamping / world.Ball.MomentOfInertia)))) * n;
        var euler = new ImplicitEuler { Air = _around.Air, RadiusSquared = _around.RadiusSquared };
        double rate = w.Length;
        Vector3d axis = rate > 0 ? w / rate : Vector3d.Up;
        Vector3d pushed = push.Acceleration + (_around.Upward * (Vector3d.Up - (n.Y * n)));
        Vector3d u = v + carrier.Velocity - wind;
        u = _around.AirActsOnGround ? euler.Velocity(in u, in pushed, in axis, rate, h) : u + (h * pushed);
        w = euler.Spin(rate, u.Length, h) * axis;
        Vector3d relative = SurfaceSystem.Tangential(u + wind - carrier.Velocity, in n);
        Vector3d velocity = relative + carrier.Velocity;
        var path = PathCubic.Line(s.Position, in velocity, h);
        double at = new ContactSearch(world, in path, s.Time).First(in s, (int)s.Carrier - world.FirstCollider, out Gap met);
        bool meets = at <= h;
        h = meets ? at : h;
        BallState before = s;
        Vector3d turn = 0.5 * h * (s.Spin + w);
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = path.At(h);
        s.Velocity = velocity;
        s.SpinAxis = slides && !slipEnds ? w : Slip.RollingSpin(in relative, Vector3d.Dot(in w, in n), in n, _around.Radius);
        s.Branch = DragBranch.Unknown;
        run.Advance(ref s, h);
        world.Hold(ref s, carrier);
        run.Log.Relaxed++;
        run.Log.Evaluations += euler.Evaluations;
        Show(in before, in s, h, ref run);
        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
        else if (slipEnds && !run.Log.Halted)
        {
            _guard.EndSlip(ref s, ref run);
        }
    }

    /// <summary>What air that varies does beside drag, lift and spin decay, at the start of a piece, and the wind there.</summary>
    private MotionRates Push(in BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run, out Vector3d wind)
    {
        wind = _around.Wind;
        if (!_around.Air.Varies)
        {
            return default;
        }

        run.Log.Evaluations++;
        var ball = new ForceInput(s.Time, s.Position, in velocity, velocity - wind, in spin, s.Motion, s.AirDistance);
        _around.Air.Evaluate(in ball, s.Branch, out AirFactors air);
        wind = velocity - air.AirVelocity;
        return new MotionRates(in air.Acceleration, in air.SpinAcceleration, air.AirSpeed);
    }

    /// <summary>Shows a piece as the straight line that it is.</summary>
    private static void Show(in BallState before, in BallState after, double h, ref StepRun run)
    {
        if (run.Log.Observer is { } observer && h > 0)
        {
            Vector3d mean = (after.Position - before.Position) / h;
            var piece = new PathPiece(
                before.Time, h, before.Position, in mean, Vector3d.Zero, after.Position, in mean, Vector3d.Zero, before.Motion, 2);
            run.Log.Halted |= observer.Add(in piece);
        }
    }
}
