namespace FootballPhysics.Labs.Stability;

/// <summary>One cell of the stress matrix: a method and a kind of scene.</summary>
internal sealed class StressCell
{
    /// <summary>Failures that are kept with their scene.</summary>
    public const int Kept = 5;

    public long Scenes { get; private set; }

    public long Failed { get; private set; }

    public long Steps { get; private set; }

    public long Frames { get; private set; }

    public long Stalled { get; private set; }

    public long Impacts { get; private set; }

    /// <summary>The highest share of the energy that the method may make in a frame that it has made.</summary>
    public double EnergyShare { get; private set; }

    /// <summary>The first failures: number of the scene, and what was wrong.</summary>
    public List<(long Index, StressFailure Failure)> Failures { get; } = [];

    public string Verdict => Scenes == 0 ? "-" : Failed == 0 ? "holds" : $"{Failed} FAILED";

    public void Add(long index, in StressOutcome outcome)
    {
        Scenes++;
        Steps += outcome.Steps;
        Frames += outcome.Frames;
        Stalled += outcome.Stalled;
        Impacts += outcome.Impacts;
        EnergyShare = Math.Max(EnergyShare, outcome.EnergyShare);
        if (outcome.Failure is not null)
        {
            Failed++;
            if (Failures.Count < Kept)
            {
                Failures.Add((index, outcome.Failure));
            }
        }
    }
}
