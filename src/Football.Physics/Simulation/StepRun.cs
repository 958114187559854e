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

    /// <summary>When the step ends, s: the clock of its pieces never runs past it, not even by rounding.</summary>
    public double End;

    /// <summary>Splits so far.</summary>
    public int Splits;

    /// <summary>Where the step had to be divided: the length of its parts, s; else 0.</summary>
    public double Part;

    /// <summary>Pieces since the last impact.</summary>
    public int Pieces;

    /// <summary>Pieces so far that relaxed to the balance of forces.</summary>
    public int Relaxed;

    /// <summary>Where events and counts go.</summary>
    public StepLog Log;

    /// <summary>The length of the next part: what is left, or an equal share of it where the step had to be divided, s.</summary>
    public readonly double Next => Part > 0 && Left > Part ? Left / Math.Ceiling((Left / Part) - 1e-9) : Left;

    /// <summary>Keeps the length of a part that is shorter than what was asked for, s.</summary>
    public void Keep(double part, double asked) => Part = part < asked ? part : Part;
}
