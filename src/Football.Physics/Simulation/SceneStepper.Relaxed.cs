using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <content>Air that is far stronger than the ball's inertia: how a step is divided, and what happens where that would be too fine.</content>
internal sealed partial class Stepper<TFast, TSpun, TAir, TIntegrator>
{
    /// <summary>Below this many pieces the simple bound is good enough.</summary>
    private const double FewPieces = 16;

    /// <summary>|u|² above which there are drag and lift, m²/s².</summary>
    private const double StillAir = 1e-17;

    /// <summary>A step that would have to be divided into more pieces than this relaxes to the balance of forces instead.</summary>
    private const double MostPieces = 1024;

    /// <summary>More pieces than this without an impact, by whatever cause, and the rest of the step relaxes: every step ends.</summary>
    private const int MostInARow = 1 << 16;

    /// <summary>Pieces of a step that relaxes.</summary>
    private const int RelaxedPieces = 16;

    /// <summary>The longest of equal parts of a step for which no force overshoots, or 0 where they would be too many.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private double Divided(double left, double speed, double spin, DragBranch branch, double damping = 0)
    {
        double pieces = left * ((_bound.PerSpeed * speed) + (_bound.PerSpin * spin) + _bound.Constant + damping);
        if (pieces > FewPieces && branch < DragBranch.AlongCriticalSpeed)
        {
            // The bound adds what each law could do; twice what they do here is enough, and in still air what they are about to do.
            _air.Begin(spin, branch, out AirStep once);
            _air.Evaluate(in once, Math.Max(speed * speed, StillAir), spin, Math.Max(speed * speed, StillAir), out double drag, out double lift, out double decay);
            double ofSpin = spin > 0 ? Math.Min(decay / spin, (_bound.PerSpeed * speed) + (_bound.PerSpin * spin)) : 0;
            double here = 2.0 * (drag + Math.Abs(lift) + ofSpin);
            double closer = left * (here + _bound.Constant + damping);
            pieces = closer < pieces ? closer : pieces;
        }

        return pieces <= LargestChange ? left
            : pieces <= MostPieces && !(_spirals) ? left / Math.Ceiling(pieces / LargestChange)
            : 0;
    }

