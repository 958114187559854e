namespace Football.Physics;

/// <summary>What is known of the published drag law's branches when a register of balls takes a step: the common case is compiled by itself.</summary>
internal interface ILaneBranch
{
    /// <summary>Whether all balls are on the branch with spin.</summary>
    bool AllWithSpin { get; }
}

/// <summary>All balls are on the branch with spin: no call is left in the stages, and they stay in registers.</summary>
internal readonly struct LanesWithSpin : ILaneBranch
{
    public bool AllWithSpin => true;
}

/// <summary>Nothing is known.</summary>
internal readonly struct LanesOnEither : ILaneBranch
{
    public bool AllWithSpin => false;
}
