namespace Football.Physics;

/// <summary>A motion on the flat ground that a step can advance: it gives the rates at any instant.</summary>
internal interface IPlanarSystem
{
    /// <summary>v̇ and ω̇.</summary>
    void Rates(double time, in PlanarMotion at, out PlanarRates rates);

    /// <summary>Moves the ball to the end of a step, orientation and all.</summary>
    void Move(ref BallState s, in PlanarStep step);
}
