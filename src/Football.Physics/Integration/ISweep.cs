namespace FootballPhysics.Integration;

/// <summary>A step that can be repeated from the same start with another length, to find events within it.</summary>
internal interface ISweep
{
    /// <summary>The length of the last step, in s.</summary>
    double Length { get; }

    /// <summary>The position of the centre at the end, in m.</summary>
    Vector3d Position { get; }

    /// <summary>The velocity at the end, in m/s.</summary>
    Vector3d Velocity { get; }

    /// <summary>The acceleration at the start, in m/s².</summary>
    Vector3d StartAcceleration { get; }

    /// <summary>The number of evaluations so far.</summary>
    int Evaluations { get; set; }

    /// <summary>Repeats the step with another length.</summary>
    void Step(double h);

    /// <summary>Moves the end by a tiny time, with the acceleration estimated from the step.</summary>
    void Nudge(double dt);

    /// <summary>Returns the acceleration at the end, in m/s²; one evaluation.</summary>
    Vector3d EndAcceleration();

    /// <summary>Moves the ball to the end of the step: position, velocity, spin and orientation.</summary>
    void MoveTo(ref BallState s);
}
