namespace FootballPhysics;

/// <summary>
/// What ends a piece of a slide or a roll: the load or the grip ends, a rolling ball comes to rest, or the spin about the normal reaches zero under
/// drilling friction. Each is a number along the piece that is positive until then.
/// </summary>
internal struct SurfaceMargin<TIntegrator> : IFunction
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A limit that is still this share of what it was where it ends has jumped, as the load does at an edge: the piece ends so much beyond.</summary>
    private const double Jump = 1e-3;

    /// <summary>That share of the piece; a jump is known well enough to the second.</summary>
    private const double Beyond = 1e-7;
    private const double JumpWidth = 1e-8;

    public MotionSweep<SurfaceSystem, TIntegrator> Sweep;
    private readonly SurfaceLimit _what;
    private readonly double _time;
    private readonly double _length;

    // Where it was positive last, and where not first; more than the third so close to the change of sign is a jump.
    private double _last;
    private double _first;
    private double _jump;

    public SurfaceMargin(SurfaceLimit what, in MotionSweep<SurfaceSystem, TIntegrator> sweep, double time)
    {
        _what = what;
        _time = time;
        _length = sweep.Length;
        _first = sweep.Length;
        _last = 0;
        _jump = 0;
        Sweep = sweep;
    }

    public bool Evaluate(double x, out double value)
    {
        Sweep.Step(x);
        value = Of(in Sweep.Taken.End, x);

        // How narrow the bracket of the sign change is: in a narrow one a value that stays large has jumped.
        _last = value > 0 ? x : _last;
        _first = value > 0 ? _first : x;
        return Math.Abs(value) > _jump && _first - _last < JumpWidth * _length;
    }

    public double Of(in Motion at, double after)
    {
        SurfaceForces on = default;
        if (_what != SurfaceLimit.Spin)
        {
            on = Sweep.System.ForcesOn(_time + after, in at);
            Sweep.Evaluations++;
        }

        return Of(in on, in at, after);
    }

    /// <summary>The number where the forces are known; those of the spin are not asked for.</summary>
    private double Of(in SurfaceForces on, in Motion at, double after)
    {
        ref SurfaceSystem system = ref Sweep.System;
        switch (_what)
        {
            case SurfaceLimit.Spin:
                // Without drilling friction nothing happens at zero.
                return system.Material.DrillingLength > 0 && system.SpinSign != 0
                    ? system.SpinSign * system.AboutCarrier(in at.Spin, system.NormalAt(in at.Position, _time + after))
                    : 0;
            case SurfaceLimit.Load:
                return on.FreeLoad;
            case SurfaceLimit.Grip:
                return system.SlidingFriction(in on) - system.Traction(in on).Length;
            default:
                bool held = system.Rests(in on);

                // The root of the energy falls all but linearly.
                return held ? Math.Sqrt(system.World.Energy(in at, system.Carrier, _time + after)) - Math.Sqrt(system.World.RestEnergy) : 1;
        }
    }

    /// <summary>
    /// Ends a piece where the load or the grip ends, where a rolling ball comes to rest, or where the spin about the normal reaches zero under drilling
    /// friction: each is a number that is positive until then.
    /// </summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="rolls">Whether it rolls.</param>
    /// <param name="keepsGrip">Whether it does so whatever the grip.</param>
    /// <returns>Whether it ends beyond a jump of one of them, as at an edge.</returns>
    public static bool EndPiece(ref MotionSweep<SurfaceSystem, TIntegrator> sweep, in BallState s, bool rolls, bool keepsGrip)
    {
        // The same length beyond the edge for all: one of them after the other would come back before it.
        double beyond = Beyond * sweep.Length;
        bool jumps = false;

        // One evaluation at the end for all margins; searched for is only one that is negative there.
        SurfaceForces atEnd = sweep.System.ForcesOn(s.Time + sweep.Length, in sweep.Taken.End);
        sweep.Evaluations++;
        for (var what = SurfaceLimit.Load; what <= SurfaceLimit.Spin; what++)
        {
            if ((!rolls && what is SurfaceLimit.Grip or SurfaceLimit.Rest) || (keepsGrip && what == SurfaceLimit.Grip))
            {
                continue;
            }

            var margin = new SurfaceMargin<TIntegrator>(what, in sweep, s.Time);
            double end = margin.Of(in atEnd, in sweep.Taken.End, sweep.Length);
            if (end >= 0)
            {
                continue;
            }

            double start = margin.Of(new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance), 0);
            if (start > 0)
            {
                // The first zero by the Illinois method, on the step itself; what is not small there has jumped, as at an edge.
                margin._jump = Jump * start;
                double x = Roots.Illinois(ref margin, 0, start, sweep.Length, end, 1e-13 * sweep.Length, 60);
                jumps = Math.Abs(margin.Of(in margin.Sweep.Taken.End, x)) > margin._jump;
                if (jumps)
                {
                    margin.Sweep.Step(Math.Min(sweep.Length, x + beyond));
                }

                // The margins that follow are asked of the shortened piece.
                sweep = margin.Sweep;
                atEnd = sweep.System.ForcesOn(s.Time + sweep.Length, in sweep.Taken.End);
                sweep.Evaluations++;
            }
        }

        return jumps;
    }
}
