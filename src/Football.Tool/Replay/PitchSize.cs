namespace FootballPhysics.Tool.Replay;

/// <summary>The sizes of a pitch according to Law 1 of the game, in m.</summary>
internal static class PitchSize
{
    public const double GoalWidth = 7.32;
    public const double PenaltyAreaHalfWidth = 20.16;
    public const double PenaltyAreaDepth = 16.5;
    public const double GoalAreaHalfWidth = 9.16;
    public const double GoalAreaDepth = 5.5;
    public const double PenaltyMark = 11;
    public const double CircleRadius = 9.15;
}
