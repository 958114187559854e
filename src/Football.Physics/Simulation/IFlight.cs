namespace FootballPhysics;

/// <summary>Takes a step of flight along a constant axis of the spin, with the fastest form of the laws that holds.</summary>
internal interface IFlight
{
    /// <inheritdoc cref="IIntegrator.Fly"/>
    void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step);
}

/// <summary>Flight by RK4, whatever the method of the scene is.</summary>
internal sealed class ClassicalFlight(Surroundings around) : IFlight
{
    public void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step) =>
        default(ClassicalRungeKutta).Fly(ref around.Air, in start, ref motion, in wind, branch, upward, h, out step);
}
