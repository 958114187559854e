using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <content>The forces on a ball, for display.</content>
public sealed partial class Simulator
{
    /// <summary>The usual step of a game, in s.</summary>
    internal const double UsualStep = 1.0 / 60.0;

    /// <summary>Computes the forces of the first evaluation of a ball's next step: for arrows in an editor, overlays and teaching.</summary>
    /// <remarks>
    /// The phases of a step choose the equations and evaluate them on a copy of the ball. Nothing changes: not the ball, not the bodies, and not the next step. A call allocates, and costs
    /// about as much as a step. Other balls of a group are not included.
    /// </remarks>
    /// <param name="state">The ball.</param>
    /// <param name="dt">The length of the next step, in s; 0 … 1e12, above 0. Default 1/60. It matters only for a ball that is about to stop, or on a carrier that jumps.</param>
    /// <returns>The forces; null if the step begins with an impact, or solves the contacts of the ball by impulses, or if the contacts of a ball at rest do not determine their forces.</returns>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range, or a body was moved for a time more than 0.25 s from the ball's time.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite; the message names it.</exception>
    public BallForces? ForcesAt(in BallState state, double dt = UsualStep)
    {
        BallState.Launched(in state);
        Check.Within(nameof(dt), dt, 0, Limits.Time, exclusiveLow: true);
        _world.Bodies?.CheckTimes(state.Time);
        return _stepper.ForcesAt(in state, dt, Scene);
    }
}
