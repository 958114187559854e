using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Keeps the pieces of a motion so short that the integrator follows the custom forces.</summary>
/// <remarks>
/// The stages of a step show how far it is off. If the scene's integrator follows the forces, its step stands: soft forces cost nothing. Otherwise the pieces of the
/// rest of the step have order 8, and as long as the error allows (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, II.4).
/// </remarks>
internal sealed unsafe class OwnForceGuard
{
    /// <summary>The error of the velocity that a step of the scene's integrator may leave, per time, m/s², and the one that is small however short the step, m/s.</summary>
    /// <remarks>Above: a spring of 20/s at 60 Hz is millimetres off after a second. Below: springs of 5/s need order 8.</remarks>
    private const double LargestRate = 0.01;
    private const double SmallError = 1e-4;

    /// <summary>The same for a piece of order 8, which is as cheap with a smaller error.</summary>
    /// <remarks>Above: a spring of 100/s at 30 Hz, or a ball that crosses edges of forces, is millimetres off. Below: pieces that find such an edge cost more.</remarks>
    private const double LargestRateOfEighth = 0.005;
    private const double SmallErrorOfEighth = 3e-5;

    /// <summary>The shortest piece that finds the edge of a force, s.</summary>
    /// <remarks>Above: an edge of a strong force leaves a larger error. Below: more pieces find it.</remarks>
    public const double ShortestPiece = 1e-10;

    /// <summary>The error of a piece of the shortest length at which the ball stays where it is, m/s.</summary>
    private const double LostError = 0.1;

    /// <summary>Up to this product of a stated stiffness and a length, the scene's integrator follows the force.</summary>
    private const double Soft = 0.25;

    /// <summary>The longest piece, as the product of its length and the stated stiffness: its path follows from its ends.</summary>
    private const double LongestPiece = 1.0;

    /// <summary>The squared product of rate and length up to which methods of low order follow a force.</summary>
    /// <remarks>Above: with RK2 at 100 Hz, a spring of 10/s is millimetres off after a second. Below: softer springs need order 8.</remarks>
    private const double LargestOfLowOrder = 0.0025;

    /// <summary>The part of the difference between the last stage and the end that counts as error.</summary>
    /// <remarks>
    /// Both are the motion at the end, the stage to sixth order. Above: springs need more pieces. Below: an edge of a force may cancel out of the error of order 8.
    /// </remarks>
    private const double ShareOfLast = 0.01;

    /// <summary>The share of the largest length at which the next piece is tried, and the bounds of the change of the length.</summary>
    private const double Share = 0.8;
    private const double LeastChange = 0.1;
    private const double MostChange = 5.0;

    /// <summary>1/order of the error of a piece of order 8, relative to the allowed one.</summary>
    private const double PerOrder = 1.0 / 7.0;

    private readonly double _radius;
    private readonly double _stiffness;

    /// <summary>Creates the guard of a scene.</summary>
    public OwnForceGuard(Scene scene)
    {
        _radius = scene.Ball.Radius;
        foreach (IForce force in scene.Forces.CustomForces)
        {
            _stiffness += force is IStiffForce stiff ? stiff.Stiffness : 0;
        }
    }

    /// <summary>Shortens a piece to the length that the stated stiffness and the nets allow, and notes if it needs order 8.</summary>
    /// <param name="h">The length of the piece, s.</param>
    /// <param name="ofNets">The longest part in the nets, s: their forces change as fast as those of a stiff spring. Infinite outside nets.</param>
    /// <param name="run">The step of the ball.</param>
    public void Shorten(ref double h, double ofNets, ref StepRun run)
    {
        if (_stiffness * h > Soft)
        {
            h = Math.Min(h, Math.Max(LongestPiece / _stiffness, run.ShortestOfAll));
            run.Follow(h);
        }

        if (ofNets < double.PositiveInfinity)
        {
            h = Math.Min(h, ofNets);
            run.Follow(h);
        }
    }

    /// <summary>Takes a piece if the method follows the custom forces: the scene's integrator at first, then order 8, which shortens it.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="h">Its length, s.</param>
    /// <param name="trace">The forces at its stages; it contains those at the start.</param>
    /// <param name="run">The step of the ball. If its integrator does not follow the forces, the pieces have order 8 from now on.</param>
    /// <returns>False if the method does not follow the forces. The ball must stay where it is then.</returns>
    public bool Take<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, double h, ForceTrace* trace, ref StepRun run)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        sweep.System.Trace = trace;
        bool isLast = run.Followed > 0;
        bool follows = isLast ? Follow(ref sweep, h, trace, ref run) : h <= trace->LongestStep && Follows(ref sweep, h, trace);
        sweep.System.Trace = null;
        if (follows)
        {
            return true;
        }

        run.Log.Evaluations += sweep.Evaluations;
        if (isLast)
        {
            run.Stall();
        }
        else
        {
            run.Follow(h);
        }

        return false;
    }

    private bool Follows<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, double h, ForceTrace* trace)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        trace->Restart(h);
        sweep.Step(h);
        if (default(TMethod).Order >= default(ClassicalRungeKutta).Order)
        {
            return !trace->IsWild && h * trace->ErrorOfClassical(h, sweep.From) <= Math.Max(SmallError, LargestRate * h);
        }

        // A method of low order need not be accurate, but must not be worse than with the air. Its stages do not show that, so evaluate the end. The position of the end lags behind
        // its velocity by a step.
        ref readonly Motion end = ref sweep.Taken.End;
        sweep.Evaluate(new Motion(sweep.From.Position + (h * end.Velocity), end.Velocity, end.Spin, end.AirDistance, in end.Turn));
        return !trace->IsWild && trace->Stiffness(h, sweep.From, isLower: false) <= LargestOfLowOrder;
    }

    /// <summary>Takes a piece of order 8, as long as its error allows.</summary>
    /// <returns>False if the forces change too fast for the evaluations that are left.</returns>
    private bool Follow<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, double h, ForceTrace* trace, ref StepRun run)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        double length = Math.Min(h, Math.Min(run.Followed, trace->LongestStep));
        length = length < h ? h / Math.Ceiling(h / length) : h;
        while (true)
        {
            trace->Restart(length);
            sweep.Step(length);
            double error = trace->IsWild ? double.PositiveInfinity : ErrorOf(in sweep.Taken.End, length, trace);
            double share = Math.Max(SmallErrorOfEighth, LargestRateOfEighth * length) / error;
            if (share >= 1)
            {
                run.Followed = length * Math.Min(MostChange, Share * Elementary.Pow(share, PerOrder));
                run.CountShort(length);
                return true;
            }

            double shortest = run.ShortestFollowed;
            if (length <= shortest)
            {
                run.CountStiff();
                run.Followed = length;
                return error <= LostError;
            }

            // A share that is NaN, from forces beyond all bounds, takes the least change.
            double change = Share * Elementary.Pow(share, PerOrder);
            length = Math.Max(shortest, length * (change > LeastChange ? Math.Min(Share, change) : LeastChange));
        }
    }

    private double ErrorOf(in Motion end, double h, ForceTrace* trace) => Math.Max(
        h * trace->Error(HighOrder.FifthError, HighOrder.ThirdError),
        ShareOfLast * Math.Max((end.Velocity - trace->Last.Velocity).Length, _radius * (end.Spin - trace->Last.Spin).Length));
}
