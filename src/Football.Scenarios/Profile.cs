namespace FootballPhysics.Scenarios;

/// <summary>The default laws and numbers of a scenario.</summary>
public enum Profile
{
    /// <summary>Those measured in wind tunnels, in filmed flights and on test rigs; the default of the library.</summary>
    Measured,

    /// <summary>Those published in the thesis from which the library started.</summary>
    Published,
}
