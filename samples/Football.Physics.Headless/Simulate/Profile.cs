namespace Football.Physics.Headless.Simulate;

/// <summary>Whose laws and numbers a scenario has where it does not say otherwise.</summary>
internal enum Profile
{
    /// <summary>The thesis'.</summary>
    Published,

    /// <summary>Those of wind tunnels, filmed flights and test rigs.</summary>
    Measured,
}
