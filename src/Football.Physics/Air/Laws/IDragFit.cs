namespace Football.Physics;

/// <summary>A form of the fitted drag coefficient.</summary>
internal interface IDragFit
{
    /// <summary>Whether the coefficient jumps, so that a step must be locked to a branch.</summary>
    bool Jumps { get; }

    /// <summary>C_D of a flow whose speed, spin rate and spin parameter are known.</summary>
    double Coefficient(in AirFlow flow, DragBranch branch);
}
