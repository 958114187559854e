namespace FootballPhysics;

/// <summary>A sweep that also follows the surfaces at which the drag law jumps.</summary>
internal interface IFlowSweep : ISweep
{
    /// <summary>The surfaces' functions at the start.</summary>
    DragJump StartJump { get; }

    /// <summary>Their rates at the start.</summary>
    DragJump StartJumpRate { get; }

    /// <summary>The surfaces' functions at the end.</summary>
    DragJump EndJump { get; }

    /// <summary>Their rates at the end; one evaluation.</summary>
    DragJump EndJumpRate();
}

/// <summary>The flow past the ball at one instant: what the aerodynamic laws may depend on, computed once an evaluation.</summary>
internal struct AirFlow
{
    /// <summary>|u|², m²/s².</summary>
    public double SpeedSquared;

    /// <summary>|u|, m/s.</summary>
    public double Speed;

    /// <summary>|ω|, rad/s, not negative.</summary>
    public double SpinRate;

    /// <summary>|ω̂ × u|², m²/s²: the spin across the motion is |ω| |ω̂ × û|.</summary>
    public double AcrossSquared;

    /// <summary>Spin parameter Sp = r|ω|/|u|. Only where a law reads the fitted C_D.</summary>
    public double SpinParameter;

    /// <summary>The fitted C_D. Only where a law reads it.</summary>
    public double FittedDragCoefficient;
}
