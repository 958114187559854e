namespace FootballPhysics;

/// <summary>The motion over a step that can be taken again, from the same start, with another length: to find what happens inside it, and when.</summary>
internal interface ISweep
{
    /// <summary>Length of the step as it was last taken, s.</summary>
    double Length { get; }

    /// <summary>Where the centre is at the end, m.</summary>
    Vector3d Position { get; }

    /// <summary>Velocity at the end, m/s.</summary>
    Vector3d Velocity { get; }

    /// <summary>Acceleration at the start, m/s².</summary>
    Vector3d StartAcceleration { get; }

    /// <summary>Right-hand sides evaluated so far.</summary>
    int Evaluations { get; set; }

    /// <summary>Takes the step with another length.</summary>
    void Step(double h);

    /// <summary>Moves the end by a tiny time, with the acceleration that the step itself shows.</summary>
    void Nudge(double dt);

    /// <summary>Acceleration at the end, m/s²; one evaluation.</summary>
    Vector3d EndAcceleration();

    /// <summary>Moves the ball to the end: place, velocity, spin and orientation.</summary>
    void MoveTo(ref BallState s);
}
