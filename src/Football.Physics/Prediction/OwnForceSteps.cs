namespace FootballPhysics.Prediction;

/// <summary>Looks ahead through forces of a game's own, which may be stiffer than air, in steps that follow them.</summary>
/// <remarks>Step doubling: a step is taken once whole and once in halves, and halved until the two agree.</remarks>
internal static class OwnForceSteps
{
    /// <summary>By how much a step and its halves may differ, m; and m/s times the length of a tenth of a second.</summary>
    private const double Tolerance = 1e-6;
    private const double VelocityTime = 0.1;

    /// <summary>A difference below this share of the tolerance makes the next step twice as long: that of RK4 grows by 2⁵.</summary>
    private const double Plenty = 1.0 / 64.0;

    /// <summary>The first step, s, and the share of the longest one below which none goes.</summary>
    private const double FirstStep = 0.005;
    private const double Shortest = 1e-5;

    /// <summary>A difference in the shortest step that is too large to go on, m.</summary>
    private const double Lost = 1e-3;

    /// <summary>Advances a ball to a time, or to what ends the look-ahead.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="request">How far to look, and the longest step.</param>
    /// <param name="log">Where the pieces and events go.</param>
    /// <param name="trial">For steps that are taken to compare.</param>
    /// <exception cref="InvalidOperationException">A force is too stiff for any step.</exception>
    public static void Run(Simulator simulator, ref BallState state, LookAheadRequest request, StepLog log, StepLog trial)
    {
        double shortest = request.TimeStep * Shortest;
        double end = state.Time + request.Duration;

        // An end that is reached to rounding is reached: no last step of nothing.
        double last = end - (1e-9 * request.TimeStep);
        double step = Math.Min(FirstStep, request.TimeStep);
        log.Halted = false;
        log.StopAt = request.StopAt;
        while (state.Time < last && !log.Halted && !simulator.StaysAtRest(in state))
        {
            double length = Math.Min(step, end - state.Time);

            // Tried on copies first: the step is made once it is known to be short enough.
            double difference = Difference(simulator, in state, length, trial);
            if (difference > Tolerance && length > shortest)
            {
                step = 0.5 * length;
                continue;
            }

            // Not even the shortest follows, or what comes out is no number.
            if (!(difference <= Lost))
            {
                throw new InvalidOperationException(FormattableString.Invariant(
                    $"forces.customForces is too stiff for a look-ahead at {state.Time} s, even in steps of {shortest} s. Use a weaker force, or a lookAhead.timeStep of at most {SimulatorExtensions.LongestOwnStep} s, which is never divided."));
            }

            simulator.Advance(ref state, length, log);

            // Far below the tolerance: the next is tried twice as long, up to what was asked for.
            if (difference < Plenty * Tolerance)
            {
                step = Math.Min(2.0 * step, request.TimeStep);
            }
        }
    }

    /// <summary>How far a step is from the same in halves, m.</summary>
    private static double Difference(Simulator simulator, in BallState state, double length, StepLog trial)
    {
        BallState whole = state;
        BallState halves = state;
        trial.Clear();
        simulator.Step(ref whole, length, trial);
        simulator.Step(ref halves, 0.5 * length, trial);
        simulator.Step(ref halves, 0.5 * length, trial);
        double place = Vector3d.Distance(whole.Position, halves.Position);

        // A velocity that is off would soon be a place that is off.
        double velocity = VelocityTime * Vector3d.Distance(whole.Velocity, halves.Velocity);
        return place > velocity ? place : velocity;
    }
}
