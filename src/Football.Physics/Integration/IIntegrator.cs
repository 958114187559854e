namespace FootballPhysics;

/// <summary>A one-step method. A new one is one new file that implements this, and a name in <see cref="Integrator"/>.</summary>
internal interface IIntegrator
{
    /// <summary>Right-hand sides a step.</summary>
    int Stages { get; }

    /// <summary>True if the last stage is at the end of the step.</summary>
    bool LastStageAtEnd { get; }

    /// <summary>Order of accuracy.</summary>
    int Order { get; }

    /// <summary>c in p + h (v + c h a), the path under a constant acceleration.</summary>
    double ShareInPath { get; }

    /// <summary>True when the method comes down from a hop faster than it went up, so that hops must be taken in parts. A fact of the type.</summary>
    bool GainsByHops { get; }

    /// <summary>A step in flight, where the axis of the spin is constant.</summary>
    /// <param name="air">The air.</param>
    /// <param name="start">The ball at the start: place, time and distance flown, which air that varies asks for.</param>
    /// <param name="motion">Velocity and spin; moved to the end of the step.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="branch">Branch of the drag law that the step is locked to.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="step">What it did.</param>
    void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws;

    /// <summary>A step of any motion: in flight with forces of the game's own.</summary>
    /// <param name="system">Gives the rates.</param>
    /// <param name="time">Time at the start, s.</param>
    /// <param name="from">Where the step starts.</param>
    /// <param name="start">The rates there: the first stage.</param>
    /// <param name="h">Its length, s.</param>
    /// <param name="step">Where it ends.</param>
    void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem;
}
