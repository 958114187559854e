using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Steps balls in one scene with one integrator.</summary>
/// <remarks>
/// It is immutable, so many balls and threads can share it. With moving bodies or an engine, it also caches the results of their queries,
/// and only one thread may use it.
/// </remarks>
internal abstract class Stepper
{
    protected Stepper(Surroundings around)
    {
        Around = around;
        World = around.World;
    }

    /// <summary>The colliders, nets and goals of the scene.</summary>
    public World World { get; }

    /// <summary>True if a ball at rest may wake without a kick, so that each of its steps must check that it is still held.</summary>
    public abstract bool MayWake { get; }

    /// <summary>True if a ball with zero relative velocity stays at its position.</summary>
    public abstract bool RestsAt(in BallState s);

    /// <summary>Steps a single ball of a pile.</summary>
    public abstract PilePhase Pile { get; }

    /// <summary>The forces that act on a ball anywhere in the scene.</summary>
    protected Surroundings Around { get; }

    /// <summary>Advances a state by dt, including events.</summary>
    public abstract void Step(ref BallState state, double dt, StepLog log);

    /// <summary>Sets a placed ball sliding or rolling if it touches a surface slowly enough.</summary>
    public abstract void Settle(ref BallState s);

    /// <summary>Sets the state of a ball after an impact with another ball.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="velocity">Its velocity after the impact, m/s.</param>
    /// <param name="spin">Its spin after the impact, rad/s.</param>
    /// <param name="n">Normal of the contact, towards the ball.</param>
    /// <param name="log">Receives the events.</param>
    public abstract void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log);

    /// <summary>True if no flight between two positions, however curved, can reach a stationary object other than level ground.</summary>
    /// <param name="from">Start position, m.</param>
    /// <param name="to">End position, m.</param>
    /// <param name="duration">Duration, s; above 0.</param>
    /// <param name="airSpeed">Air speed at the start, m/s.</param>
    /// <param name="spinRate">Spin at the start, rad/s.</param>
    public abstract bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate);

    /// <summary>Returns an upper bound of the distance from its straight path at which a ball searches for bodies in a step, m.</summary>
    /// <param name="speed">Its greatest speed, m/s.</param>
    /// <param name="spinRate">Its greatest spin, rad/s.</param>
    /// <param name="dt">Length of the step, s.</param>
    public abstract double SearchMargin(double speed, double spinRate, double dt);

    /// <summary>True if the clear time stored in a state is plausible.</summary>
    public abstract bool MayBeClear(in BallState s);

    /// <summary>Returns the factors of the air laws at a speed and a spin: a = −drag · u + lift · (ω̂ × u), |ω|˙ = −decay.</summary>
    public abstract void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay);

    /// <summary>Returns the forces of the first evaluation of a step.</summary>
    /// <param name="state">The ball; not changed.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="scene">The scene.</param>
    /// <returns>The forces; null if the step begins with impulses.</returns>
    public abstract BallForces? ForcesAt(in BallState state, double dt, Scene scene);

    /// <summary>Computes the acceleration at the end of a whole step of flight.</summary>
    /// <param name="s">The ball at the end of the step.</param>
    /// <param name="h">The length of the step, in s.</param>
    /// <param name="acceleration">The acceleration, m/s².</param>
    public abstract void EndAcceleration(in BallState s, double h, out Vector3d acceleration);
}
