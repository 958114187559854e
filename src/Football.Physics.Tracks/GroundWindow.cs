namespace FootballPhysics.Tracks;

/// <summary>A time interval in which the ball slides or rolls on the ground untouched, with its resistance.</summary>
/// <remarks>The resistance is the force along the ground divided by the normal force, excluding the force of the air.</remarks>
public sealed class GroundWindow
{
    internal GroundWindow()
    {
    }

    /// <summary><see cref="MotionState.Sliding"/> or <see cref="MotionState.Rolling"/>.</summary>
    public MotionState Motion { get; internal init; }

    /// <summary>The start time, in s.</summary>
    public double StartTime { get; internal init; }

    /// <summary>The end time, in s.</summary>
    public double EndTime { get; internal init; }

    /// <summary>The number of track points in the interval.</summary>
    public int Points { get; internal init; }

    /// <summary>The speed along the ground at the midpoint, in m/s.</summary>
    public double Speed { get; internal init; }

    /// <summary>The resistance: μ_s for a sliding ball, c₀ + c₁ v for a rolling one.</summary>
    public double Resistance { get; internal init; }

    /// <summary>The standard deviation of <see cref="Resistance"/>, from the scatter of the points and the uncertainty of the air's force.</summary>
    public double StandardError { get; internal init; }
}
