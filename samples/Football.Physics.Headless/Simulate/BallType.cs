namespace Football.Physics.Headless.Simulate;

/// <summary>The balls that the measured profile knows.</summary>
internal enum BallType
{
    Generic,
    Tango12,
    Teamgeist,
    Jabulani,
    Brazuca,
}
