namespace Football.Scenarios;

/// <summary>Balls by name: the presets of <see cref="BallProperties"/>, whose Football is the generic one.</summary>
public enum BallType
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
