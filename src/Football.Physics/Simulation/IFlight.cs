using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Takes a step of flight along a constant spin axis, with the fastest valid form of the laws.</summary>
internal interface IFlight
{
    /// <inheritdoc cref="IMotionMethod.Order"/>
    int Order { get; }

    /// <inheritdoc cref="IMotionMethod.Stages"/>
    int Stages { get; }

    /// <inheritdoc cref="IIntegrator.Fly"/>
    void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step);
}

/// <summary>Flight by RK4, regardless of the scene's integrator.</summary>
internal sealed class ClassicalFlight(Surroundings around) : IFlight
{
    public int Order { get; } = default(ClassicalRungeKutta).Order;

    public int Stages { get; } = default(ClassicalRungeKutta).Stages;

    public void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step) =>
        default(ClassicalRungeKutta).Fly(ref around.Air, in start, ref motion, in wind, branch, upward, h, out step);
}
