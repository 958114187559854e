namespace FootballPhysics.Integration;

/// <summary>Steps of high order in parts, for a ball in a net: its forces change faster than a step.</summary>
/// <remarks>
/// The motion sets the length of each part. Only the last part depends on the length of the step, so the end depends smoothly on that length. A part that is
/// shorter than necessary takes a method of lower order, which needs fewer evaluations.
/// </remarks>
internal struct Substeps : IMotionMethod
{
    /// <summary>The share of the longest part below which the classical method is as accurate.</summary>
    private const double Short = 0.02;

    /// <summary>The same for the method of order 6.</summary>
    private const double Medium = 0.25;

    /// <summary>The number of parts before the end from which a repeated step resumes: a search rarely goes back further.</summary>
    private const double Before = 3.0;

    /// <summary>Maximum number of parts of a step: a motion that runs away would need ever shorter ones.</summary>
    private const int MostParts = 256;

    // The resume point: time since the start, length of the next part, the rates there, and the result of the step so far.
    private double _done;
    private double _part;
    private MotionRates _rates;
    private MotionStep _step;

    /// <summary>The number of evaluations of the last step.</summary>
    public int Stages { get; private set; }

    public readonly double LastStage => 1;

    public readonly int Order => default(ClassicalRungeKutta).Order;

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        bool goesOn = _done > 0 && _done < h;
        double done = goesOn ? _done : 0;
        MotionRates rates = goesOn ? _rates : start;
        double part = goesOn ? _part : system.LongestPart(in from, in rates);
        step = goesOn ? _step : new MotionStep { End = from };
        Stages = 0;
        for (int parts = 1; ; parts++)
        {
            // A part that is not a number is the last one, too.
            bool isLast = !(done + part < h) || parts == MostParts;
            Motion at = step.End;
            double length = isLast ? h - done : part;
            Stages += Take(ref system, time + done, in at, in rates, length, length / part, out MotionStep next);

            // Compose the rotations; the rates at the start are those of the first part.
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

            // Save a resume point well before the end.
            done += part;
            system.Rates(time + done, in step.End, out rates);
            part = system.LongestPart(in step.End, in rates);
            if (done + (Before * part) < h)
            {
                _done = done;
                _part = part;
                _rates = rates;
                _step = step;
            }
        }
    }

    /// <summary>Takes a part, and returns its number of evaluations.</summary>
    private static int Take<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, double share, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        if (share <= Short)
        {
            ClassicalRungeKutta method = default;
            method.Advance(ref system, time, in from, in start, h, out step);
            return method.Stages;
        }

        HighOrder high = share <= Medium ? HighOrder.Sixth : HighOrder.Eighth;
        high.Advance(ref system, time, in from, in start, h, turnsByStages: false, out step);
        return high.Stages;
    }
}
