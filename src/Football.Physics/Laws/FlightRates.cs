using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The right-hand side of the equations of flight, for a constant axis of the spin.</summary>
/// <remarks>m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D.</remarks>
internal static class FlightRates
{
    /// <summary>Computes the rates at one stage of a step: a = L (ω̂ × u) − D u + g + side, |ω|˙ = −decay.</summary>
    /// <param name="air">The air.</param>
    /// <param name="start">The ball at the start of the step.</param>
    /// <param name="seams">The seams at the stage; used only with a side force.</param>
    /// <param name="branch">The branch of the drag law that the step is locked to.</param>
    /// <param name="upward">The upward acceleration by gravity and buoyancy.</param>
    /// <param name="h">The time since the start of the step.</param>
    /// <param name="px">The x component of the displacement since the start.</param>
    /// <param name="py">Its y component.</param>
    /// <param name="pz">Its z component.</param>
    /// <param name="distance">The distance through the air since the start.</param>
    /// <param name="nx">The x component of the spin axis.</param>
    /// <param name="ny">Its y component.</param>
    /// <param name="nz">Its z component.</param>
    /// <param name="ux">The x component of the velocity relative to the steady wind.</param>
    /// <param name="uy">Its y component.</param>
    /// <param name="uz">Its z component.</param>
    /// <param name="spin">The magnitude of the spin.</param>
    /// <param name="ax">The x component of the acceleration.</param>
    /// <param name="ay">Its y component.</param>
    /// <param name="az">Its z component.</param>
    /// <param name="spinRate">The rate of change of the spin.</param>
    /// <param name="airSpeed">The speed relative to the air, if the air needs the distance flown; otherwise 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void At<TAir>(
        ref TAir air,
        in BallState start,
        in SeamAxes seams,
        DragBranch branch,
        double upward,
        double h,
        double px,
        double py,
        double pz,
        double distance,
        double nx,
        double ny,
        double nz,
        double ux,
        double uy,
        double uz,
        double spin,
        out double ax,
        out double ay,
        out double az,
        out double spinRate,
        out double airSpeed)
        where TAir : struct, IFlightLaws
    {
        // Add the variable wind to the steady wind.
        if (air.HasField)
        {
            Vector3d wind = air.WindAt(start.Time + h, start.Position.X + px, start.Position.Y + py, start.Position.Z + pz);
            ux -= wind.X;
            uy -= wind.Y;
            uz -= wind.Z;
        }

        // If the law does not use the part of u across the spin, the compiler removes its square.
        double cx = (ny * uz) - (nz * uy);
        double cy = (nz * ux) - (nx * uz);
        double cz = (nx * uy) - (ny * ux);
        double squared = (ux * ux) + (uy * uy) + (uz * uz);
        air.Factors(squared, spin, (cx * cx) + (cy * cy) + (cz * cz), branch, out double drag, out double lift, out double decay, out double share);

        // u is the velocity through the air; L and D are the factors of lift and drag, and g is the upward acceleration.
        // a = L (ω̂ × u) − D u + g ŷ
        ax = (lift * cx) - (drag * ux);
        ay = ((lift * cy) - (drag * uy)) + upward;
        az = (lift * cz) - (drag * uz);
        if (air.Tilts)
        {
            Vector3d sideways = air.Sideways;
            ax += sideways.X;
            az += sideways.Z;
        }

        airSpeed = 0;

        // A side force depends on the distance flown through the air and on the orientation, so integrate both with the motion.
        if (air.HasSide)
        {
            airSpeed = Math.Sqrt(squared);
            Vector3d side = air.Side(
                in seams, ux, uy, uz, 1.0 / squared, airSpeed, share, spin * spin * ((cx * cx) + (cy * cy) + (cz * cz)), start.AirDistance + distance);
            ax += side.X;
            ay += side.Y;
            az += side.Z;
        }

        // A ball without spin does not start to spin in flight.
        spinRate = spin != 0 ? -decay : 0;
    }

    /// <summary>Turns the seams with the ball, if a side force depends on them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Begin<TAir>(ref TAir air, in BallState start, out SeamAxes seams)
        where TAir : struct, IFlightLaws
    {
        Unsafe.SkipInit(out seams);
        if (air.HasSide)
        {
            air.Begin(in start, out seams);
        }
    }

    /// <summary>Computes the rates at a single point.</summary>
    /// <param name="air">The air.</param>
    /// <param name="at">The ball: position, time, axis of the spin and branch of the drag law.</param>
    /// <param name="upward">The upward acceleration by gravity and buoyancy.</param>
    /// <param name="u">The velocity relative to the steady wind.</param>
    /// <param name="spin">The magnitude of the spin.</param>
    /// <param name="acceleration">The acceleration.</param>
    /// <param name="spinRate">The rate of change of the spin.</param>
    [SkipLocalsInit]
    public static void Of<TAir>(
        ref TAir air, in BallState at, double upward, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TAir : struct, IFlightLaws
    {
        Vector3d n = at.Flight.Axis;
        Begin(ref air, in at, out SeamAxes seams);
        At(
            ref air, in at, in seams, at.Branch, upward, 0, 0, 0, 0, 0, n.X, n.Y, n.Z, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate, out _);
        acceleration = new Vector3d(ax, ay, az);
    }
}
