namespace Football.Physics;

/// <summary>A ball's motion that a general step can advance: it knows what the end of a step makes of the ball.</summary>
internal interface IMotionSystem : IMotionRates
{
    /// <summary>Moves the ball to the end of a step, orientation and all.</summary>
    /// <param name="s">The ball at the step's start.</param>
    /// <param name="from">Where the step started.</param>
    /// <param name="step">The step.</param>
    void Move(ref BallState s, in Motion from, in MotionStep step);
}
