namespace Football.Physics;

/// <summary>
/// Classical Runge–Kutta in parts as short as a motion asks for, which is one step for everything else: in a net, whose forces settle much faster than a step is
/// long. Where it has settled, the parts are longer. The last part is cut, so that where the step ends depends smoothly on its length.
/// </summary>
internal struct Substeps : IIntegrator
{
    /// <summary>Right-hand sides of the step before.</summary>
    public int Stages { get; private set; }

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

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        ClassicalRungeKutta method = default;
        double part = system.LongestPart(in from, double.PositiveInfinity, h);
        double done = part;
        method.Advance(ref system, time, in from, done, out step);
        Stages = method.Stages;
        double jerk = JerkIn(in from, in step, part);
        while (done < h)
        {
            part = system.LongestPart(in step.End, jerk, h - done);
            Motion at = step.End;
            method.Advance(ref system, time + done, in at, part, out MotionStep next);
            step.Rotation = RotationVector.Then(in step.Rotation, in next.Rotation);
            step.End = next.End;
            done += part;
            Stages += method.Stages;
            jerk = JerkIn(in at, in next, part);
        }
    }

    /// <summary>|ȧ| in a part, by its mean acceleration and that at its start, m/s³.</summary>
    private static double JerkIn(in Motion from, in MotionStep part, double h) =>
        2.0 / h * (((part.End.Velocity - from.Velocity) / h) - part.StartRates.Acceleration).Length;
}
