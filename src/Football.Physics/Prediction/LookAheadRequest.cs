using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>The duration, step and stop conditions of a look-ahead.</summary>
/// <remarks>The look-ahead ends at the first condition that is met.</remarks>
public sealed record LookAheadRequest
{
    /// <summary>The maximum duration, in s. Above 0, at most 1e12; default 10.</summary>
    public double Duration { get; init; } = 10;

    /// <summary>The length of a step, in s. Above 0, at least 1e-12 of the duration; default 0.08.</summary>
    /// <remarks>
    /// With RK4, the default is accurate to a few micrometres. Where a custom force is too stiff for the step, the simulator divides it, as in the game
    /// (see <see cref="IForce"/>). With the game's own integrator and step, the prediction is bit-identical to the later simulation.
    /// </remarks>
    public double TimeStep { get; init; } = 0.08;

    /// <summary>The event that ends the look-ahead. Default <see cref="StopAt.Rest"/>.</summary>
    public StopAt StopAt { get; init; } = StopAt.Rest;

    /// <summary>A plane whose crossing ends the look-ahead; default none.</summary>
    public Plane3d? UntilPlane { get; init; }

    /// <summary>A point that ends the look-ahead once the ball has passed it; default none.</summary>
    /// <remarks>
    /// The ball has passed the point when its horizontal distance from the point grows after the minimum, and wind, spin and obstacles cannot bring it back.
    /// </remarks>
    public Vector3d? UntilPassing { get; init; }

    /// <summary>The callback that positions the game's bodies for a given time, in s; default null: bodies keep their motion.</summary>
    /// <remarks>The callback moves the bodies (<see cref="Scene.Bodies"/>). It is called with the start time and after every step; the bodies are restored
    /// after the look-ahead.</remarks>
    public Action<double>? MoveBodies { get; init; }

    /// <summary>Throws if the ball's clock is too large for a step to change it.</summary>
    internal void CheckClock(in BallState from) => Check.Advances("lookAhead.timeStep", TimeStep, from.Time + Duration);

    internal void Validate()
    {
        Check.Within("lookAhead.duration", Duration, 0, Limits.Time, exclusiveLow: true);
        Check.Within("lookAhead.timeStep", TimeStep, 0, Limits.Time, exclusiveLow: true);

        // At most 10¹² steps.
        Check.AtLeast("lookAhead.timeStep", TimeStep, Duration * 1e-12);
        Check.Defined("lookAhead.stopAt", StopAt, (int)StopAt, 3);
        UntilPlane?.Validate("lookAhead.untilPlane");
        if (UntilPassing is { } point)
        {
            Check.Place("lookAhead.untilPassing", point);
        }
    }
}
