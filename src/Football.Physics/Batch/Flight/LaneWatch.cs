namespace Football.Physics;

/// <summary>Is shown a group of balls in flight after every step.</summary>
internal abstract class LaneWatch
{
    /// <summary>Called after every step, with the balls that still fly.</summary>
    /// <param name="group">The group; its state now is that at the step's end.</param>
    /// <param name="time">Time since the launches, s.</param>
    public abstract void Step(LaneGroup group, double time);
}
