using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Finds the end of a slide or a roll: the load or the grip ends, the ball comes to rest, or drilling friction stops the spin
/// about the normal.</summary>
/// <remarks>Each margin is a function along the piece that is positive until its event.</remarks>
internal struct SurfaceMargin<TIntegrator> : IFunction
    where TIntegrator : struct, IMotionMethod
{
    public MotionSweep<SurfaceSystem, TIntegrator> Sweep;
    private readonly SurfaceLimit _what;
    private readonly double _time;
    private readonly double _length;

    // The bracket of the sign change. In a narrow bracket, a value above the third number indicates a jump.
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

        // Track the bracket: if a value stays large in a narrow bracket, the margin has jumped.
        _last = value > 0 ? x : _last;
        _first = value > 0 ? _first : x;
        return Math.Abs(value) > _jump && _first - _last < ContactTolerances.JumpWidth * _length;
    }

    public double Of(in Motion at, double after)
    {
        SurfaceForces on = default;
        if (_what != SurfaceLimit.Spin)
        {
            on = Sweep.System.ForcesOn(_time + after, in at);
            Sweep.Evaluations++;
        }

        return Of(_what, in Sweep.System, in on, in at, _time + after);
    }

    /// <summary>Returns a margin if the forces are known. The spin margin does not use them.</summary>
    private static double Of(SurfaceLimit what, in SurfaceSystem system, in SurfaceForces on, in Motion at, double time)
    {
        switch (what)
        {
            case SurfaceLimit.Spin:
                // Without drilling friction, the end of the spin has no effect.
                return system.Material.DrillingLength > 0 && system.SpinSign != 0
                    ? system.SpinSign * system.AboutCarrier(in at.Spin, system.NormalAt(in at.Position, time))
                    : 0;
            case SurfaceLimit.Load:
                return on.FreeLoad;
            case SurfaceLimit.Grip:
                return system.SlidingFriction(in on) - system.Traction(in on).Length;
            default:
                bool held = system.Rests(in on);

                // Use the square root of the energy, because it falls almost linearly.
                return held ? Math.Sqrt(system.World.Energy(in at, system.Carrier, time)) - Math.Sqrt(system.World.RestEnergy) : 1;
        }
    }

    /// <summary>Ends a piece when the load or the grip ends, a rolling ball comes to rest, or drilling friction stops the spin about the
    /// normal.</summary>
    /// <remarks>Each margin is positive until its event.</remarks>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="rolls">Whether it rolls.</param>
    /// <param name="keepsGrip">Whether it rolls regardless of the grip.</param>
    /// <returns>True if the piece ends beyond a jump of a margin, as at an edge.</returns>
    public static bool EndPiece(ref MotionSweep<SurfaceSystem, TIntegrator> sweep, in BallState s, bool rolls, bool keepsGrip)
    {
        // Evaluate all margins once at the end; search only for those that are negative there. Use the same overshoot for all of them; otherwise,
        // a later one would end the piece before the edge.
        double beyond = ContactTolerances.BeyondJump * sweep.Length;
        bool jumps = false;
        SurfaceForces atEnd = sweep.System.ForcesOn(s.Time + sweep.Length, in sweep.Taken.End);
        sweep.Evaluations++;
        for (var what = SurfaceLimit.Load; what <= SurfaceLimit.Spin; what++)
        {
            if ((!rolls && what is SurfaceLimit.Grip or SurfaceLimit.Rest) || (keepsGrip && what == SurfaceLimit.Grip))
            {
                continue;
            }

            double end = Of(what, in sweep.System, in atEnd, in sweep.Taken.End, s.Time + sweep.Length);
            if (end < 0)
            {
                EndAtZero(what, ref sweep, in s, end, beyond, ref atEnd, ref jumps);
            }
        }

        return jumps;
    }

    /// <summary>Ends a piece at the zero of a margin that is negative at its end, unless it is not positive at the start.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)] // its copy of the sweep would be cleared in every piece
    private static void EndAtZero(
        SurfaceLimit what, ref MotionSweep<SurfaceSystem, TIntegrator> sweep, in BallState s, double end, double beyond, ref SurfaceForces atEnd, ref bool jumps)
    {
        var margin = new SurfaceMargin<TIntegrator>(what, in sweep, s.Time);
        double start = margin.Of(new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance), 0);
        if (start > 0)
        {
            // Find the first zero on the step itself by the Illinois method. If a value is not small there, the margin has jumped.
            margin._jump = ContactTolerances.MarginJump * start;
            double x = Roots.Illinois(ref margin, 0, start, sweep.Length, end, ContactTolerances.EventWidth * sweep.Length, 60);
            jumps = Math.Abs(margin.Of(in margin.Sweep.Taken.End, x)) > margin._jump;
            if (jumps)
            {
                margin.Sweep.Step(Math.Min(sweep.Length, x + beyond));
            }

            // Check the remaining margins on the shortened piece.
            sweep = margin.Sweep;
            atEnd = sweep.System.ForcesOn(s.Time + sweep.Length, in sweep.Taken.End);
            sweep.Evaluations++;
        }
    }
}
