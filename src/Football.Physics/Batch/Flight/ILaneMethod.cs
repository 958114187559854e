namespace Football.Physics;

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
