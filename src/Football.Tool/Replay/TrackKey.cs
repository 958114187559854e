namespace FootballPhysics.Tool.Replay;

/// <summary>
/// The state of a ball at a time. Between two keys, the path is the cubic through their positions and velocities. At an impact, the velocities before
/// and after it differ.
/// </summary>
internal readonly record struct TrackKey(
    double Time, Vector3d Position, Vector3d VelocityBefore, Vector3d Velocity, Vector3d Spin, Quaterniond Orientation, MotionState Motion);
