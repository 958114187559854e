using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Computes a ball's load on a surface: whether the ball stays after an impact, whether friction holds it, and whether the surface
/// supports it.</summary>
internal sealed class ContactLoad
{
    private readonly Surroundings _around;
    private readonly World _world;
    private readonly RateBound _ofAir;
    private readonly double _weight;

    public ContactLoad(Surroundings around)
    {
        _around = around;
        _world = around.World;
        _ofAir = around.Air.Bound;
        _weight = around.Weight.Length;
    }

    /// <summary>True if a ball that leaves a surface after an impact stays on it, because a force presses it back at once (contact.md,
    /// Impacts).</summary>
    /// <param name="s">The ball before.</param>
    /// <param name="off">w, m/s.</param>
    /// <param name="velocity">Its velocity along the surface, m/s.</param>
    /// <param name="spin">Its spin after, rad/s.</param>
    /// <param name="collider">The surface.</param>
    /// <param name="at">Distance, normal and curvature of the surface below the ball.</param>
    public bool StaysAfter(in BallState s, double off, in Vector3d velocity, in Vector3d spin, Collider collider, in ShapePoint at)
    {
        // a_b·n ≤ −|a_b|/2, with gravity and buoyancy a_b: the weight presses the ball onto surfaces of up to 60°. Other forces must bring the ball
        // back within a millisecond.
        bool byWeight = -2.0 * Vector3d.Dot(in _around.Weight, at.Normal) >= _weight && _weight > 0;
        double hop = byWeight ? ContactTolerances.ShortestHop : ContactTolerances.ShortestPressedHop;
        bool isCarriedElsewhere = s.Motion is MotionState.Rolling or MotionState.Sliding && _world.CarrierOf(in s) != collider;
        if (!byWeight && isCarriedElsewhere && off < 0.5 * hop * CarriedLoad(in s, in velocity, in spin, collider, in at))
        {
            return true;
        }

        if (!(byWeight && off < _world.MinimumBounceSpeed) && !_around.Air.Varies)
        {
            // Most impacts return here: bounds on the forces show that the ball flies, without evaluating the air.
            Vector3d along = velocity - collider.ShapeVelocity(s.Position, s.Time);
            double airSpeed = (velocity - _around.Wind).Length;
            double most = _weight + Math.Abs(Vector3d.Dot(in along, at.Curvature * along)) + (airSpeed * _ofAir.At(airSpeed, spin.Length));

            // The upper bound of |A_s·n| on a rotating surface, whose material has the acceleration A_s.
            double turns = collider.Spin.Length;
            most += turns == 0 ? 0 : turns * (((collider.MaterialVelocity(s.Position, s.Time) - collider.Velocity).Length) + (2.0 * along.Length));
            if (s.Nets == 0 && off >= 0.5 * hop * most)
            {
                return false;
            }
        }

        // A hop lasts 2 w/(N/m). If that is less than the shortest hop, the ball stays on the surface.
        double load = Load(in s, in velocity, in spin, collider, in at);
        return load > ContactTolerances.LeastLoad && (off < 0.5 * hop * load || (byWeight && off < _world.MinimumBounceSpeed));
    }

    /// <summary>Returns the speed that explicit Euler gains in a hop that has too few steps for its bounces to decay, m/s; otherwise
    /// 0.</summary>
    /// <param name="s">The ball before.</param>
    /// <param name="off">w, m/s.</param>
    /// <param name="velocity">Its velocity along the surface, m/s.</param>
    /// <param name="spin">Its spin after, rad/s.</param>
    /// <param name="collider">The surface.</param>
    /// <param name="at">Distance, normal and curvature of the surface below the ball.</param>
    /// <param name="h">Length of a step, s.</param>
    public double GainOfHop(in BallState s, double off, in Vector3d velocity, in Vector3d spin, Collider collider, in ShapePoint at, double h)
    {
        // A hop lasts 2 w/a, and gains the speed a h with steps of length h.
        double load = Load(in s, in velocity, in spin, collider, in at);
        double pieces = StabilityLimit.PiecesOfHop(collider.MaterialAt(s.Position).LargestRestitutionAt(0));
        return load > ContactTolerances.LeastLoad && 2.0 * off < pieces * h * load ? h * load : 0;
    }

    /// <summary>Returns the load N/m of a ball that keeps its carrier, m/s².</summary>
    /// <remarks>The carrier's friction may press it against the other object, such as a foot.</remarks>
    private double CarriedLoad(in BallState s, in Vector3d velocity, in Vector3d spin, Collider hit, in ShapePoint at)
    {
        Collider carrier = _world.CarrierOf(in s);
        SurfaceSystem system = System(in s, carrier);
        var motion = new Motion(s.Position, in velocity, in spin);
        system.Look(s.Time, in motion);
        Vector3d slip = system.Forces.Slip;
        system.Rolls = slip.Length < ContactTolerances.Rolling;
        system.Direction = system.Rolls ? system.Forces.Rolling : slip;
        Vector3d acceleration = system.Direction == Vector3d.Zero ? Vector3d.Zero : system.RatesAt(in motion).Acceleration;
        Vector3d along = velocity - hit.ShapeVelocity(s.Position, s.Time);
        return -Vector3d.Dot(in acceleration, at.Normal) - Vector3d.Dot(in along, at.Curvature * along);
    }

    /// <summary>True if a collider would support a ball that touches it.</summary>
    public bool IsPressed(in BallState s, int collider)
    {
        Collider on = _world.ByIndex[collider];
        ShapePoint at = on.At(s.Position, s.Time);
        return Load(in s, s.Velocity, s.Spin, on, in at) > ContactTolerances.LeastLoad;
    }

    /// <summary>True if friction can hold a ball without slip.</summary>
    public bool Grips(in BallState s, Collider carrier, ref StepRun run)
    {
        SurfaceSystem system = System(in s, carrier);
        system.ForcesOn(s.Time, new Motion(s.Position, s.Velocity, s.Spin), out SurfaceForces on);
        run.Log.Evaluations++;
        return system.Grips(in on);
    }

    /// <summary>Returns the load N/m that the ball would have if it followed the surface, m/s².</summary>
    public double Load(in BallState s, in Vector3d velocity, in Vector3d spin, Collider collider, in ShapePoint at)
    {
        // If neither the air nor a net adds to the load, the load due to the weight is sufficient.
        Vector3d along = velocity - collider.Velocity;
        double byWeight = _world.AirLoads || collider.Rotates || collider.IsNetEnd ? 0 : -Vector3d.Dot(in _around.Weight, at.Normal) - Vector3d.Dot(in along, at.Curvature * along);
        if (byWeight > ContactTolerances.LeastLoad)
        {
            return byWeight;
        }

        System(in s, collider).ForcesOn(s.Time, new Motion(s.Position, in velocity, in spin, s.AirDistance), out SurfaceForces on);
        return on.FreeLoad;
    }

    private SurfaceSystem System(in BallState s, Collider carrier) =>
        SurfaceSystem.On(_around, carrier, in s, _around.BranchAt(new Motion(s.Position, s.Velocity, s.Spin)));
}
