using FootballPhysics.Integration;

namespace FootballPhysics.Laws;

/// <summary>A sweep that also tracks the surfaces at which the drag law jumps.</summary>
internal interface IFlowSweep : ISweep
{
    /// <summary>The surface functions at the start.</summary>
    DragJump StartJump { get; }

    /// <summary>The rates of the surface functions at the start.</summary>
    DragJump StartJumpRate { get; }

    /// <summary>The surface functions at the end.</summary>
    DragJump EndJump { get; }

    /// <summary>Returns the rates of the surface functions at the end; one evaluation.</summary>
    DragJump EndJumpRate();
}

/// <summary>The flow past the ball at one instant: the input of the aerodynamic laws, computed once per evaluation.</summary>
internal struct AirFlow
{
    /// <summary>|u|², m²/s².</summary>
    public double SpeedSquared;

    /// <summary>|u|, m/s.</summary>
    public double Speed;

    /// <summary>|ω|, rad/s; at least 0.</summary>
    public double SpinRate;

    /// <summary>|ω̂ × u|², in m²/s². The spin across the motion is |ω| |ω̂ × û|.</summary>
    public double AcrossSquared;

    /// <summary>The spin parameter Sp = r|ω|/|u|. Set only if a law uses the fitted C_D.</summary>
    public double SpinParameter;

    /// <summary>The fitted C_D. Set only if a law uses it.</summary>
    public double FittedDragCoefficient;
}
