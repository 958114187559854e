namespace FootballPhysics.Laws;

/// <summary>A custom force that states how fast it changes the motion of the ball.</summary>
/// <remarks>
/// A simulator also follows a stiff <see cref="IForce"/>: it notices that a step is too long and repeats it in parts. A stated stiffness saves this first attempt. It also
/// bounds the parts, so that none passes a narrow force, such as a cord or a thin layer of water, without noticing it.
/// </remarks>
public interface IStiffForce : IForce
{
    /// <summary>The greatest rate at which the force changes the motion, in 1/s; 0 … 1e6. 0: not known.</summary>
    /// <remarks>
    /// For a spring of k N/m it is √(k/m), for a damping of c N s/m it is c/m, with the mass m of the ball. For a force that acts in a layer of width d, it is v/d, with the
    /// greatest speed v of the ball. Parts of a step are at most 1/stiffness long. It must be constant; a scene is compiled once.
    /// </remarks>
    double Stiffness { get; }
}
