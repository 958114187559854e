namespace FootballPhysics.Scenarios;

/// <summary>The state of a ball at an instant, for the results.</summary>
public readonly record struct Moment(
    double Time, MotionState State, Vector3d Position, Vector3d Velocity, Vector3d Spin, Quaterniond Orientation)
{
    public bool IsFinite => double.IsFinite(Time) && Position.IsFinite && Velocity.IsFinite && Spin.IsFinite && Orientation.IsFinite;

    public static Moment Of(in BallState state) => new(state.Time, state.Motion, state.Position, state.Velocity, state.Spin, state.Orientation);
}
