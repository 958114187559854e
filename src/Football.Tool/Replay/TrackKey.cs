namespace FootballPhysics.Tool.Replay;

/// <summary>
/// A ball at an instant between which and the next its path is the cubic through places and velocities; at an impact the velocity
/// before it and after it differ.
/// </summary>
internal readonly record struct TrackKey(
    double Time, Vector3d Position, Vector3d VelocityBefore, Vector3d Velocity, Vector3d Spin, Quaterniond Orientation, MotionState Motion);
