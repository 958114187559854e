namespace FootballPhysics.Batch;

/// <summary>The integrator that a flight in lanes is compiled for.</summary>
internal interface ILaneMethod
{
    /// <summary>Stages: 4 of classical Runge–Kutta, 2 of the midpoint method.</summary>
    int Stages { get; }
}

/// <summary>Midpoint Runge–Kutta.</summary>
internal readonly struct LaneRk2 : ILaneMethod
{
    public int Stages => 2;
}

/// <summary>Classical Runge–Kutta.</summary>
internal readonly struct LaneRk4 : ILaneMethod
{
    public int Stages => 4;
}

/// <summary>The acceleration by gravity and buoyancy, in float.</summary>
internal readonly struct LaneWeight
{
    /// <summary>Along the lanes' x, m/s².</summary>
    public readonly float AlongX;

    /// <summary>Along the lanes' y, m/s².</summary>
    public readonly float AlongY;

    /// <param name="scene">The scene.</param>
    /// <param name="upAlongX">Whether up is along the lanes' x, else y.</param>
    public LaneWeight(Scene scene, bool upAlongX)
    {
        double up = Weight.UpwardAcceleration(scene);
        AlongX = upAlongX ? (float)up : 0f;
        AlongY = upAlongX ? 0f : (float)up;
    }
}

/// <summary>Is shown a group of balls in flight after every step.</summary>
internal abstract class LaneWatch
{
    /// <summary>Called after every step, with the balls that still fly.</summary>
    /// <param name="group">The group; its state now is that at the step's end.</param>
    /// <param name="time">Time since the launches, s.</param>
    public abstract void Step(LaneGroup group, double time);
}
