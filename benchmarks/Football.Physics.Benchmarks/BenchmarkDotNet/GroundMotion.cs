namespace FootballPhysics.Benchmarks;

/// <summary>What a ball on the ground is doing.</summary>
public enum GroundMotion
{
    Sliding = 0,
    Rolling = 1,
    Stopped = 2,
}
