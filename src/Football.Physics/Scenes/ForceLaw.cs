namespace FootballPhysics;

/// <summary>The law of a force or torque.</summary>
public enum ForceLaw
{
    /// <summary>The force does not act, and costs nothing.</summary>
    None = 0,

    /// <summary>The coefficient is constant; its value is in <see cref="ForceSet"/>.</summary>
    Constant = 1,

    /// <summary>The coefficient follows a fit to measurements.</summary>
    Empirical = 2,
}
