namespace Football.Physics;

/// <summary>Advances ball states in one scene with one method. Immutable, so many balls and threads can share it.</summary>
internal abstract class Stepper
{
    /// <summary>Advances a state by dt, events and all.</summary>
    public abstract void Step(ref BallState state, double dt, StepLog log);

    /// <summary>Lets a ball that is placed in a world begin carried, where it touches something slowly enough.</summary>
    public abstract void Settle(ref BallState s);

    /// <summary>The factors of the aerodynamic laws at a speed and a spin: a = −drag · u + lift · (ω̂ × u).</summary>
    public abstract void AirFactors(double speed, double spinRate, out double drag, out double lift);
}
