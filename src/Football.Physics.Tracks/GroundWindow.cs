namespace FootballPhysics.Tracks;

/// <summary>A time in which the ball slides or rolls on the ground and nobody touches it, with the resistance of the ground: the force along the ground by the normal force, the air's share subtracted.</summary>
public sealed record GroundWindow
{
    /// <summary><see cref="MotionState.Sliding"/> or <see cref="MotionState.Rolling"/>.</summary>
    public MotionState Motion { get; init; }

    /// <summary>The time at which it begins, s.</summary>
    public double StartTime { get; init; }

    /// <summary>The time at which it ends, s.</summary>
    public double EndTime { get; init; }

    /// <summary>Number of points of the track in it.</summary>
    public int Points { get; init; }

    /// <summary>Speed along the ground in its middle, m/s.</summary>
    public double Speed { get; init; }

    /// <summary>Resistance: μ_s of a ball that slides, c₀ + c₁ v of one that rolls.</summary>
    public double Resistance { get; init; }

    /// <summary>Standard deviation of <see cref="Resistance"/>, from the scatter of the points and a share of the air's force.</summary>
    public double StandardError { get; init; }
}
