namespace FootballPhysics;

/// <summary>
/// Classical Runge–Kutta in parts as short as a motion asks for, which is one step for everything else: in a net, whose forces settle much faster than a step is
/// long. Where it has settled, the parts are longer. The last part is cut, so that where the step ends depends smoothly on its length.
/// </summary>
internal struct Substeps : IIntegrator
{
    /// <summary>A step that is taken again goes on from so many parts before its end: a search for what happens in it hardly goes back further.</summary>
    private const double Before = 3.0;

    // Where it goes on from: how far that is, the next part, and all of the step until there.
    private double _done;
    private double _part;
    private MotionStep _step;

    /// <summary>Right-hand sides of the step before.</summary>
    public int Stages { get; private set; }

    public readonly bool LastStageAtEnd => true;

    public readonly int Order => default(ClassicalRungeKutta).Order;

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
        // What is taken of a step does not depend on how long the step is, but for its last part: a step that is taken again goes on from where it did not end yet.
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

            // Rotations follow one another; the rates at the start are those of the first part.
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

            // How fast the forces change says how long the next part may be; what is long before the end is kept to go on from.
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

    /// <summary>|ȧ| in a part, by its mean acceleration and that at its start, m/s³.</summary>
    private static double JerkIn(in Motion from, in MotionStep part, double h) =>
        2.0 / h * (((part.End.Velocity - from.Velocity) / h) - part.StartRates.Acceleration).Length;
}
