namespace FootballPhysics.Laws;

/// <summary>Wind by place and time.</summary>
/// <remarks>
/// A smooth function of its arguments alone, and finite: it is asked several times a step, at points between frames, and must answer the
/// same whenever it is asked the same, or rollback and look-ahead part from the game.
/// </remarks>
public interface IWind
{
    /// <summary>A speed, m/s, that this wind nowhere and never exceeds; at most 1000.</summary>
    double MaximumSpeed { get; }

    /// <summary>Velocity of the air, m/s.</summary>
    /// <param name="time">Time since the launch, s.</param>
    /// <param name="position">The place, m.</param>
    Vector3d At(double time, in Vector3d position);
}
