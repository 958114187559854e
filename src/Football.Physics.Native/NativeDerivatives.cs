namespace FootballPhysics.Native;

/// <summary>The derivatives of the end of a run with respect to its launch. Matrices by rows: a row is a component at the end, a column one of the launch.</summary>
internal unsafe struct NativeDerivatives
{
    /// <summary>The final position by the velocity of the launch, s. At an event, it is the position at the event, whose time changes too.</summary>
    public fixed double PositionByVelocity[9];

    /// <summary>The final position by the spin of the launch, m s/rad.</summary>
    public fixed double PositionBySpin[9];

    /// <summary>The final velocity, before the event, by the velocity of the launch.</summary>
    public fixed double VelocityByVelocity[9];

    /// <summary>The final velocity, before the event, by the spin of the launch, m/rad.</summary>
    public fixed double VelocityBySpin[9];

    /// <summary>The final time by the velocity of the launch, s^2/m; zero if the time ended the run.</summary>
    public fixed double TimeByVelocity[3];

    /// <summary>The final time by the spin of the launch, s^2/rad; zero if the time ended the run.</summary>
    public fixed double TimeBySpin[3];
}
