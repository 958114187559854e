namespace Football.Physics;

/// <summary>
/// The air of a scene: its aerodynamic laws, composed into one model that is chosen once. The model is defined by its laws, asked point
/// by point; where it has a faster form of them for a step of flight, it takes that form in <see cref="Fly"/>.
/// </summary>
internal interface IAir : IFlightKernel<PointStep>
{
    /// <summary>Whether the drag coefficient jumps, so that a step is locked to a branch and ends where the branch does. A fact of the type.</summary>
    bool Jumps { get; }

    /// <summary>
    /// Whether the laws depend on place or time, or on more than drag, lift and spin decay: then flight is integrated as any motion is, and asks
    /// <see cref="Evaluate"/> alone. A fact of the type.
    /// </summary>
    bool Varies { get; }

    /// <summary>Whether torques that are not along the spin may act, so that flight has no constant axis. A fact of the type.</summary>
    bool TurnsAxis { get; }

    /// <summary>How fast the air can change the motion, by the speed relative to the air.</summary>
    RateBound Bound { get; }

    /// <summary>A speed that the wind by place and time nowhere exceeds, m/s; 0 where it is steady.</summary>
    double FastestWind { get; }

    /// <summary>Whether the fastest form of the laws holds along a step from here; where there is but one form it always does.</summary>
    /// <param name="speedSquared">|u|² at its start, m²/s².</param>
    /// <param name="spinRate">|ω| there, rad/s.</param>
    /// <param name="h">Length of the step, s.</param>
    bool Covers(double speedSquared, double spinRate, double h);

    /// <summary>Up to which length, s, no step that is covered changes the motion too much to be taken whole, whatever its speed and spin; 0 where that is not known.</summary>
    /// <param name="bound">How fast the air and all else can change the motion.</param>
    double WholeUpTo(in RateBound bound);

    /// <summary>What the air does at one instant, whatever the motion.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="factors">What the air does.</param>
    /// <returns>|ω|, rad/s; 0 where it is too small for a reciprocal.</returns>
    double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors);

    /// <summary>Takes a step of flight along a constant axis of the spin, with the fastest form of the laws that holds.</summary>
    /// <param name="integrator">The one-step method.</param>
    /// <param name="covered">What <see cref="Covers"/> says of the step.</param>
    /// <param name="speedSquared">|u|² at its start, m²/s².</param>
    /// <param name="motion">Velocity and spin; moved to the end of the step.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="branch">Branch of the drag law that the step is locked to.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="step">What it did.</param>
    void Fly<TIntegrator>(
        ref TIntegrator integrator,
        bool covered,
        double speedSquared,
        ref FlightMotion motion,
        in Vector3d wind,
        DragBranch branch,
        double upward,
        double h,
        out FlightStep step)
        where TIntegrator : struct, IIntegrator;
}
