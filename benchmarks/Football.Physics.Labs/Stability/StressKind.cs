namespace FootballPhysics.Labs.Stability;

/// <summary>The kinds of scenes, which are the rows of the stress matrix.</summary>
internal enum StressKind
{
    /// <summary>Any shot: 0 to 200 m/s, spin 0 to 1000 rad/s about any axis, any allowed ground and laws, frames of 1 to 100 ms.</summary>
    AnyShot,

    /// <summary>Frames of 1 µs to 1 ms.</summary>
    ShortSteps,

    /// <summary>Frames of 0.1 to 1 s.</summary>
    LongSteps,

    /// <summary>Frames of any length, including 0, denormal lengths, and hitches of 5 s.</summary>
    IrregularFrames,

    /// <summary>Wind of 20 to 80 m/s from any direction, including from above and below.</summary>
    Hurricane,

    /// <summary>Launches at, on and under the ground, slow and fast.</summary>
    LaunchOnGround,

    /// <summary>Balls that graze the ground.</summary>
    Grazing,

    /// <summary>Normal restitution near 1, and the minimum bounce speed as low as allowed.</summary>
    BounceTrain,

    /// <summary>Spin without travel, in the air and on the ground.</summary>
    SpinWithoutTravel,

    /// <summary>Spin along the flight.</summary>
    GyroSpin,

    /// <summary>Shots at the drag law's jump, which has sliding modes.</summary>
    SlidingMode,

    /// <summary>Balls that must come to rest within a stated time.</summary>
    ComesToRest,

    /// <summary>Numbers far outside football: zero mass, zero size, zero gravity, gravity of 1e6, air like mercury.</summary>
    Absurd,
}
