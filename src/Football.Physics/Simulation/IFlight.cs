namespace Football.Physics;

/// <summary>Takes a step of flight along a constant axis of the spin, with the fastest form of the laws that holds.</summary>
internal interface IFlight
{
    /// <inheritdoc cref="IIntegrator.Fly"/>
    void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step);
}
