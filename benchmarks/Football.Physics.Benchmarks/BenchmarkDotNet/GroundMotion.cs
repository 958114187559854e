namespace FootballPhysics.Benchmarks;

/// <summary>The motions of a ball on the ground.</summary>
public enum GroundMotion
{
    Sliding = 0,
    Rolling = 1,
    Stopped = 2,
}
