namespace Football.Physics;

/// <summary>A motion that a general step can advance: it gives the rates at any instant.</summary>
internal interface IMotionSystem
{
    /// <summary>v̇ and ω̇.</summary>
    void Rates(double time, in Motion at, out MotionRates rates);

    /// <summary>Moves the ball to the end of a step, orientation and all.</summary>
    /// <param name="s">The ball at the step's start.</param>
    /// <param name="from">Where the step started.</param>
    /// <param name="step">The step.</param>
    void Move(ref BallState s, in Motion from, in MotionStep step);
}
