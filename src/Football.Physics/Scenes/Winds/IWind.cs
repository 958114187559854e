namespace FootballPhysics.Laws;

/// <summary>A wind that varies with position and time.</summary>
/// <remarks>
/// The result must be finite and a smooth function of the arguments alone. The simulator calls it several times per step, at times between frames.
/// If equal arguments give different results, rollbacks and look-aheads diverge from the game.
/// </remarks>
public interface IWind
{
    /// <summary>The maximum wind speed anywhere, at any time, in m/s; at most 1000.</summary>
    double MaximumSpeed { get; }

    /// <summary>Returns the velocity of the air, in m/s.</summary>
    /// <param name="time">The time since the launch, in s.</param>
    /// <param name="position">The position, in m.</param>
    Vector3d At(double time, in Vector3d position);
}
