namespace FootballPhysics.Aiming;

/// <summary>A dribbling touch: a running player pushes the ball on, to have it before him when he is there.</summary>
public sealed record DribbleRequest
{
    /// <summary>Where the player is at the touch, m; components within ±1e6. Its height does not count.</summary>
    public Vector3d Position { get; init; }

    /// <summary>Which way he runs from the touch on; any length but zero over the ground.</summary>
    public Vector3d Direction { get; init; } = new(0, 0, -1);

    /// <summary>How fast he runs, m/s. 0 … 15; default 5.</summary>
    public double RunSpeed { get; init; } = 5;

    /// <summary>When he wants the ball, s after the touch. 0.05 … 5; default 0.5.</summary>
    public double Duration { get; init; } = 0.5;

    /// <summary>How far before him he wants it then, m. 0 … 10; default 0.6.</summary>
    public double Lead { get; init; } = 0.6;

    /// <summary>How far from there it may be, m; above 0. Default 0.1.</summary>
    public double Tolerance { get; init; } = 0.1;

    /// <summary>How far a touch with errors may bring it from there and still have come off, m; above 0. Default 0.5.</summary>
    public double SuccessRadius { get; init; } = 0.5;

    /// <summary>Where he wants the ball, m over the ground.</summary>
    internal Vector3d Wanted => Position + (((RunSpeed * Duration) + Lead) * Heading);

    /// <summary>Which way he runs, of length 1.</summary>
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

/// <summary>A trap: the foot takes the ball's speed, and leaves it dead, or rolling with the player.</summary>
public sealed record TrapRequest
{
    /// <summary>Velocity of the player over the ground, m/s; speed at most 15. Default he stands, and the ball is dead.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>When the ball is to have settled, s after the touch. 0.05 … 5; default 0.5.</summary>
    public double Duration { get; init; } = 0.5;

    /// <summary>How fast it may be then against the player, m/s; above 0. Default 0.3.</summary>
    public double Tolerance { get; init; } = 0.3;

    /// <summary>How fast a touch with errors may leave it and still have come off, m/s; above 0. Default 1.</summary>
    public double SuccessSpeed { get; init; } = 1;

    internal void Validate()
    {
        Check.Size("trap.velocity", Velocity, 15, "m/s");
        Check.Within("trap.duration", Duration, 0.05, 5);
        Check.Positive("trap.tolerance", Tolerance);
        Check.Positive("trap.successSpeed", SuccessSpeed);
    }
}

/// <summary>A first-time shot: the moving ball is struck to a target, as it comes.</summary>
public sealed record FirstTimeRequest
{
    /// <summary>The target, m; components within ±1e6. There is none by default.</summary>
    public Vector3d Target { get; init; } = new(double.NaN, double.NaN, double.NaN);

    /// <summary>Speed of the ball after the touch, m/s; less where the foot cannot give as much. 0.5 … 60; default 25.</summary>
    public double Speed { get; init; } = 25;

    /// <summary>Topspin that the ball is to get, rad/s; as much of it as the foot can give. −200 … 200; default 0.</summary>
    public double TopSpin { get; init; }

    /// <summary>Sidespin that the ball is to get, rad/s; as much of it as the foot can give. −200 … 200; default 0.</summary>
    public double SideSpin { get; init; }

    /// <summary>Greatest elevation of the shot, degrees. 0 … 80; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>Which of the two kicks of one speed that reach a target. Default the low one.</summary>
    public AimArc Arc { get; init; } = AimArc.Low;

    /// <summary>How far from the target the ball may pass, m; above 0. Default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>How far from it a touch with errors may pass and still have come off, m; above 0. Default 0.5.</summary>
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

/// <summary>How much the foot of a player errs: normally distributed, independent errors of its velocity and of where it touches. Evidence: guess.</summary>
public sealed record TouchSpread
{
    /// <summary>Standard deviation of the foot's speed, % of it. 0 … 100; default 4.</summary>
    public double SpeedPercent { get; init; } = 4;

    /// <summary>Standard deviation of its direction, degrees, each way. 0 … 45; default 2.</summary>
    public double DirectionDegrees { get; init; } = 2;

    /// <summary>Standard deviation of the point where it touches the ball, m, each way. 0 … 0.1; default 0.005.</summary>
    public double Contact { get; init; } = 0.005;

    /// <summary>How many touches with errors are tried for <see cref="Touch.Chance"/>; 0 for none. 0 … 100 000; default 64.</summary>
    public int Draws { get; init; } = 64;

    internal void Validate()
    {
        Check.Within("spread.speedPercent", SpeedPercent, 0, 100);
        Check.Within("spread.directionDegrees", DirectionDegrees, 0, 45);
        Check.Within("spread.contact", Contact, 0, 0.1);
        Check.Within("spread.draws", Draws, 0, 100_000);
    }
}
