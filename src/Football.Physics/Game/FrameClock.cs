namespace FootballPhysics.Game;

/// <summary>The clock of a runner: divides frame times into fixed steps, and drops what exceeds a limit.</summary>
internal sealed class FrameClock(double timeStep, double maximumFrameTime)
{
    private double _left;

    /// <summary>The length of a step, in s.</summary>
    public double TimeStep { get; } = timeStep;

    /// <summary>The maximum simulated time per frame, in s.</summary>
    public double MaximumFrameTime { get; } = maximumFrameTime;

    /// <summary>The time dropped from the last frame, in s.</summary>
    public double DroppedTime { get; private set; }

    /// <summary>The total time dropped from all frames, in s.</summary>
    public double TotalDroppedTime { get; private set; }

    /// <summary>The part of a step that is left for the next frame, 0 … 1.</summary>
    public double Fraction => _left / TimeStep;

    /// <summary>True if the remaining time contains a whole step.</summary>
    public bool HasStep => _left >= TimeStep;

    /// <summary>Adds the time of a frame, up to the limit.</summary>
    public void Add(double frameTime)
    {
        double counted = frameTime < MaximumFrameTime ? frameTime : MaximumFrameTime;
        DroppedTime = frameTime - counted;
        TotalDroppedTime += DroppedTime;
        _left += counted;
    }

    /// <summary>Subtracts a step that was taken.</summary>
    public void Subtract() => _left -= TimeStep;

    /// <summary>Drops the whole steps from the remaining time.</summary>
    public void DropSteps()
    {
        double dropped = Math.Floor(_left / TimeStep) * TimeStep;
        _left = Math.Max(0, _left - dropped);
        DroppedTime += dropped;
        TotalDroppedTime += dropped;
    }
}
