using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Finds the end of a piece on one or several surfaces: a load, a grip, a slip, a roll or a spin ends, or an unloaded contact gets a
/// load.</summary>
/// <remarks>Each margin is a function along the piece that is positive until its event (<see cref="IContactMotion.Margin"/>).</remarks>
internal struct EventMargin<TSystem, TMethod> : IFunction
    where TSystem : struct, IContactMotion
    where TMethod : struct, IMotionMethod
{
    /// <summary>After this many evaluations per piece, the search stops locating events: the next piece then starts after the event.</summary>
    private const int MostEvaluations = 2048;

    private MotionSweep<TSystem, TMethod> _sweep;
    private readonly int _index;
    private readonly double _time;
    private readonly double _length;

    // The bracket of the sign change. In a narrow bracket, a value above the third number indicates a jump.
    private double _last;
    private double _first;
    private double _jump;
    private double _value;

    private EventMargin(int index, in MotionSweep<TSystem, TMethod> sweep, double time)
    {
        _sweep = sweep;
        _index = index;
        _time = time;
        _length = sweep.Length;
        _first = sweep.Length;
        _last = 0;
        _jump = 0;
        _value = 0;
    }

    public bool Evaluate(double x, out double value)
    {
        _sweep.Step(x);
        value = At(x, in _sweep.Taken.End);

        // Track the bracket: if a value stays large in a narrow bracket, the margin has jumped.
        _value = value;
        _last = value > 0 ? x : _last;
        _first = value > 0 ? _first : x;
        return Math.Abs(value) > _jump && _first - _last < ContactTolerances.JumpWidth * _length;
    }

    private double At(double x, in Motion at)
    {
        _sweep.System.Look(_time + x, in at);
        _sweep.Evaluations++;
        return _sweep.System.Margin(_index, _time + x, in at);
    }

    /// <summary>Shortens a piece to its first event.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="time">Its start, s.</param>
    /// <param name="jumps">True if the piece ends beyond a jump of a margin, as at an edge.</param>
    /// <returns>True if the piece was shortened.</returns>
    public static bool EndPiece(ref MotionSweep<TSystem, TMethod> sweep, double time, out bool jumps)
    {
        // Search only for margins that are positive at the start and negative at the end. Use the same overshoot for all of them; otherwise, a later one
        // would end the piece before an edge.
        double length = sweep.Length;
        bool shortened = false;
        jumps = false;
        Look(ref sweep, time);
        for (int i = 0; i < sweep.System.Margins; i++)
        {
            double end = sweep.System.Margin(i, time + sweep.Length, in sweep.Taken.End);
            if (end < 0 && sweep.Evaluations <= MostEvaluations)
            {
                shortened |= EndAtZero(i, ref sweep, time, end, length, ref jumps);
            }
        }

        return shortened;
    }

    /// <summary>Ends a piece just beyond the first zero of a margin, by the Illinois method on the step itself.</summary>
    /// <returns>False if the margin is not positive at the start.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)] // its copy of the sweep would be cleared in every piece
    private static bool EndAtZero(int index, ref MotionSweep<TSystem, TMethod> sweep, double time, double end, double length, ref bool jumps)
    {
        var margin = new EventMargin<TSystem, TMethod>(index, in sweep, time);
        double start = margin.At(0, sweep.From);
        if (!(start > 0))
        {
            return false;
        }

        margin._jump = ContactTolerances.MarginJump * start;
        double x = Roots.Illinois(ref margin, 0, start, sweep.Length, end, ContactTolerances.EventWidth * length, EventLocator.MostSteps);

        // If a value is not small at the zero, the margin has jumped.
        bool jumped = Math.Abs(margin._value) > margin._jump;
        jumps |= jumped;
        sweep = margin._sweep;
        sweep.Step(Math.Min(length, x + ((jumped ? ContactTolerances.BeyondJump : ContactTolerances.Beyond) * length)));
        Look(ref sweep, time);
        return true;
    }

    /// <summary>Computes the forces at the end of the piece.</summary>
    private static void Look(ref MotionSweep<TSystem, TMethod> sweep, double time)
    {
        sweep.System.Look(time + sweep.Length, in sweep.Taken.End);
        sweep.Evaluations++;
    }
}
