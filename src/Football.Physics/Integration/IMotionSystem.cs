namespace FootballPhysics;

/// <summary>A motion that a general step can advance: it gives the rates at any instant.</summary>
internal interface IMotionSystem
{
    /// <summary>v̇ and ω̇.</summary>
    void Rates(double time, in Motion at, out MotionRates rates);

    /// <summary>How long a part of a step may be that <see cref="Substeps"/> takes, s; infinite where nothing asks for parts.</summary>
    /// <param name="at">Where the part starts.</param>
    /// <param name="jerk">|ȧ| there, m/s³; infinite where it is not known.</param>
    double LongestPart(in Motion at, double jerk);

    /// <summary>Moves the ball to the end of a step, orientation and all.</summary>
    /// <param name="s">The ball at the step's start.</param>
    /// <param name="from">Where the step started.</param>
    /// <param name="step">The step.</param>
    void Move(ref BallState s, in Motion from, in MotionStep step);
}

/// <summary>Where a general step ends, and the rates at its start.</summary>
internal struct MotionStep
{
    /// <summary>The motion at the end.</summary>
    public Motion End;

    /// <summary>Rotation vector of the step, rad.</summary>
    public Vector3d Rotation;

    /// <summary>Rates at the start.</summary>
    public MotionRates StartRates;
}
