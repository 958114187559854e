namespace Football.Physics;

/// <summary>What must hold where a runner meets the ball.</summary>
internal enum MeetingCondition
{
    /// <summary>(D + ρ)² − |p − c|² ≥ 0, over the ground.</summary>
    Near = 0,

    /// <summary>y − h₀ ≥ 0.</summary>
    NotTooLow = 1,

    /// <summary>h₁ − y ≥ 0.</summary>
    NotTooHigh = 2,
}
