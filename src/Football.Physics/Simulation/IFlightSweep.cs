namespace Football.Physics;

/// <summary>A sweep of flight: along a constant axis of the spin, or of the whole motion.</summary>
internal interface IFlightSweep : IFlowSweep
{
    /// <summary>Place, velocity and spin at the end.</summary>
    Motion EndMotion { get; }
}
