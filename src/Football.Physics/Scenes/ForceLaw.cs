namespace FootballPhysics;

/// <summary>By which law a force or torque acts.</summary>
public enum ForceLaw
{
    /// <summary>It does not act, and costs nothing.</summary>
    None = 0,

    /// <summary>With the constant coefficient given beside it.</summary>
    Constant = 1,

    /// <summary>By the law fitted to measurements.</summary>
    Empirical = 2,
}
