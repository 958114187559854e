namespace FootballPhysics.Native;

/// <summary>How the end of a run changes with its launch. Matrices by rows: the row is the component of the place, the column that of the launch.</summary>
internal unsafe struct NativeDerivatives
{
    /// <summary>The place at the end by the velocity of the launch, s; at an event the place is that at the event, whose time moves too.</summary>
    public fixed double PositionByVelocity[9];

    /// <summary>The place at the end by the spin of the launch, m s/rad.</summary>
    public fixed double PositionBySpin[9];

    /// <summary>The velocity at the end, before the event there, by the velocity of the launch.</summary>
    public fixed double VelocityByVelocity[9];

    /// <summary>The velocity at the end, before the event there, by the spin of the launch, m/rad.</summary>
    public fixed double VelocityBySpin[9];

    /// <summary>The time of the end by the velocity of the launch, s^2/m; zero where its time ended the run.</summary>
    public fixed double TimeByVelocity[3];

    /// <summary>The time of the end by the spin of the launch, s^2/rad; zero where its time ended the run.</summary>
    public fixed double TimeBySpin[3];
}
