namespace FootballPhysics.Integration;

/// <summary>A step of order 8, for custom forces that the scene's integrator does not follow.</summary>
internal readonly struct EighthOrder : IMotionMethod
{
    public int Stages => HighOrder.Eighth.Stages;

    public double LastStage => 1;

    /// <summary>The order of its path, which follows from the ends of a step.</summary>
    public int Order => default(ClassicalRungeKutta).Order;

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem => HighOrder.Eighth.Advance(ref system, time, in from, in start, h, turnsByStages: true, out step);
}
