using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>The part of a flight step that both Euler methods share: v' = v + h a and |ω|' = |ω| + h |ω|˙, with the rates at the start.</summary>
internal static class EulerStep
{
    /// <summary>Advances the velocity and the spin rate; sets all of the step but its path and its turn.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Take<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        FlightRates.Begin(ref air, in start, out SeamAxes seams);
        double ux = motion.Velocity.X - wind.X;
        double uy = motion.Velocity.Y - wind.Y;
        double uz = motion.Velocity.Z - wind.Z;
        double w = motion.SpinRate;
        FlightRates.At(
            ref air, in start, in seams, branch, upward, 0, 0, 0, 0, 0, motion.Axis.X, motion.Axis.Y, motion.Axis.Z, ux, uy, uz, w,
            out double ax, out double ay, out double az, out double b, out double s);
        double ex = ux + (h * ax);
        double ey = uy + (h * ay);
        double ez = uz + (h * az);
        double ew = w + (h * b);
        motion.Velocity = new Vector3d(ex + wind.X, ey + wind.Y, ez + wind.Z);
        motion.SpinRate = ew;
        step = default;
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;
        step.AirDistance = air.HasSide ? h * s : 0;
        step.AirVelocity = new Vector3d(ex, ey, ez);
        step.SpinRate = ew;
    }
}
