using System.Runtime.CompilerServices;

namespace FootballPhysics.Integration;

/// <summary>The orientation at the end of a flight step.</summary>
internal static class StepTurn
{
    /// <summary>Turns the orientation to the end of a step, if a side force depends on it.</summary>
    /// <remarks>The integrators call it before their last stage, so that the next step does not wait for it.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Take<TAir>(ref TAir air, in BallState start, double turn, ref FlightStep step)
        where TAir : struct, IFlightLaws
    {
        if (air.HasSide)
        {
            step.Orientation = turn == 0 ? start.BaseOrientation : start.BaseOrientation.Turned(turn * start.Flight.Axis);
        }
    }
}
