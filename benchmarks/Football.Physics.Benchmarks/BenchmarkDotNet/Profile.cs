namespace FootballPhysics.Benchmarks;

/// <summary>A profile of air and ground.</summary>
public enum Profile
{
    /// <summary>What everybody gets: <c>new Scene()</c>.</summary>
    Default = 0,

    /// <summary>The thesis' own.</summary>
    Published = 1,
}
