namespace FootballPhysics.Integration;

/// <summary>A motion for general steps: it computes the rates at any instant.</summary>
internal unsafe interface IMotionSystem
{
    /// <summary>Receives the custom forces of every evaluation; null if nobody needs them.</summary>
    ForceTrace* Trace { get; set; }

    /// <summary>Computes v̇ and ω̇.</summary>
    void Rates(double time, in Motion at, out MotionRates rates);

    /// <summary>Returns the longest part that <see cref="Substeps"/> may take, in s; infinite if parts are not needed.</summary>
    /// <param name="at">The motion at the start of the part.</param>
    /// <param name="rates">Its rates.</param>
    double LongestPart(in Motion at, in MotionRates rates);

    /// <summary>Moves the ball to the end of a step, including its orientation.</summary>
    /// <param name="s">The ball at the start of the step.</param>
    /// <param name="from">The motion at the start of the step.</param>
    /// <param name="step">The step.</param>
    void Move(ref BallState s, in Motion from, in MotionStep step);
}

/// <summary>The result of a general step, and the rates at its start.</summary>
internal struct MotionStep
{
    /// <summary>The motion at the end.</summary>
    public Motion End;

    /// <summary>The rotation vector of the step, in rad.</summary>
    public Vector3d Rotation;

    /// <summary>The rates at the start.</summary>
    public MotionRates StartRates;
}
