namespace FootballPhysics.Yardsticks;

/// <summary>The thesis' state machine.</summary>
public enum ThesisState
{
    Bouncing = 0,
    Sliding = 1,
    Rolling = 2,
    Stopped = 3,
}
