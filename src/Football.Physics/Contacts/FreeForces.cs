using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>The forces on a ball without contacts and nets, at one instant: weight, air and custom forces; per mass, or per moment of inertia.</summary>
/// <remarks>
/// The scene's ground decides how much of the air acts on a supported ball (<see cref="GroundAerodynamics"/>): all of it, shared with the spin of a
/// roll; the part along the surface; or nothing.
/// </remarks>
internal unsafe struct FreeForces
{
    /// <summary>The air and the custom forces.</summary>
    public AirFactors Air;

    /// <summary>|ω|, rad/s; 0 if the laws of the air treat the ball as not spinning.</summary>
    public readonly double SpinRate;
    private readonly Surroundings _around;
    private readonly Vector3d _spin;

    /// <param name="around">The scene.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="motion">The motion, for custom forces and for the knuckle force, which acts only in flight.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="trace">Receives the custom forces; null if nobody needs them.</param>
    /// <param name="orientation">The orientation at the start of the step, for the knuckle force.</param>
    public FreeForces(
        Surroundings around, DragBranch branch, MotionState motion, double time, in Motion at, ForceTrace* trace = null, in Quaterniond orientation = default)
    {
        _around = around;
        _spin = at.Spin;
        Vector3d u = at.Velocity - around.Wind;
        SpinRate = around.Air.Varies
            ? around.Air.Evaluate(
                new ForceContext(
                    time, in at.Position, in at.Velocity, in u, in at.Spin, motion, at.AirDistance, around.Air.HasSide ? orientation.Turned(in at.Turn) : default),
                branch, out Air, trace)
            : around.Air.OfLaws(in u, in at.Spin, branch, out Air);
    }

    /// <summary>The rates in flight.</summary>
    public readonly MotionRates InFlight => Air.Rates(in _spin, in _around.Weight, _around.Air.Varies);

    /// <summary>a_air = L (ω × u) − D u, m/s².</summary>
    public readonly Vector3d Flow => (Air.Lift * Vector3d.Cross(in _spin, in Air.AirVelocity)) - (Air.Drag * Air.AirVelocity);

    /// <summary>The acceleration of a supported ball by the air and custom forces, before its normal part is removed, m/s².</summary>
    public readonly Vector3d Push => _around.World.AirActs ? Air.Acceleration + Flow : Air.Acceleration;

    /// <summary>The torques, rad/s².</summary>
    public readonly Vector3d Torque => (-Air.Decay * _spin) + Air.SpinAcceleration;

    /// <summary>The acceleration of a ball that rests on a surface, m/s². If the spin does not share the air's force, no air wakes the ball.</summary>
    public readonly Vector3d AtRest => _around.World.SharesAir ? Push + _around.Weight : Air.Acceleration + _around.Weight;

    /// <summary>Returns the rates of a supported ball.</summary>
    /// <param name="normal">The normal of the surface that supports it; zero if none does.</param>
    /// <param name="rolls">Whether it rolls on that surface.</param>
    public readonly MotionRates Supported(in Vector3d normal, bool rolls)
    {
        Vector3d push = _around.World.AirLoads ? Push : SurfaceSystem.Tangential(Push, in normal);
        Vector3d torque = Torque;
        if (rolls && !_around.World.SharesAir)
        {
            // If the spin does not share the air's force, the air accelerates a rolling ball directly and the spin
            // follows: ω̇_t = n × a_air/r.
            Vector3d along = SurfaceSystem.Tangential(in push, in normal);
            torque = (Vector3d.Dot(in torque, in normal) * normal) + (Vector3d.Cross(in normal, in along) / _around.Radius);
        }

        return new MotionRates(push + _around.Weight, in torque, Air.AirSpeed);
    }
}
