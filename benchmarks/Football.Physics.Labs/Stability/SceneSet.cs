using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability;

/// <summary>Scenes that are a function of their numbers, and the claims that hold in them.</summary>
internal abstract class SceneSet
{
    public abstract string Name { get; }

    /// <summary>The number of scenes of a run by default, and of a full run.</summary>
    public abstract long ByDefault { get; }

    public virtual long Full => 1_000_000;

    /// <summary>The number of the first scene.</summary>
    public virtual long First => 0;

    /// <summary>Simulates a scene and checks it.</summary>
    public abstract StressOutcome Play(long scene);

    /// <summary>Adds the tables of one scene.</summary>
    public abstract void Show(long scene, StressOutcome outcome, Terminal terminal, LabReport report);

    /// <summary>Adds the tables of many scenes.</summary>
    public abstract void Show(StressResults results, long count, LabReport report);
}
