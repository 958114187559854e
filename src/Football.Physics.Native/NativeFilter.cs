namespace FootballPhysics.Native;

/// <summary>A filter that follows one ball. Concurrent calls wait for each other. The pointer is a handle, not an address.</summary>
internal struct NativeFilter
{
}

/// <summary>The filter of a handle.</summary>
internal sealed class FollowedBall(BallFilter filter) : Handled
{
    public BallFilter Filter { get; } = filter;

    /// <summary>The path of the last look-ahead.</summary>
    public Trajectory Path { get; } = new();
}
