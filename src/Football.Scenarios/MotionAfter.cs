namespace FootballPhysics.Scenarios;

/// <summary>Determines the motion of the ball after an event.</summary>
public static class MotionAfter
{
    /// <summary>Returns the motion after an event. A net, a goal line and a zone do not change it.</summary>
    public static MotionState Of(BallEventKind kind, MotionState before) => kind switch
    {
        BallEventKind.Impact or BallEventKind.ContactEnd => MotionState.Airborne,
        BallEventKind.Slide => MotionState.Sliding,
        BallEventKind.Roll => MotionState.Rolling,
        BallEventKind.Rest => MotionState.Rest,
        BallEventKind.Pinned => before == MotionState.Pinned ? MotionState.Airborne : MotionState.Pinned,
        BallEventKind.Net or BallEventKind.Goal or BallEventKind.EnterZone or BallEventKind.ExitZone => before,
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, null),
    };
}
