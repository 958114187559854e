namespace FootballPhysics.Benchmarks;

/// <summary>A profile of air and ground.</summary>
public enum Profile
{
    /// <summary>The default profile: <c>new Scene()</c>.</summary>
    Default = 0,

    /// <summary>The thesis' profile.</summary>
    Published = 1,
}
