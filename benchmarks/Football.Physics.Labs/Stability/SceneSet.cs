using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability;

/// <summary>Scenes that follow from their numbers, and the claims that hold in them.</summary>
internal abstract class SceneSet
{
    public abstract string Name { get; }

    /// <summary>How many scenes a run has by default, and in full.</summary>
    public abstract long ByDefault { get; }

    public virtual long Full => 1_000_000;

    /// <summary>The number of the first scene.</summary>
    public virtual long First => 0;

    /// <summary>Simulates a scene and checks it.</summary>
    public abstract StressOutcome Play(long scene);

    /// <summary>The tables of one scene.</summary>
    public abstract void Show(long scene, StressOutcome outcome, Terminal terminal, LabReport report);

    /// <summary>The tables of many scenes.</summary>
    public abstract void Show(StressResults results, long count, LabReport report);
}
