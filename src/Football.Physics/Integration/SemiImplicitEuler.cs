using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Semi-implicit (symplectic) Euler, order 1 (thesis 3.8, 3.9): velocity first, then position with the new velocity.</summary>
internal readonly struct SemiImplicitEuler : IIntegrator
{
    public int Stages => 1;

    public bool LastStageAtEnd => false;

    public int Order => 1;

    public Tableau Tableau => new([0], [1], movesWithEnd: true);

    public double ShareInPath => 1;

    public bool GainsByHops => false;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        double ux = motion.Velocity.X - wind.X;
        double uy = motion.Velocity.Y - wind.Y;
        double uz = motion.Velocity.Z - wind.Z;
        double w = motion.SpinRate;
        FlightRates.At(
            ref air, in start, branch, upward, 0, 0, 0, 0, 0, motion.Axis.X, motion.Axis.Y, motion.Axis.Z, ux, uy, uz, w,
            out double ax, out double ay, out double az, out double b, out double s);

        // v' = v + h a(v); the new velocity advances the position, p' = p + h v'.
        double ex = ux + (h * ax);
        double ey = uy + (h * ay);
        double ez = uz + (h * az);
        double ew = w + (h * b);
        motion.Velocity = new Vector3d(ex + wind.X, ey + wind.Y, ez + wind.Z);
        motion.SpinRate = ew;
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;
        step.AirDistance = air.HasField ? h * s : 0;
        step.AirVelocity = new Vector3d(ex, ey, ez);
        step.SpinRate = ew;
        step.Path = new Vector3d(h * ex, h * ey, h * ez);
        step.Turn = h * ew;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        step.StartRates = start;

        // Update the velocity first, then the position with the new velocity.
        Vector3d velocity = from.Velocity + (h * step.StartRates.Acceleration);
        step.End = from.After(h, in velocity, in step.StartRates);
        step.Rotation = h * step.End.Spin;
    }
}
