using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A dribbling touch: a running player pushes the ball ahead, and reaches it again later.</summary>
public sealed record DribbleRequest
{
    /// <summary>The position of the player at the touch, in m; components within ±1e6. Its height is ignored.</summary>
    public Vector3d Position { get; init; }

    /// <summary>The direction in which he runs after the touch; its horizontal part must not be zero.</summary>
    public Vector3d Direction { get; init; } = new(0, 0, -1);

    /// <summary>His running speed, in m/s. 0 … 15; default 5.</summary>
    public double RunSpeed { get; init; } = 5;

    /// <summary>The time after the touch at which he plans to reach the ball, in s. 0.05 … 5; default 0.5.</summary>
    public double Duration { get; init; } = 0.5;

    /// <summary>The distance by which the ball is ahead of the player after <see cref="Duration"/>, in m. 0 … 10; default 0.6.</summary>
    public double Lead { get; init; } = 0.6;

    /// <summary>The tolerance of the ball's position, in m; above 0. Default 0.1.</summary>
    public double Tolerance { get; init; } = 0.1;

    /// <summary>The maximum position error at which an inaccurate touch still succeeds, in m; above 0. Default 0.5.</summary>
    public double SuccessRadius { get; init; } = 0.5;

    /// <summary>The target position of the ball, on the ground, in m.</summary>
    internal Vector3d BallTarget => Position + (((RunSpeed * Duration) + Lead) * Heading);

    /// <summary>The unit vector in which he runs.</summary>
    internal Vector3d Heading => Check.Direction("dribble.direction", Direction.Horizontal);

    internal void Validate()
    {
        Check.Place("dribble.position", Position);
        Check.Direction("dribble.direction", Direction.Horizontal);
        Check.Within("dribble.runSpeed", RunSpeed, 0, 15);
        Check.Within("dribble.duration", Duration, 0.05, 5);
        Check.Within("dribble.lead", Lead, 0, 10);
        Check.Positive("dribble.tolerance", Tolerance);
        Check.Positive("dribble.successRadius", SuccessRadius);
    }
}

/// <summary>A trap: the foot stops the ball, or leaves it rolling with the player.</summary>
public sealed record TrapRequest
{
    /// <summary>The horizontal velocity of the player, in m/s; speed at most 15. Default 0: the ball is stopped dead.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>The time at which the ball must have settled, in s after the touch. 0.05 … 5; default 0.5.</summary>
    public double Duration { get; init; } = 0.5;

    /// <summary>The maximum speed of the settled ball relative to the player, in m/s; above 0. Default 0.3.</summary>
    public double Tolerance { get; init; } = 0.3;

    /// <summary>The maximum speed of the ball relative to the player at which an inaccurate trap still succeeds, in m/s; above 0. Default 1.</summary>
    public double SuccessSpeed { get; init; } = 1;

    internal void Validate()
    {
        Check.Size("trap.velocity", Velocity, 15, "m/s");
        Check.Within("trap.duration", Duration, 0.05, 5);
        Check.Positive("trap.tolerance", Tolerance);
        Check.Positive("trap.successSpeed", SuccessSpeed);
    }
}

/// <summary>A first-time shot: a moving ball is struck at a target without being trapped first.</summary>
public sealed record FirstTimeRequest
{
    /// <summary>The target, in m; components within ±1e6. Required: the default is NaN.</summary>
    public Vector3d Target { get; init; } = new(double.NaN, double.NaN, double.NaN);

    /// <summary>The speed of the ball after the touch, in m/s. 0.5 … 60; default 25.</summary>
    /// <remarks>The shot is slower if the foot cannot give this speed.</remarks>
    public double Speed { get; init; } = 25;

    /// <summary>The requested topspin, in rad/s; the foot gives as much of it as it can. −200 … 200; default 0.</summary>
    public double TopSpin { get; init; }

    /// <summary>The requested sidespin, in rad/s; the foot gives as much of it as it can. −200 … 200; default 0.</summary>
    public double SideSpin { get; init; }

    /// <summary>The maximum elevation of the shot, in degrees. 0 … 80; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>The choice between the two kicks at this speed that reach a target. Default: the low one.</summary>
    public AimArc Arc { get; init; } = AimArc.Low;

    /// <summary>The maximum distance by which a kick may miss the target, in m; above 0. Default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>The maximum distance from the target at which an inaccurate shot still succeeds, in m; above 0. Default 0.5.</summary>
    public double SuccessRadius { get; init; } = 0.5;

    internal void Validate()
    {
        Check.Place("firstTime.target", Target);
        Check.Within("firstTime.speed", Speed, 0.5, 60);
        Check.Within("firstTime.topSpin", TopSpin, -200, 200);
        Check.Within("firstTime.sideSpin", SideSpin, -200, 200);
        Check.Within("firstTime.maximumElevationDegrees", MaximumElevationDegrees, 0, 80);
        Check.Positive("firstTime.tolerance", Tolerance);
        Check.Positive("firstTime.within", SuccessRadius);
    }
}

/// <summary>The errors of a player's foot in velocity and point of contact: independent and normally distributed.</summary>
/// <remarks>The default values are guesses.</remarks>
public sealed class TouchSpread
{
    /// <summary>The standard deviation of the foot's speed, in %. 0 … 100; default 4.</summary>
    public double SpeedPercent { get; init; } = 4;

    /// <summary>The standard deviation of the foot's direction about each of two axes, in degrees. 0 … 45; default 2.</summary>
    public double DirectionDegrees { get; init; } = 2;

    /// <summary>The standard deviation of the point of contact on each axis, in m. 0 … 0.1; default 0.005.</summary>
    public double Contact { get; init; } = 0.005;

    /// <summary>The number of random touches for <see cref="Touch.Chance"/>; 0 skips the estimate. 0 … 100 000; default 64.</summary>
    public int Draws { get; init; } = 64;

    internal void Validate()
    {
        Check.Within("spread.speedPercent", SpeedPercent, 0, 100);
        Check.Within("spread.directionDegrees", DirectionDegrees, 0, 45);
        Check.Within("spread.contact", Contact, 0, 0.1);
        Check.Within("spread.draws", Draws, 0, 100_000);
    }
}
