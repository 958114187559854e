namespace Football.Physics;

/// <summary>The air of a scene, asked point by point.</summary>
internal interface IAir : IFlightAir
{
    /// <summary>The laws alone.</summary>
    AirLaws Laws { get; }

    /// <summary>Whether drag acts.</summary>
    bool Drags { get; }

    /// <summary>Whether the Magnus force acts.</summary>
    bool Lifts { get; }

    /// <summary>Whether spin decays.</summary>
    bool SpinDecays { get; }

    /// <summary>
    /// Whether the laws depend on place or time, or on more than drag, lift and spin decay: then flight is integrated as any motion is, and asks
    /// <see cref="Evaluate"/> alone.
    /// </summary>
    bool Varies { get; }

    /// <summary>Whether torques that are not along the spin may act, so that flight has no constant axis.</summary>
    bool TurnsAxis { get; }

    /// <summary>How fast the air can change the motion, by the speed relative to the air.</summary>
    RateBound Bound { get; }

    /// <summary>A speed that the wind by place and time nowhere exceeds, m/s; 0 where it is steady.</summary>
    double FastestWind { get; }

    /// <summary>What the air, and a game's own forces, do at one instant, whatever the motion.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="factors">What the air does.</param>
    /// <returns>|ω|, rad/s; 0 where it is too small for a reciprocal.</returns>
    double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors);
}
