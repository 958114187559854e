namespace Football.Physics;

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
