namespace Football.Scenarios;

/// <summary>Balls by name: the presets of <see cref="BallProperties"/>, whose Football is the generic one.</summary>
public enum BallType
{
    Generic,
    Tango12,
    Teamgeist,
    Jabulani,
    Brazuca,
    Telstar18,
    Flight2020,
    AlRihla,
    Fussballliebe,
    Trionda,
    Modern,
    YouthFootball,
    Futsal,
    BeachBall,
    MedicineBall,
}
