using FootballPhysics.Integration;

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
    private const double LargestRate = 0.02;
    private const double SmallError = 1e-4;

    /// <summary>The same for a piece of order 8, which is as cheap with a smaller error.</summary>
    /// <remarks>Above: a spring of 100/s at 30 Hz, or a ball that crosses edges of forces, is millimetres off. Below: pieces that find such an edge cost more.</remarks>
    private const double LargestRateOfEighth = 0.005;
    private const double SmallErrorOfEighth = 3e-5;

    /// <summary>The error of a piece of the shortest length at which the ball stays where it is, m/s.</summary>
    private const double LostError = 0.1;

    /// <summary>Up to this product of a stated stiffness and a length, the scene's integrator follows the force.</summary>
    private const double Soft = 0.25;

    /// <summary>The longest piece, as the product of its length and the stated stiffness: its path follows from its ends.</summary>
    private const double LongestPiece = 1.0;

    /// <summary>The squared product of rate and length up to which methods of low order do not overshoot.</summary>
    private const double LargestOfLowOrder = 0.01;

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

    /// <summary>Returns the longest piece that the stated stiffness allows, s, and notes if it needs order 8.</summary>
    public double LongestOf(double h, ref StepRun run)
    {
        if (!(_stiffness * h > Soft))
        {
            return h;
        }

        double longest = Math.Min(h, Math.Max(LongestPiece / _stiffness, run.ShortestOfAll));
        run.Follow(longest);
        return longest;
    }

    /// <summary>Takes a piece by the scene's integrator if it follows the forces.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="h">Its length, s.</param>
    /// <param name="from">The motion at its start.</param>
    /// <param name="trace">The forces at its stages; it contains those at the start.</param>
    /// <param name="run">The step of the ball; if the forces are not followed, it takes pieces of order 8 from now on.</param>
    /// <returns>False if the integrator does not follow them.</returns>
    public bool TryTake<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, double h, in Motion from, ForceTrace* trace, ref StepRun run)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        bool follows = h <= trace->LongestStep && Follows(ref sweep, h, in from, trace);
        if (!follows)
        {
            run.Log.Evaluations += sweep.Evaluations;
            run.Follow(h);
        }

        return follows;
    }

    private bool Follows<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, double h, in Motion from, ForceTrace* trace)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        trace->Restart(h);
        sweep.Step(h);
        if (default(TMethod).Order >= default(ClassicalRungeKutta).Order)
        {
            return !trace->IsWild && h * trace->ErrorOfClassical() <= Math.Max(SmallError, LargestRate * h);
        }

        // A method of low order need not be accurate, but must not overshoot: its stages do not show that, so evaluate the end. The position of the end lags behind its
        // velocity by a step.
        ref readonly Motion end = ref sweep.Taken.End;
        Vector3d moved = h * end.Velocity;
        sweep.Evaluate(new Motion(from.Position + moved, end.Velocity, end.Spin, end.AirDistance));
        double spun = _radius * (end.Spin - from.Spin).Length;
        return !trace->IsWild && trace->Stiffness(h, moved.Length, (end.Velocity - from.Velocity).Length, spun) <= LargestOfLowOrder;
    }

    /// <summary>Takes a piece of order 8, as long as its error allows.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="h">The longest piece, s.</param>
    /// <param name="trace">The forces at its stages.</param>
    /// <param name="run">The step of the ball.</param>
    /// <returns>False if the forces change too fast for the evaluations that are left: the ball stays where it is.</returns>
    public bool Follow<TSystem>(ref MotionSweep<TSystem, EighthOrder> sweep, double h, ForceTrace* trace, ref StepRun run)
        where TSystem : struct, IMotionSystem
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
                run.Followed = length * Math.Min(MostChange, Share * Math.Pow(share, PerOrder));
                run.CountShort(length);
                return true;
            }

            double shortest = run.ShortestFollowed;
            if (length <= shortest)
            {
                run.CountStiff();
                if (error <= LostError)
                {
                    run.Followed = length;
                    return true;
                }

                run.Log.Evaluations += sweep.Evaluations;
                run.Stall();
                return false;
            }

            // A share that is NaN, from forces beyond all bounds, takes the least change.
            double change = Share * Math.Pow(share, PerOrder);
            length = Math.Max(shortest, length * (change > LeastChange ? Math.Min(Share, change) : LeastChange));
        }
    }

    private double ErrorOf(in Motion end, double h, ForceTrace* trace) => Math.Max(
        h * trace->ErrorOfEighth(), ShareOfLast * Math.Max((end.Velocity - trace->LastVelocity).Length, _radius * (end.Spin - trace->LastSpin).Length));
}
