using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Finds the end of a piece on several surfaces.</summary>
/// <remarks>
/// Each margin is a function along the piece that is positive until its event: a load or a friction cone reaches its limit, a slip passes
/// zero, an unloaded contact gets a load, the ball comes to rest, or the spin about the bearer's normal ends.
/// </remarks>
internal unsafe struct SetMargin<TIntegrator> : IFunction
    where TIntegrator : struct, IMotionMethod
{
    private const int MostSteps = 40;

    /// <summary>After this many evaluations per piece, the search stops locating events: the next piece then starts after the event.</summary>
    private const int MostEvaluations = 2048;

    /// <summary>A margin above this share of its value at the start is far from zero.</summary>
    private const double Clear = 0.25;

    private const int Limits = (int)Limit.HoldSpin + 1;

    /// <summary>Maximum number of margins per piece.</summary>
    public const int Most = Limits * ContactSystem.Most;

    public MotionSweep<ContactSystem, TIntegrator> Sweep;
    private readonly Limit _limit;
    private readonly int _contact;
    private readonly double _time;

    private SetMargin(Limit limit, int contact, in MotionSweep<ContactSystem, TIntegrator> sweep, double time)
    {
        _limit = limit;
        _contact = contact;
        _time = time;
        Sweep = sweep;
    }

    private enum Limit
    {
        Load,
        Grip,
        Slip,
        Opening,
        Bearer,
        Rest,
        Spin,
        Roll,
        Hold,
        HoldSpin,
    }

    public bool Evaluate(double x, out double value)
    {
        Sweep.Step(x);
        Look(ref Sweep, _time);
        value = Value(ref Sweep, _limit, _contact, _time);
        return false;
    }

    /// <summary>Computes the margins at the start of a piece from the rates that the modes were determined with.</summary>
    public static void Start(ref MotionSweep<ContactSystem, TIntegrator> sweep, in BallState s, in Motion from, double* starts)
    {
        for (int i = 0; i < sweep.System.Count; i++)
        {
            // The limits from Rest on belong to the bearer.
            int limits = i == sweep.System.Bearer ? Limits : (int)Limit.Rest;
            for (int limit = 0; limit < Limits; limit++)
            {
                starts[(i * Limits) + limit] = limit < limits ? Value(ref sweep, (Limit)limit, i, s.Time, in from, 0) : 0;
            }
        }
    }

    /// <summary>Shortens a piece to its first event.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="starts">The margins at its start.</param>
    /// <returns>True if the piece was shortened.</returns>
    public static bool EndPiece(ref MotionSweep<ContactSystem, TIntegrator> sweep, in BallState s, double* starts)
    {
        double length = sweep.Length;
        bool shortened = false;

        // A margin that is far from zero at the last stage, or extrapolated from it to the end, needs no search.
        if (IsClear(ref sweep, in s, starts))
        {
            return false;
        }

        // Search only for margins that are positive at the start and negative at the end.
        Look(ref sweep, s.Time);
        for (int i = 0; i < Limits * sweep.System.Count; i++)
        {
            double end = starts[i] > 0 ? Value(ref sweep, (Limit)(i % Limits), i / Limits, s.Time) : 0;
            if (!(end < 0) || sweep.Evaluations > MostEvaluations)
            {
                continue;
            }

            var margin = new SetMargin<TIntegrator>((Limit)(i % Limits), i / Limits, in sweep, s.Time);
            double x = Roots.Illinois(ref margin, 0, starts[i], sweep.Length, end, ContactTolerances.SetEventWidth * length, MostSteps);
            sweep = margin.Sweep;
            sweep.Step(Math.Min(length, x + (ContactTolerances.Beyond * length)));
            Look(ref sweep, s.Time);
            shortened = true;
        }

        return shortened;
    }

    /// <summary>True if every margin keeps enough of its value at the start.</summary>
    private static bool IsClear(ref MotionSweep<ContactSystem, TIntegrator> sweep, in BallState s, double* starts)
    {
        // A margin that falls in a straight line to Clear at the end has this share of its value left at the last stage.
        double clear = 1.0 - (default(TIntegrator).LastStage * (1.0 - Clear));
        for (int i = 0; i < sweep.System.Count; i++)
        {
            for (int limit = 0; limit < Limits; limit++)
            {
                double start = starts[(i * Limits) + limit];
                if (start > 0 && !(Value(ref sweep, (Limit)limit, i, s.Time) > clear * start))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>Computes loads, friction and slips at the end of the piece.</summary>
    private static void Look(ref MotionSweep<ContactSystem, TIntegrator> sweep, double time)
    {
        sweep.System.Rates(time + sweep.Length, in sweep.Taken.End, out _);
        sweep.Evaluations++;
    }

    private static double Value(ref MotionSweep<ContactSystem, TIntegrator> sweep, Limit limit, int contact, double time) =>
        Value(ref sweep, limit, contact, time, in sweep.Taken.End, sweep.Length);

    private static double Value(ref MotionSweep<ContactSystem, TIntegrator> sweep, Limit limit, int index, double time, in Motion at, double after)
    {
        ref ContactSystem system = ref sweep.System;
        ref readonly SetContact contact = ref system.Contacts[index];
        switch (limit)
        {
            case Limit.Load when contact.Bears:
                return contact.Load - ContactTolerances.LeastLoad;
            case Limit.Grip when contact.Bears && contact.Sticks:
                return contact.Grip;
            case Limit.Slip when contact.Bears && !contact.Sticks && contact.Sliding > 0 && contact.Slip != Vector3d.Zero:
                return Vector3d.Dot(in contact.Slip, in contact.Direction);
            case Limit.Opening when !contact.Bears:
                return contact.Opening + ContactTolerances.LeastLoad;
            case Limit.Bearer when contact.Bears && system.Bearer >= 0 && !system.IsTied && index != system.Bearer && contact.Sticks == system.Contacts[system.Bearer].Sticks:
                return (system.Contacts[system.Bearer].Load * (1.0 + ContactTolerances.SameLoad)) - contact.Load;
            case Limit.Rest:
                Collider carrier = system.World.ByIndex[contact.Collider];
                return Math.Sqrt(system.World.Energy(in at, carrier, time + after)) - Math.Sqrt(system.World.RestEnergy);
            case Limit.Spin when contact.Drilling > 0 && system.SpinSign != 0:
                return system.SpinSign * (Vector3d.Dot(in at.Spin, in contact.Normal) - contact.CarrierSpin);
            case Limit.Roll when contact.Sticks && !system.Pinned:
                return Vector3d.Dot(in contact.RollingVelocity, in system.Along);
            case Limit.Hold when system.Pinned:
                return (contact.Rolling * contact.Load) - Math.Abs(system.Held);
            case Limit.HoldSpin when system.HoldsSpin:
                return (contact.Drilling * contact.Load) - Math.Abs(system.HeldSpin);
            default:
                return 0;
        }
    }
}
