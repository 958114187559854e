using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>The forces on a ball per mass, without weight, buoyancy and contacts, m/s².</summary>
internal struct ForceShares
{
    /// <summary>−D u.</summary>
    public Vector3d Drag;

    /// <summary>L (ω × u).</summary>
    public Vector3d Lift;

    /// <summary>The knuckle force.</summary>
    public Vector3d Side;

    /// <summary>The custom forces.</summary>
    public Vector3d Own;

    /// <summary>The nets.</summary>
    public Vector3d Nets;

    /// <summary>Their sum.</summary>
    public readonly Vector3d Sum => Drag + Lift + Side + Own + Nets;

    /// <summary>Splits the forces of the air, and the custom forces.</summary>
    /// <param name="around">The scene.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="motion">The motion of the ball.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="orientation">Its orientation, for the knuckle force.</param>
    public static unsafe ForceShares Of(Surroundings around, DragBranch branch, MotionState motion, double time, in Motion at, in Quaterniond orientation = default)
    {
        ForceTrace trace = default;
        trace.Begin(around.Radius);
        var free = new FreeForces(around, branch, motion, time, in at, &trace, in orientation);
        Vector3d own = trace.Count > 0 ? trace.ForceAt(0) : Vector3d.Zero;
        return new ForceShares
        {
            Drag = -free.Air.Drag * free.Air.AirVelocity,
            Lift = free.Air.Lift * Vector3d.Cross(at.Spin, in free.Air.AirVelocity),
            Side = free.Air.Acceleration - own,
            Own = own,
        };
    }

    /// <summary>Returns the weighted mean of two sets of forces.</summary>
    public static ForceShares Mean(double share, in ForceShares first, in ForceShares second) => new()
    {
        Drag = second.Drag + (share * (first.Drag - second.Drag)),
        Lift = second.Lift + (share * (first.Lift - second.Lift)),
        Side = second.Side + (share * (first.Side - second.Side)),
        Own = second.Own + (share * (first.Own - second.Own)),
    };

    /// <summary>Keeps the forces that act on a supported ball: without the air if it does not act there, and only along the surface if it adds no load.</summary>
    /// <param name="world">The scene.</param>
    /// <param name="normal">The normal of the surface; zero if none supports the ball.</param>
    /// <param name="rests">True for a ball at rest.</param>
    public void Support(World world, in Vector3d normal, bool rests)
    {
        if (!world.AirActs || (rests && !world.SharesAir))
        {
            (Drag, Lift) = (Vector3d.Zero, Vector3d.Zero);
        }

        if (!world.AirLoads)
        {
            Drag = SurfaceSystem.Tangential(in Drag, in normal);
            Lift = SurfaceSystem.Tangential(in Lift, in normal);
            Own = SurfaceSystem.Tangential(in Own, in normal);
        }
    }
}
