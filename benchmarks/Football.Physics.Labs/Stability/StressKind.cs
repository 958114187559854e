namespace FootballPhysics.Labs.Stability;

/// <summary>The kinds of scene that the stress matrix has a row for.</summary>
internal enum StressKind
{
    /// <summary>Any shot: 0 to 200 m/s, spin 0 to 1000 rad/s about any axis, any allowed ground and laws, frames of 1 to 100 ms.</summary>
    AnyShot,

    /// <summary>Frames of 1 µs to 1 ms.</summary>
    ShortSteps,

    /// <summary>Frames of 0.1 to 1 s.</summary>
    LongSteps,

    /// <summary>Frames of any length, among them 0, denormal ones, and hitches of 5 s.</summary>
    IrregularFrames,

    /// <summary>Wind of 20 to 80 m/s from any side, above and below included.</summary>
    Hurricane,

    /// <summary>Launches at, on and under the ground, slow and fast.</summary>
    LaunchOnGround,

    /// <summary>Balls that graze the ground.</summary>
    Grazing,

    /// <summary>Normal restitution near 1, and the least bounce speed as low as it may be.</summary>
    BounceTrain,

    /// <summary>Spin without travel, in the air and on the ground.</summary>
    SpinWithoutTravel,

    /// <summary>Spin along the flight.</summary>
    GyroSpin,

    /// <summary>Shots at the drag law's jump, where it has sliding modes.</summary>
    SlidingMode,

    /// <summary>Balls that must come to rest within a stated time.</summary>
    ComesToRest,

    /// <summary>Numbers far outside football: no mass, no size, no gravity, gravity of 1e6, air like mercury.</summary>
    Absurd,
}
