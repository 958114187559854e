using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Computes the forces without contacts for a part of a step with velocity-level impulses, bounded so that a part of any length does not
/// overshoot.</summary>
internal sealed unsafe class PartForces
{
    /// <summary>Maximum change of the velocity per part, m/s; no flight comes close to it.</summary>
    private const double MostSpeed = 100.0;

    /// <summary>Maximum change of the spin per part, in addition to the current spin, rad/s.</summary>
    private const double MostSpin = 1000.0;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly NetGuard _nets;

    public PartForces(Surroundings around)
    {
        _around = around;
        _world = around.World;
        _nets = new NetGuard(_world);
    }

    /// <summary>Computes the rates without contacts.</summary>
    /// <param name="s">The ball, with its nets and its carrier.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">Its position, velocity and spin.</param>
    /// <param name="isCarried">Whether a surface carries it. Only the share of the air that acts on a single surface counts then.</param>
    /// <param name="h">Length of the part, s.</param>
    public MotionRates Free(in BallState s, double time, in Motion at, bool isCarried, double h)
    {
        FreeForces free = At(time, in at, isCarried);
        return Bounded(in s, in at, in free, isCarried, h);
    }

    /// <summary>Computes the same, and reduces custom forces that are too stiff for the part.</summary>
    /// <param name="s">The ball, with its nets and its carrier.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">Its position, velocity and spin.</param>
    /// <param name="isCarried">Whether a surface carries it.</param>
    /// <param name="h">Length of the part, s.</param>
    /// <param name="change">The change of the custom forces by their own effect, as a share of them. Above 1, they were reduced: a damping then ends the
    /// motion at most, and a spring swings instead of growing.</param>
    public MotionRates FreeLimited(in BallState s, double time, in Motion at, bool isCarried, double h, out double change)
    {
        // Evaluate the custom forces again after the velocity, the displacement and the spin that they give.
        FreeForces free = At(time, in at, isCarried);
        ref AirFactors air = ref free.Air;
        Vector3d gained = h * NoMore(in air.Acceleration, MostSpeed / h);
        Vector3d spin = at.Spin + (h * NoMore(in air.SpinAcceleration, (at.Spin.Length + MostSpin) / h));
        AirFactors after = At(time, new Motion(at.Position + (h * gained), at.Velocity + gained, in spin, at.AirDistance), isCarried).Air;
        double byForce = Share(in air.Acceleration, in after.Acceleration);
        double byTorque = Share(in air.SpinAcceleration, in after.SpinAcceleration);
        air.Acceleration *= byForce > 1 ? 1.0 / byForce : 1.0;
        air.SpinAcceleration *= byTorque > 1 ? 1.0 / byTorque : 1.0;
        change = Math.Max(byForce, byTorque);
        return Bounded(in s, in at, in free, isCarried, h);
    }

    /// <summary>Computes the rates of a ball that a pile holds at zero velocity.</summary>
    /// <param name="s">The ball, with its nets and its carrier.</param>
    /// <param name="isCarried">Whether a surface carries it. If the spin does not share the air's force, no air wakes the ball then.</param>
    /// <param name="h">Length of the part, s.</param>
    public MotionRates AtRest(in BallState s, bool isCarried, double h)
    {
        var at = new Motion(s.Position, Vector3d.Zero, Vector3d.Zero, s.AirDistance);
        FreeForces free = At(s.Time, in at, isCarried);
        return isCarried ? Bounded(in s, in at, new MotionRates(free.AtRest, free.Torque), h) : Bounded(in s, in at, in free, isCarried, h);
    }

    /// <summary>Evaluates the air and the custom forces. The drag law keeps its branch at the start of the part, because its jump is not located here.</summary>
    private FreeForces At(double time, in Motion at, bool isCarried) =>
        new(_around, _around.BranchAt(in at), isCarried ? MotionState.Sliding : MotionState.Airborne, time, in at);

    private MotionRates Bounded(in BallState s, in Motion at, in FreeForces free, bool isCarried, double h)
    {
        Vector3d normal = isCarried && !_world.SharesAir ? _world.CarrierOf(in s).At(at.Position, s.Time).Normal : Vector3d.Zero;
        return Bounded(in s, in at, isCarried ? free.Supported(in normal, rolls: false) : free.InFlight, h);
    }

    /// <summary>Bounds the forces of the air and the weight, and adds the nets.</summary>
    private MotionRates Bounded(in BallState s, in Motion at, in MotionRates rates, double h)
    {
        Vector3d acceleration = NoMore(in rates.Acceleration, MostSpeed / h);
        Vector3d spinAcceleration = NoMore(in rates.SpinAcceleration, (at.Spin.Length + MostSpin) / h);
        if (s.Nets != 0)
        {
            // A net settles at the rate λ. Apply the share 1/(1 + h λ) of its push over the part h, as an implicit step would.
            MotionRates nets = _world.NetForces.Push(s.Nets, s.NetSides, null, in at);
            double share = 1.0 / (1.0 + (h * _nets.FastestRate(in s, in at.Position)));
            acceleration += share * nets.Acceleration;
            spinAcceleration += share * nets.SpinAcceleration;
        }

        return new MotionRates(in acceleration, in spinAcceleration, rates.AirSpeed);
    }

    private static double Share(in Vector3d before, in Vector3d after)
    {
        double change = (after - before).Length;
        return change == 0 ? 0 : change / before.Length;
    }

    private static Vector3d NoMore(in Vector3d vector, double most)
    {
        double size = vector.Length;
        return size > most ? most / size * vector : vector;
    }
}
