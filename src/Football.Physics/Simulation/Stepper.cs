namespace FootballPhysics;

/// <summary>
/// Advances ball states in one scene with one method. Nothing of it changes, so many balls and threads can share it; but where a game moves bodies, or an engine
/// is asked for its colliders, it keeps what it has found of those.
/// </summary>
internal abstract class Stepper
{
    /// <summary>All that can be met where there is more than a level pitch; else null.</summary>
    public abstract World World { get; }

    /// <summary>True when a ball at rest may be woken without a kick: then each of its steps checks whether it is still held.</summary>
    public abstract bool MayWake { get; }

    /// <summary>True when a ball without a motion of its own stays where it is.</summary>
    public abstract bool RestsAt(in BallState s);

    /// <summary>What a ball of a pile does by itself.</summary>
    public abstract PilePhase Pile { get; }

    /// <summary>Advances a state by dt, events and all.</summary>
    public abstract void Step(ref BallState state, double dt, StepLog log);

    /// <summary>Sets a ball that is placed on a surface sliding or rolling, where it touches something slowly enough.</summary>
    public abstract void Settle(ref BallState s);

    /// <summary>Another ball has hit the ball, which goes on by what carries it.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="velocity">Its velocity by the impact, m/s.</param>
    /// <param name="spin">Its spin by the impact, rad/s.</param>
    /// <param name="n">Normal of the contact, towards the ball.</param>
    /// <param name="log">Where events go.</param>
    public abstract void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log);

    /// <summary>The ball was moved straight to where it is, by another one that it overlapped: it meets nets, and comes through goals, on that way too.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="from">Where it was, m.</param>
    /// <param name="log">Where events go.</param>
    public abstract void Displaced(ref BallState s, in Vector3d from, StepLog log);

    /// <summary>True when a flight from one place to another can have met nothing that stands still but level ground, however it bent.</summary>
    /// <param name="from">Where it started, m.</param>
    /// <param name="to">Where it ended, m.</param>
    /// <param name="duration">How long it took, s; above 0.</param>
    /// <param name="airSpeed">Speed through the air at its start, m/s.</param>
    /// <param name="spinRate">Spin at its start, rad/s.</param>
    public abstract bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate);

    /// <summary>True when what a state says of the way ahead of it can be so: that it meets nothing until a time.</summary>
    public abstract bool MayBeClear(in BallState s);

    /// <summary>The factors of the aerodynamic laws at a speed and a spin: a = −drag · u + lift · (ω̂ × u), |ω|˙ = −decay.</summary>
    public abstract void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay);
}