    /// <summary>
    /// Explicit Euler comes down from a hop faster by g h than it went up: with that a bounce of less than e g h/(1 − e) would grow. So a
    /// step is divided that is longer than (1 − e)/3e of a hop: then every bounce is lower than the one before, and the ball comes to rest.
    /// </summary>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="height">Height above contact, m.</param>
    /// <param name="climb">Vertical velocity, m/s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double WithinHop(double h, double height, double climb)
    {
        // A hop up to the height that the energy is enough for takes 2 √(2 g y + v²)/g.
        double up = (climb * climb) - (2.0 * _upward * Math.Max(0, height));
        double least = h * -_upward * _piecesOfHop;
        return least > 0 && least * least > 4.0 * up ? PartOfHop(h, least, up) : h;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private double PartOfHop(double h, double least, double up)
    {
        double hop = Math.Max(2.0 * Math.Sqrt(up), ShortestHop * -_upward);
        return least > hop ? h / Math.Ceiling(least / hop) : h;
    }

    /// <summary>A piece of a flight that relaxes.</summary>
    private void Relax(ref BallState s, ref StepRun run)
    {
        double h = run.Left / Math.Max(1, RelaxedPieces - run.Relaxed);
        run.Relaxed++;
        MotionRates custom = default;
        var from = new Motion(s.Position, s.Velocity, s.Spin);
        if (_custom)
        {
            custom = _around.Custom.Rates(s.Time, in from, s.Velocity - _wind, MotionState.Airborne);
            run.Log.Evaluations++;
        }

        var relaxation = new Relaxation<TAir> { Air = _air, RadiusSquared = _radiusSquared };
        Motion end = Relaxed(ref relaxation, in from, in custom, h);
        bool below = end.Position.Y < _contact;

        // A hop that begins and ends within the piece has no height: the air presses the ball down.
        bool pressed = below && s.Position.Y <= _contact;
        if (below && !pressed)
        {
            h = TimeOfContact(ref relaxation, in from, in custom, h, ref end);
        }

        BallState before = s;
        double y = below ? _contact : end.Position.Y;
        double vy = pressed ? 0 : below ? Math.Min(end.Velocity.Y, 0) : end.Velocity.Y;
        s.Position = new Vector3d(end.Position.X, y, end.Position.Z);
        s.Velocity = new Vector3d(end.Velocity.X, vy, end.Velocity.Z);
        s.Angle += 0.5 * h * (s.SpinRate + end.Spin.Length);
        s.SetFlightSpin(end.Spin);
        s.Branch = DragBranch.Unknown;
        s.Time = Math.Min(s.Time + h, run.End);
        run.Left -= h;
        run.Log.Steps++;
        run.Log.Relaxed++;
        run.Log.Evaluations += relaxation.Evaluations;
        WatchRelaxed(in before, in s, h, ref run);
        if (below && !run.Log.Halted && !(pressed && _upward > 0))
        {
            Impact(ref s, ref run);
        }
    }

    /// <summary>All that is left of a step relaxes.</summary>
    private void RelaxToEnd(ref BallState s, ref StepRun run)
    {
        run.Relaxed = RelaxedPieces;
        if (s.Motion == MotionState.Airborne)
        {
            Relax(ref s, ref run);
        }
        else
        {
            RelaxOnGround(ref s, ref run);
        }
    }

    /// <summary>Implicit Euler: velocity, then spin, then position with the new velocity.</summary>
    private Motion Relaxed(ref Relaxation<TAir> relaxation, in Motion from, in MotionRates custom, double h)
    {
        Vector3d spin = from.Spin + (h * custom.SpinAcceleration);
        double rate = spin.Length;
        Vector3d axis = rate > 0 ? spin / rate : Vector3d.Up;
        Vector3d push = custom.Acceleration + new Vector3d(0, _upward, 0);
        Vector3d u = relaxation.Velocity(from.Velocity - _wind, in push, in axis, rate, h);
        Vector3d velocity = u + _wind;
        return new Motion(from.Position + (h * velocity), in velocity, relaxation.Spin(rate, u.Length, h) * axis);
    }

    /// <summary>Shortens a relaxed piece to the instant of contact.</summary>
    private double TimeOfContact(ref Relaxation<TAir> relaxation, in Motion from, in MotionRates custom, double h, ref Motion end)
    {
        double low = 0;
        double high = h;
        for (int i = 0; i < 60 && end.Position.Y < _contact - 1e-12; i++)
        {
            double middle = 0.5 * (low + high);
            Motion at = Relaxed(ref relaxation, in from, in custom, middle);
            if (at.Position.Y < _contact)
            {
                high = middle;
                end = at;
            }
            else
            {
                low = middle;
            }
        }

        return high;
    }

    /// <summary>A piece on the ground that relaxes: friction and damping first, to their end at most, then the air.</summary>
    private void RelaxOnGround(ref BallState s, ref StepRun run)
    {
        double h = run.Left / Math.Max(1, RelaxedPieces - run.Relaxed);
        run.Relaxed++;
        bool slides = s.Motion == MotionState.Sliding;
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        GroundForces ground = _around.Ground;
        if (_custom)
        {
            MotionRates custom = _around.Custom.Rates(s.Time, new Motion(s.Position, in v, in w), v - _wind, s.Motion);
            v += h * custom.Acceleration.Horizontal;
            w += h * custom.SpinAcceleration;
        }

        bool slipEnds = false;
        if (slides)
        {
            // |s| falls by (1 + 1/α) μ_s N/m a second; its direction stays.
            Vector3d slip = Slip.Of(in v, in w, _ball.Radius);
            double size = slip.Length;
            double fall = ground.Sliding + (_ball.Radius * ground.SlidingTorque);
            double slowing = Math.Min(h, fall > 0 ? size / fall : h);
            slipEnds = !(size > fall * h);
            Vector3d direction = size > 0 ? slip / size : Vector3d.Zero;
            v -= slowing * ground.Sliding * direction;
            w += slowing * ground.SlidingTorque * new Vector3d(direction.Z, 0, -direction.X);
        }
        else
        {
            double speed = v.Length;
            v = speed > ground.Rolling * h ? v * (1.0 - (ground.Rolling * h / speed)) : Vector3d.Zero;
        }

        w = new Vector3d(w.X, w.Y / (1.0 + (h * ground.SpinDamping)), w.Z);
        var relaxation = new Relaxation<TAir> { Air = _air, RadiusSquared = _radiusSquared };
        double rate = w.Length;
        Vector3d axis = rate > 0 ? w / rate : Vector3d.Up;
        Vector3d u = v - _wind;
        if (_around.AirActsOnGround)
        {
            u = relaxation.Velocity(in u, Vector3d.Zero, in axis, rate, h);
        }

        w = relaxation.Spin(rate, u.Length, h) * axis;
        v = (u + _wind).Horizontal;
        BallState before = s;
        Vector3d turn = 0.5 * h * (s.Spin + w);
        s.BaseOrientation = (Quaterniond.FromRotationVector(in turn) * s.BaseOrientation).Normalised();
        s.Position = new Vector3d(s.Position.X + (h * v.X), _contact, s.Position.Z + (h * v.Z));
        s.Velocity = v;
        s.SpinAxis = slides ? w : Slip.RollingSpin(in v, w.Y, _ball.Radius);
        s.Branch = DragBranch.Unknown;
        s.Time = Math.Min(s.Time + h, run.End);
        run.Left -= h;
        run.Log.Steps++;
        run.Log.Relaxed++;
        run.Log.Evaluations += relaxation.Evaluations;
        WatchRelaxed(in before, in s, h, ref run);
        if (slipEnds && !run.Log.Halted)
        {
            StartRolling(ref s, ref run);
        }
    }

    /// <summary>Shows a relaxed piece as the straight line that it is.</summary>
    private void WatchRelaxed(in BallState before, in BallState after, double h, ref StepRun run)
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
