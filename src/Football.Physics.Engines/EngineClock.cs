namespace FootballPhysics.Engines;

/// <summary>Counts the steps of a ball in the fixed frames of an engine, so that the ball follows the engine's time: slow motion, pause, changed rates and speed-up.</summary>
/// <remarks>
/// Call <see cref="StepsIn"/> once per fixed frame, and take as many steps. Engines store the length of a frame in single precision. If it is a multiple or a fraction of a step to within
/// 1e-6, it counts as exactly that. A frame as long as a step therefore gives one step, however long the game runs. Not thread-safe.
/// </remarks>
public sealed class EngineClock
{
    /// <summary>A frame this close to a multiple or a fraction of a step, relative to the frame, counts as it.</summary>
    /// <remarks>Above: a frame that is really shorter than a step gives as many steps. Below: numbers in single precision differ by more, and a frame has no step after some minutes.</remarks>
    private const double SameLength = 1e-6;

    /// <summary>A step is due this early, relative to the step.</summary>
    /// <remarks>Above: balls are ahead of the game. Below: rounding of the sum delays a step by a frame.</remarks>
    private const double AlmostDue = 1e-3;

    /// <summary>The engine's time that the ball has not simulated yet, s; at least −0.001 and less than 1 time step. At the start of a frame, positions of the engine hold this much after the ball's clock.</summary>
    public double Left { get; private set; }

    /// <summary>The length of the last frame, s; 0 before the first one.</summary>
    public double Frame { get; private set; }

    /// <summary>Adds a fixed frame, and returns the number of steps that are due.</summary>
    /// <param name="frame">The length of the frame in the time of the game, s: Godot's delta, or Unity's Time.fixedDeltaTime. A length that is not above 0 gives no step.</param>
    /// <param name="timeStep">The length of a step, s; above 0.</param>
    public int StepsIn(double frame, double timeStep)
    {
        if (!(frame > 0))
        {
            return 0;
        }

        // One of both numbers is 1: the frame is a multiple or a fraction of a step.
        double exact = Math.Max(1.0, Math.Round(frame / timeStep)) * timeStep / Math.Max(1.0, Math.Round(timeStep / frame));
        Frame = Math.Abs(exact - frame) <= SameLength * frame ? exact : frame;
        double due = Math.Floor(((Left + Frame) / timeStep) + AlmostDue);
        Left += Frame - (due * timeStep);
        return (int)due;
    }

    /// <summary>Returns the share of the last step at which to draw the ball, 0 … 1, for <see cref="FixedStepRunner.PoseAt"/>.</summary>
    /// <param name="since">The time since the start of the last fixed frame, s.</param>
    /// <param name="timeStep">The length of a step, s; above 0.</param>
    public double FractionAt(double since, double timeStep) => Math.Min(1.0, Math.Max(0.0, (Left + since) / timeStep));

    /// <summary>Forgets the time that is left. Call it if the length of a step changes.</summary>
    public void Restart() => Left = 0;
}
