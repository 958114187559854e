namespace FootballPhysics.Yardsticks;

/// <summary>The laws that the plain yardstick is written for.</summary>
public enum PlainLawKind
{
    Published = 0,
    Regularised = 1,
    Constant = 2,
    Vacuum = 3,
}
