namespace FootballPhysics.Scenarios;

/// <summary>The laws and numbers of a scenario where it does not say otherwise.</summary>
public enum Profile
{
    /// <summary>Those of wind tunnels, filmed flights and test rigs: what the library has by default.</summary>
    Measured,

    /// <summary>Those of the thesis that the library began with, as published.</summary>
    Published,
}
