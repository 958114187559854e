namespace FootballPhysics.Prediction;

/// <summary>Runs a look-ahead with custom forces, which may be stiffer than air, in adaptive steps.</summary>
/// <remarks>Step doubling: compares a full step with two half steps, and halves the step until they agree.</remarks>
internal static class OwnForceSteps
{
    /// <summary>The maximum difference between a step and its two halves, in m; velocities, in m/s, are multiplied by 0.1 s.</summary>
    private const double Tolerance = 1e-6;
    private const double VelocityTime = 0.1;

    /// <summary>The share of the tolerance below which the next step doubles; the error of RK4 grows by 2⁵.</summary>
    private const double Plenty = 1.0 / 64.0;

    /// <summary>The first step, in s.</summary>
    public const double FirstStep = 0.005;

    /// <summary>The shortest step as a share of the longest.</summary>
    private const double Shortest = 1e-5;

    /// <summary>The largest error to accept in the shortest step, in m.</summary>
    private const double Lost = 1e-3;

    /// <summary>Takes a step, or halves its length if it is too inaccurate.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="step">The length to try, in s; it changes with the error.</param>
    /// <param name="left">The time that is left, in s.</param>
    /// <param name="longest">The longest step, in s.</param>
    /// <param name="log">Receives the segments and events.</param>
    /// <param name="trial">A log for the trial steps.</param>
    /// <exception cref="InvalidOperationException">A force is too stiff for any step.</exception>
    public static void Take(Simulator simulator, ref BallState state, ref double step, double left, double longest, StepLog log, StepLog trial)
    {
        double shortest = longest * Shortest;
        double length = Math.Min(step, left);

        // Try the step on copies first, and take the real step only once it is short enough.
        double difference = Difference(simulator, in state, length, trial);
        if (difference > Tolerance && length > shortest)
        {
            step = 0.5 * length;
            return;
        }

        // Even the shortest step is too inaccurate, or the result is NaN.
        if (!(difference <= Lost))
        {
            throw new InvalidOperationException(FormattableString.Invariant(
                $"forces.customForces is too stiff for a look-ahead at {state.Time} s, even in steps of {shortest} s. Use a weaker force, or a lookAhead.timeStep of at most {SimulatorExtensions.LongestOwnStep} s, which is never divided."));
        }

        simulator.Advance(ref state, length, log);

        // The error is far below the tolerance: double the next step, up to the requested length.
        if (difference < Plenty * Tolerance)
        {
            step = Math.Min(2.0 * step, longest);
        }
    }

    /// <summary>Returns the difference between a step and its two halves, in m.</summary>
    private static double Difference(Simulator simulator, in BallState state, double length, StepLog trial)
    {
        BallState whole = state;
        BallState halves = state;
        trial.Clear();
        simulator.Step(ref whole, length, trial);
        simulator.Step(ref halves, 0.5 * length, trial);
        simulator.Step(ref halves, 0.5 * length, trial);
        double place = Vector3d.Distance(whole.Position, halves.Position);

        // Convert the velocity error to a position error, because it soon becomes one.
        double velocity = VelocityTime * Vector3d.Distance(whole.Velocity, halves.Velocity);
        return place > velocity ? place : velocity;
    }
}
