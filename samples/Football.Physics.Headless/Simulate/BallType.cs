namespace Football.Physics.Headless.Simulate;

/// <summary>Balls by name: the presets of <see cref="BallProperties"/>, whose Football is the generic one.</summary>
internal enum BallType
{
    Generic,
    Tango12,
    Teamgeist,
    Jabulani,
    Brazuca,
    YouthFootball,
    Futsal,
    BeachBall,
    MedicineBall,
}
