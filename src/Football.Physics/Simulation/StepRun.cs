namespace Football.Physics;

/// <summary>What is left to do of a step.</summary>
internal ref struct StepRun
{
    /// <summary>Splits at the drag law's jump that one step may have; a chattering step goes on without more.</summary>
    public const int MaximumSplits = 16;

    /// <summary>Time left, s.</summary>
    public double Left;

    /// <summary>Length of the whole step, s.</summary>
    public double Length;

    /// <summary>Splits so far.</summary>
    public int Splits;

    /// <summary>Pieces so far that relaxed to the balance of forces.</summary>
    public int Relaxed;

    /// <summary>Where events and counts go.</summary>
    public StepLog Log;
}
