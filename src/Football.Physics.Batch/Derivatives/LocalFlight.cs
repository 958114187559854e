using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Batch;

/// <summary>The motion along a segment of flight: the same equations as in a step, on the same branch of the drag law.</summary>
internal sealed class LocalFlight(Surroundings around)
{
    private readonly Surroundings _around = around;
    private FlightSystem _flight;

    /// <summary>The branch of the drag law.</summary>
    public DragBranch Branch => _flight.Branch;

    /// <summary>True for plain flight: a constant axis of the spin, steady air, and no other forces.</summary>
    public bool IsPlain { get; private set; }

    /// <summary>Sets the ball.</summary>
    public void Take(in BallState s)
    {
        Motion at = MotionVector.Of(in s);
        _flight = new FlightSystem
        {
            Around = _around,
            Branch = s.Branch != DragBranch.Unknown || !_around.Air.Jumps ? s.Branch : DragJump.At(in at, in _around.Wind, _around.Radius).Branch,
        };
        IsPlain = s.Motion == MotionState.Airborne && s.Nets == 0 && !_around.Air.Varies && Branch < DragBranch.AlongCriticalSpeed
            && !ContactSet.TouchesMore(_around.World, in s, -1);
    }

    /// <summary>Computes v̇ and ω̇.</summary>
    public void Rates(double time, in Motion at, out MotionRates rates) => _flight.Rates(time, in at, out rates);
}
