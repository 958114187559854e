namespace Football.Physics.Aiming;

/// <content>The kick that arrives with a given speed.</content>
public sealed partial class Aimer
{
    /// <summary>Halvings of the speed of the kick, after which it is known to a micrometre a second.</summary>
    private const int ArrivalHalvings = 40;
    private const double ArrivalStep = 0.02;
    private const double ArrivalCloseness = 1e-9;

    /// <summary>Finds the kick that is at a target with a given speed.</summary>
    /// <param name="request">What the kick is to do; its speed is the fastest allowed. Without a point on the way.</param>
    /// <param name="speed">How fast the ball is to be at the target, m/s; above 0, at most 1000.</param>
    /// <returns>
    /// The kick, with its speed in its velocity; out of reach where the slowest kick that gets there is faster at the target, or the fastest one slower.
    /// </returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a point on the way is given.</exception>
    public AimResult FindAtSpeed(AimRequest request, double speed)
    {
        Check.Given(nameof(request), request);
        Check.Within("aim.arrival.speed", speed, 0, Limits.Speed, exclusiveLow: true);
        AimResult slow = FindSlowest(request);
        AimResult fast = Find(request);
        if (slow.Status != AimStatus.Hit || fast.Status != AimStatus.Hit)
        {
            return fast;
        }

        // The faster the kick, the faster it arrives: the root lies between the slowest and the fastest that hit.
        double low = slow.Speed;
        double high = request.Speed;
        double atLow = SpeedAt(request, in slow) - speed;
        double atHigh = SpeedAt(request, in fast) - speed;

        // The wanted speed lies outside of what both give.
        if (!(atLow <= 0 && atHigh >= 0))
        {
            return Failed(atLow > 0 ? slow : fast, AimStatus.OutOfReach);
        }

        AimResult best = atHigh < -atLow ? fast : slow;
        for (int i = 0; i < ArrivalHalvings && high - low > ArrivalCloseness; i++)
        {
            // The secant, kept off both ends so that the bracket shrinks from both.
            double share = Math.Min(0.9, Math.Max(0.1, atLow / (atLow - atHigh)));
            double middle = low + (share * (high - low));
            AimResult found = Find(request with { Speed = middle });
            if (found.Status != AimStatus.Hit)
            {
                return Failed(in found, AimStatus.NotConverged);
            }

            best = found;
            double off = SpeedAt(request, in found) - speed;
            if (Math.Abs(off) < ArrivalCloseness)
            {
                break;
            }

            // The bracket keeps its signs: too slow below, too fast above.
            if (off < 0)
            {
                low = middle;
                atLow = off;
            }
            else
            {
                high = middle;
                atHigh = off;
            }
        }

        return best;
    }

    /// <summary>How fast a kick is at its target, m/s.</summary>
    private double SpeedAt(AimRequest request, in AimResult kick)
    {
        Simulator simulator = Context.Game;
        BallState state = simulator.Launch(request.From, kick.Velocity, kick.Spin);
        simulator.RunChecked(ref state, ArrivalStep, Math.Max(kick.Time, 1e-9), StopAt.Time, new StepLog(), null);
        return state.Velocity.Length;
    }

    private static AimResult Failed(in AimResult kick, AimStatus status) => new(
        status, kick.Velocity, kick.Spin, new MeasuredMiss(kick.Miss, kick.ThroughMiss, kick.Time, kick.Closest), kick.Arc, kick.Rolls, kick.Iterations, kick.Simulations, kick.BlockedBy);
}
