namespace FootballPhysics.Simulation;

/// <summary>Observes a simulation piece by piece: for exact apexes, lengths, crossings and dense paths.</summary>
/// <remarks>Set it as <see cref="StepLog.Observer"/>.</remarks>
internal abstract class PieceObserver
{
    /// <summary>True if pieces must include the acceleration at their end. Default false.</summary>
    /// <remarks>This costs one force evaluation per piece. Without it, the pieces are cubic.</remarks>
    public virtual bool WantsEndAcceleration => false;

    /// <summary>Called after every piece, before the event that may end it.</summary>
    /// <param name="piece">The piece of the path.</param>
    /// <returns>True to end the step and the run here.</returns>
    public abstract bool Add(in PathSegment piece);

    /// <summary>Called after every piece with the full state at both ends.</summary>
    /// <param name="before">The ball at the start of the piece.</param>
    /// <param name="after">The ball at the end of the piece.</param>
    /// <param name="piece">The piece.</param>
    /// <returns>The same as for <see cref="Add(in PathSegment)"/>, which the default implementation calls.</returns>
    public virtual bool Add(in BallState before, in BallState after, in PathSegment piece) => Add(in piece);
}

/// <summary>Observes the path alone: it ignores the states at the ends of a piece, and always needs the acceleration at its end.</summary>
internal abstract class PathObserver : PieceObserver
{
    public override bool WantsEndAcceleration => true;

    /// <summary>Called after a whole step of flight.</summary>
    public abstract bool AddFlight(
        Stepper stepper, in BallState end, double time, in Vector3d position, in Vector3d velocity, double spin, in Vector3d acceleration, int degree);

    /// <summary>Called before a whole step without air.</summary>
    public abstract bool AddFall(in BallState start, double h, double end, double climb, double height, double upward, int degree);
}
