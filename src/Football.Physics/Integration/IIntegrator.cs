using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>A one-step method. To add one, implement this interface, and add a name to <see cref="Integrator"/> and <see cref="StepperFactory"/>.</summary>
internal interface IIntegrator : IMotionMethod
{
    /// <summary>The coefficients.</summary>
    Tableau Tableau { get; }

    /// <summary>c in p + h (v + c h a), the path under constant acceleration.</summary>
    double ShareInPath { get; }

    /// <summary>True if a hop ends faster than it began, so that hops must be split into parts. A constant of the type.</summary>
    bool GainsByHops { get; }

    /// <summary>Takes a step in flight, with a constant axis of the spin.</summary>
    /// <param name="air">The air.</param>
    /// <param name="start">The ball at the start. Air that varies uses its position, time and distance flown.</param>
    /// <param name="motion">The velocity and spin; advanced to the end of the step.</param>
    /// <param name="wind">The wind, in m/s.</param>
    /// <param name="branch">The branch of the drag law that the step is locked to.</param>
    /// <param name="upward">The upward acceleration by gravity and buoyancy, in m/s².</param>
    /// <param name="h">The length of the step, in s.</param>
    /// <param name="step">The result of the step.</param>
    void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws;
}

/// <summary>A one-step method for a general motion.</summary>
internal interface IMotionMethod
{
    /// <summary>The number of evaluations per step.</summary>
    int Stages { get; }

    /// <summary>Time of the last stage, as a share of the step.</summary>
    double LastStage { get; }

    /// <summary>The order of accuracy.</summary>
    int Order { get; }

    /// <summary>Takes a step of a general motion, on any surface, or in flight with custom forces.</summary>
    /// <param name="system">The system that computes the rates.</param>
    /// <param name="time">The time at the start, in s.</param>
    /// <param name="from">The motion at the start.</param>
    /// <param name="start">The rates at the start: the first stage.</param>
    /// <param name="h">The length of the step, in s.</param>
    /// <param name="step">The result of the step.</param>
    void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem;
}
