namespace FootballPhysics.Yardsticks;

/// <summary>The laws of the plain yardstick.</summary>
public enum PlainLawKind
{
    Published = 0,
    Regularised = 1,
    Constant = 2,
    Vacuum = 3,
}
