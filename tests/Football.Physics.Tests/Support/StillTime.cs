namespace FootballPhysics.Tests.Support;

/// <summary>A clock that stands: nothing becomes due, however busy the machine is.</summary>
internal sealed class StillTime : TimeProvider
{
    public override long GetTimestamp() => 0;
}
