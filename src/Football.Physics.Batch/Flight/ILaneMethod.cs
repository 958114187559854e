using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>The integrator for which a flight in lanes is specialized.</summary>
internal interface ILaneMethod
{
    /// <summary>The number of stages: 4 for classical Runge–Kutta, 2 for the midpoint method.</summary>
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
    /// <summary>The component along the lanes' x, in m/s².</summary>
    public readonly float AlongX;

    /// <summary>The component along the lanes' y, in m/s².</summary>
    public readonly float AlongY;

    /// <param name="scene">The scene.</param>
    /// <param name="upAlongX">True if up is the lanes' x, false for y.</param>
    public LaneWeight(Scene scene, bool upAlongX)
    {
        double up = Weight.UpwardAcceleration(scene);
        AlongX = upAlongX ? (float)up : 0f;
        AlongY = upAlongX ? 0f : (float)up;
    }
}

/// <summary>Observes a group of balls in flight after every step.</summary>
internal abstract class LaneWatch
{
    /// <summary>Called after every step, with the balls that are still in flight.</summary>
    /// <param name="group">The group; <see cref="LaneGroup.Now"/> is the state at the end of the step.</param>
    /// <param name="time">The time since the launches, in s.</param>
    public abstract void Step(LaneGroup group, double time);
}
