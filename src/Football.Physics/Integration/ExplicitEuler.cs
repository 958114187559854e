using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Explicit Euler, y' = y + h f(y) (thesis 3.7). Order 1.</summary>
internal readonly struct ExplicitEuler : IIntegrator
{
    public int Stages => 1;

    public bool LastStageAtEnd => false;

    public int Order => 1;

    public Tableau Tableau => new([0], [1]);

    public double ShareInPath => 0;

    public bool GainsByHops => true;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        double ux = motion.Velocity.X - wind.X;
        double uy = motion.Velocity.Y - wind.Y;
        double uz = motion.Velocity.Z - wind.Z;
        double w = motion.SpinRate;

        // k = f(y)
        FlightRates.At(
            ref air, in start, branch, upward, 0, 0, 0, 0, 0, motion.Axis.X, motion.Axis.Y, motion.Axis.Z, ux, uy, uz, w,
            out double ax, out double ay, out double az, out double b, out double s);

        // y' = y + h k; the velocity at the start advances the position.
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
        step.Path = new Vector3d(h * ux, h * uy, h * uz);
        step.Turn = h * w;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        step.StartRates = start;
        step.End = from.After(h, in from.Velocity, in step.StartRates);
        step.Rotation = h * from.Spin;
    }
}
