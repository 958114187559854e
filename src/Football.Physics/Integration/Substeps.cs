namespace FootballPhysics;

/// <summary>Classical Runge–Kutta in substeps, for a ball in a net: its forces settle much faster than a step.</summary>
/// <remarks>
/// The motion sets the length of each substep; other motions take a single one. After the forces have settled, substeps grow. The last one is cut, so that the end
/// depends smoothly on the length of the step.
/// </remarks>
internal struct Substeps : IIntegrator
{
    /// <summary>The number of substeps before the end from which a repeated step resumes: a search rarely goes back further.</summary>
    private const double Before = 3.0;

    // The resume point: time since the start, length of the next substep, and the result of the step so far.
    private double _done;
    private double _part;
    private MotionStep _step;

    /// <summary>The number of evaluations of the last step.</summary>
    public int Stages { get; private set; }

    public readonly bool LastStageAtEnd => true;

    public readonly int Order => default(ClassicalRungeKutta).Order;

    public readonly Tableau Tableau => default(ClassicalRungeKutta).Tableau;

    public readonly double ShareInPath => default(ClassicalRungeKutta).ShareInPath;

    public readonly bool GainsByHops => default(ClassicalRungeKutta).GainsByHops;

    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        ClassicalRungeKutta method = default;
        Stages = method.Stages;
        method.Fly(ref air, in start, ref motion, in wind, branch, upward, h, out step);
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        // Except for the last one, substeps do not depend on the length of the step, so a repeated step resumes from a saved point.
        ClassicalRungeKutta method = default;
        bool goesOn = _done > 0 && _done < h;
        double done = goesOn ? _done : 0;
        double part = goesOn ? _part : system.LongestPart(in from, double.PositiveInfinity);
        step = goesOn ? _step : new MotionStep { End = from };
        Stages = 0;
        while (true)
        {
            bool isLast = done + part >= h;
            Motion at = step.End;
            MotionRates rates = start;
            if (done > 0)
            {
                system.Rates(time + done, in at, out rates);
            }

            method.Advance(ref system, time + done, in at, in rates, isLast ? h - done : part, out MotionStep next);
            Stages += method.Stages;
            double jerk = JerkIn(in at, in next, part);

            // Compose the rotations; the rates at the start are those of the first substep.
            if (done > 0)
            {
                next.Rotation = RotationVector.Then(in step.Rotation, in next.Rotation);
                next.StartRates = step.StartRates;
            }

            step = next;
            if (isLast)
            {
                return;
            }

            // The jerk limits the next substep. Save a point well before the end to resume from.
            done += part;
            part = system.LongestPart(in step.End, jerk);
            if (done + (Before * part) < h)
            {
                _done = done;
                _part = part;
                _step = step;
            }
        }
    }

    /// <summary>Estimates |ȧ| in a substep from its mean acceleration and that at its start, in m/s³.</summary>
    private static double JerkIn(in Motion from, in MotionStep part, double h) =>
        2.0 / h * (((part.End.Velocity - from.Velocity) / h) - part.StartRates.Acceleration).Length;
}
